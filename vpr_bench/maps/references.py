"""What a map is made of: a traverse of a dataset, or a folder of images; and finding the images again later."""

from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from vpr_bench.dataset.content import case_digest, traverse_digest
from vpr_bench.dataset.load import load_parts
from vpr_bench.dataset.recording import Recording
from vpr_bench.dataset.request import Request
from vpr_bench.dataset.source import Source
from vpr_bench.errors import DataError, UsageError, first_fault, one_line
from vpr_bench.files.images import some_listed
from vpr_bench.maps.record import Part
from vpr_bench.types.traverse import Traverse


@dataclass(frozen=True, eq=False)
class References:
    """Images for a map.

    Attributes
    ----------
    traverse : Traverse
        The images.
    part : Part
        What stands in ``map.json`` about them.
    base : Path
        The folder that their names are relative to.
    """

    traverse: Traverse
    part: Part
    base: Path


def of_dataset(
    dataset: str, references: str | None = None, protocol: str | None = None, edition: str = "auto"
) -> References:
    """Load the references of a dataset.

    Parameters
    ----------
    dataset : str
        Its id, with an edition (``gardens:simulated``), a whole protocol id, or a folder of one's own.
    references : str, optional
        A traverse, part of one (``summer.every10``), or several joined (``summer+winter``).
    protocol : str, optional
        The protocol whose references are meant; by default the dataset's first.
    edition : str
        As for :func:`~vpr_bench.dataset.load.load_case`.

    Raises
    ------
    UsageError
        If there is no such dataset, edition or traverse, or both ``references`` and ``protocol`` are given.
    DataError
        If images are missing or damaged.
    """
    request = Request.parse(dataset, protocol, edition)
    if references is not None and request.pairing is not None:
        raise UsageError(f"--references {references!r} and the protocol {request.pairing!r} say it twice: give one.")
    source = Source.find(request)
    if references is None:
        name = source.card.protocol(request.pairing, source.edition).references
    else:
        source.card.check_traverses(references)
        name = references
    recording, digest = load_parts(source.card, source.name, name, source.folder, foreign=source.foreign)
    own = None if source.own is None else str(source.own)
    return _references(recording, digest, source.folder, (source.card.id, own, source.edition, name))


def of_folder(folder: Path) -> References:
    """Take the images of a folder, in natural order, whatever places they show.

    Raises
    ------
    DataError
        If the folder is missing, or has no images.
    """
    folder = folder.expanduser().absolute()
    recording = Recording(Traverse(folder.name, some_listed(folder)))
    return _references(recording, traverse_digest(recording.traverse), folder, (None, str(folder), "real", folder.name))


def find_again(part: Part) -> References:
    """Return the images of a part of a map from where they were, or where the dataset is now.

    Raises
    ------
    UsageError, DataError
        If they are not there, or are others.
    """
    if part.dataset is None:
        found = of_folder(Path(part.folder or ""))
    else:
        found = of_dataset(part.folder or part.dataset, part.traverse, edition=part.edition)
    if found.part.names != part.names:
        raise DataError(f"{found.base} does not hold the images that the map was made of.")
    return found


def _references(
    recording: Recording, digest: str, base: Path, origin: tuple[str | None, str | None, str, str]
) -> References:
    dataset, folder, edition, traverse = origin
    labels = recording.labels
    places = None if labels is None else tuple(tuple(one) if labels.ndim > 1 else one for one in labels.tolist())
    names = tuple(_name(source, base) for source in recording.traverse.sources if isinstance(source, Path))
    try:
        part = Part(
            dataset=dataset,
            folder=folder,
            edition=edition,
            traverse=traverse,
            digest=case_digest([(recording, digest)]),
            names=names,
            places=places,
        )
    except ValidationError as error:
        raise DataError(f"{base} cannot stand in a map: {one_line(first_fault(error)):.300}.") from None
    return References(recording.traverse, part, base)


def _name(file: Path, base: Path) -> str:
    return file.relative_to(base).as_posix() if file.is_relative_to(base) else file.name
