"""What to do about a folder that no layout recognises."""

from contextlib import suppress
from pathlib import Path

from vpr_bench.dataset.layout import LAYOUTS, recognise
from vpr_bench.errors import VprBenchError, blaming
from vpr_bench.files.disk import disk_errors
from vpr_bench.types.image import SUFFIXES

_TRIED = 20
"""Folders inside that are looked at, in case one of them is meant."""


def unrecognised(folder: Path, layout: str | None = None, others: list[str] | None = None) -> str:
    """Say what is in a folder, what the layouts need, and which other folder may be meant.

    Parameters
    ----------
    folder : Path
        That was not recognised.
    layout : str, optional
        As which it was not.
    others : list of str, optional
        The layouts that do recognise it.
    """
    known = {name: one.about for name, one in LAYOUTS.load_all().items() if one.recognise is not None}
    if layout is not None and others:
        return (
            f"{folder} is not of the layout {layout!r} ({known.get(layout, '')}), but of {' and '.join(others)}.\n"
            f"Leave out --layout, or say --layout {others[0]}."
        )
    direct, inner = _images_in(folder), _folders_of_images(folder)
    holds = [_counted(direct, "image")] if direct else []
    holds += (
        [", ".join(f"{name} ({_counted(count, 'image')})" for name, count in [*inner.items()][:4])] if inner else []
    )
    more = f" and {len(inner) - 4} more folders" if len(inner) > 4 else ""
    as_what = f" as {layout!r}" if layout else ""
    lines = [f"{folder} is not recognised{as_what}: it holds {' and '.join(holds) or 'no images'}{more}."]
    meant = _meant(folder, direct > 0 and not inner)
    if meant is not None:
        return f"{lines[0]}\nDid you mean {meant}? That one is."
    lines.append("A benchmark needs a map and queries to look up in it, and must know where each was taken. Layouts:")
    width = max(map(len, known), default=0)
    lines += [f"  {name:{width}}  {about}" for name, about in known.items() if layout in (None, name)]
    return "\n".join([*lines, "Arrange the images in one of these ways, or describe them in a card: docs/own_data.md."])


def _meant(folder: Path, above: bool) -> Path | None:
    """Return a folder inside, or the one around, that a layout recognises."""
    with disk_errors(folder, "read"):
        inner = sorted(one for one in folder.iterdir() if one.is_dir() and not one.name.startswith("."))
    for one in [*inner[:_TRIED], *([folder.parent] if above and folder.parent != folder else [])]:
        with suppress(VprBenchError), blaming("Looking around"):
            if recognise(one):
                return one
    return None


def _folders_of_images(folder: Path) -> dict[str, int]:
    with disk_errors(folder, "read"):
        counts = {one.name: _images_in(one) for one in sorted(folder.iterdir()) if one.is_dir()}
    return {name: count for name, count in counts.items() if count}


def _images_in(folder: Path) -> int:
    with disk_errors(folder, "read"):
        return sum(one.suffix.lower() in SUFFIXES and not one.name.startswith(".") for one in folder.iterdir())


def _counted(count: int, noun: str) -> str:
    return f"{count:,} {noun}{'s' * (count != 1)}"
