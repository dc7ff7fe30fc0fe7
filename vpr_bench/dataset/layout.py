"""How images and places lie on disk. A layout is a plug-in: our own come through the same door as anybody's."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError, blaming
from vpr_bench.registry import Registry
from vpr_bench.types.ground_truth import GroundTruth


@dataclass(frozen=True)
class Recognised:
    """What a layout found in a folder that nobody has described yet.

    Attributes
    ----------
    found : str
        What it is, in one line for a person: counts, and what the places are taken from.
    unit : str
        Unit of the place labels.
    options : dict
        What the layout needs to know to load it again.
    traverses : list of dict
        One :class:`~vpr_bench.dataset.card.TraverseCard` each.
    protocols : list of dict
        One :class:`~vpr_bench.dataset.card.ProtocolCard` each, the default first.
    given : list of dict
        One :class:`~vpr_bench.dataset.card.GivenCard` each.
    """

    found: str
    unit: str
    traverses: list[dict[str, Any]]
    protocols: list[dict[str, Any]]
    options: dict[str, Any] = field(default_factory=dict)
    given: list[dict[str, Any]] = field(default_factory=list)


@dataclass(frozen=True)
class Layout:
    """One way in which images and places lie on disk.

    Attributes
    ----------
    about : str
        What it is, in one line.
    load : callable
        ``load(folder, card, **options)`` returns the :class:`Recording` of one traverse: ``folder`` is the
        traverse's own, ``card`` its :class:`~vpr_bench.dataset.card.TraverseCard`. Nothing is decoded.
    given : callable, optional
        ``given(folder, references, queries, **options)`` returns the :class:`GroundTruth` that a file in the
        dataset's folder lists for two recordings.
    recognise : callable, optional
        ``recognise(folder)`` says what lies in a folder, None if it is not of this layout.
    rank : int
        Of two layouts that recognise a folder, the one of higher rank is taken: the more specific one.
    """

    about: str
    load: Callable[..., Recording]
    given: Callable[..., GroundTruth] | None = None
    recognise: Callable[[Path], Recognised | None] | None = None
    rank: int = 0


LAYOUTS: Registry[Layout] = Registry("vpr_bench.layouts", "layout", Layout)


def find_layout(name: str) -> Layout:
    """Return a layout by its name.

    Raises
    ------
    UsageError
        If there is no such layout; the closest one is suggested.
    """
    return LAYOUTS.find(name)


def recognise(folder: Path, only: str | None = None) -> list[tuple[str, Recognised]]:
    """Return what the layouts say about a folder, by the name of the layout, the most specific one first.

    Parameters
    ----------
    folder : Path
        Holds the images.
    only : str, optional
        Ask this layout alone.

    Raises
    ------
    UsageError
        If there is no such layout.
    DataError
        If the folder is of a layout and broken, and no more specific layout recognises it.
    """
    layouts = LAYOUTS.load_all() if only is None else {only: find_layout(only)}
    said: list[tuple[str, Recognised]] = []
    for name, layout in sorted(layouts.items(), key=lambda item: (-item[1].rank, item[0])):
        if layout.recognise is None:
            continue
        try:
            with blaming(f"The layout {name!r} failed on {folder}", DataError):
                recognised = layout.recognise(folder)
        except DataError:
            if not said:
                raise
            continue
        if recognised is not None:
            said.append((name, recognised))
    return said
