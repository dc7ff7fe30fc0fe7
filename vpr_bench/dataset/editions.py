"""Where the images of a dataset come from: the real ones on disk, or the project's own simulated ones."""

import shutil
import tempfile
from pathlib import Path
from typing import Protocol

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.folders import cache_root, data_root
from vpr_bench.errors import DataError, UsageError, blaming
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.lock import held
from vpr_bench.importing import import_object


class Renderer(Protocol):
    """What a card's ``simulation.renderer`` makes from the card's ``simulation.options``."""

    def fingerprint(self) -> str:
        """Return a short text that changes whenever any rendered pixel does."""
        ...

    def render(self, folder: Path) -> None:
        """Write every traverse into an empty folder, in the real edition's layout."""
        ...


_DEPTH = 2  # archives nest the traverses in one folder, some in two
_DEBRIS = ("__MACOSX",)  # repeats an archive's folders without their images


def find_images(card: Card, edition: str = "real") -> Path | None:
    """Return the folder under the data root that holds an edition's traverse folders, or None.

    A folder that holds only some of them counts: a damaged dataset is an error, not a missing one.
    """
    root = data_root()
    names = next((one.folders for one in card.editions if one.name == edition), [card.id, *card.folders])
    for name in names:
        found = search(root / name, card.in_edition(edition))
        if found is not None:
            return found
    return None


def search(folder: Path, card: Card, depth: int = _DEPTH) -> Path | None:
    """Return the folder that holds the traverse folders: this one, or one nested in it; None if there is none."""
    if not folder.is_dir():
        return None
    if any((folder / traverse.path).is_dir() for traverse in card.traverses):
        return folder
    if depth == 0:
        return None
    for inner in sorted(path for path in folder.iterdir() if path.is_dir() and path.name not in _DEBRIS):
        found = search(inner, card, depth - 1)
        if found is not None:
            return found
    return None


def choose_edition(card: Card, asked: str) -> str:
    """Return the name of the edition to use; nothing is rendered yet.

    Parameters
    ----------
    card : Card
        The dataset.
    asked : str
        ``real``, ``simulated``, another edition of the card, or ``auto``: ``real`` where the images are on disk,
        else ``simulated``; it is never downloaded unasked.

    Raises
    ------
    UsageError
        If there is no such edition.
    DataError
        If real images are needed and are not on disk.
    """
    known = ["auto", *card.edition_names()]
    if asked not in known:
        raise UsageError(f"The edition of {card.id} must be one of {', '.join(known)}. Got {asked!r} instead.")
    wanted = "real" if asked == "auto" else asked
    if wanted != "simulated" and find_images(card, wanted) is None:
        if asked == "auto" and card.simulation is not None:
            return "simulated"
        raise DataError(_missing(card, wanted))
    return wanted


def _missing(card: Card, edition: str) -> str:
    """Say what to do about an edition of real images that is not on disk."""
    named = next((one.folders for one in card.editions if one.name == edition), [card.id])
    if edition == "real":
        what, how = "real images", f"`vpr-bench data fetch {card.id}` fetches them or says how to get them; or "
    else:
        what, how = f"{edition} images", f"Put them into a folder {named[0]} there, or "
    return f"The {what} of {card.id} are not under {data_root()}. {how}set VPR_BENCH_DATA to the folder that has them."


def edition_folder(card: Card, edition: str, *, render: bool = True) -> Path:
    """Return the folder that holds the traverses of an edition that :func:`choose_edition` chose.

    Parameters
    ----------
    card : Card
        The dataset.
    edition : str
        Never ``auto``.
    render : bool
        Render the simulated edition if it is not here yet.

    Raises
    ------
    DataError
        If the images have gone meanwhile, or the simulated ones cannot be rendered, or must not be.
    """
    if edition == "simulated":
        return _rendered(card, render)
    found = find_images(card, edition)
    if found is None:
        raise DataError(_missing(card, edition))
    return found


def _rendered(card: Card, render: bool) -> Path:
    """Return the folder of the simulated edition; render it once, whole or not at all."""
    assert card.simulation is not None  # noqa: S101
    make = import_object(card.simulation.renderer, f"The renderer of {card.id}")
    with blaming(f"The renderer of {card.id} refuses the card's description", DataError):
        renderer: Renderer = make(card.simulation.options)
    folder = cache_root() / "simulated" / f"{card.id}-{renderer.fingerprint()}"
    if folder.is_dir():
        return folder
    if not render:
        raise DataError(
            f"the simulated images of {card.id} have not been rendered on this machine: "
            f"`vpr-bench data preview {card.id}:simulated` does."
        )
    lock = folder.with_name(folder.name + ".lock")
    with held(lock, f"Waiting for another process that renders {card.id}"):
        if not folder.is_dir():
            with blaming(f"The simulated images of {card.id} cannot be rendered", DataError), disk_errors(folder):
                _render_into(renderer, folder)
    return folder


def _render_into(renderer: Renderer, folder: Path) -> None:
    for leftover in folder.parent.glob(f"{folder.name}.partial-*"):  # of a killed process: we hold the lock
        shutil.rmtree(leftover, ignore_errors=True)
    partial = Path(tempfile.mkdtemp(prefix=f"{folder.name}.partial-", dir=folder.parent))
    try:
        renderer.render(partial)
        partial.chmod(0o755)
        partial.replace(folder)
    except BaseException:
        shutil.rmtree(partial, ignore_errors=True)
        raise
