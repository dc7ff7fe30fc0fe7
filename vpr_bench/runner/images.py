"""The images and places that a result was made of, found again."""

from dataclasses import replace
from pathlib import Path

from vpr_bench.dataset.load import Case, load_case
from vpr_bench.errors import DataError
from vpr_bench.types.protocol import Protocol


class OtherImagesError(DataError):
    """The images, or the places for them, are not those that the result was made of.

    Attributes
    ----------
    recorded, found : str
        Digests of those it was made of, and of those that are here.
    folder : Path
        Holds those that are here.
    """

    def __init__(self, recorded: str, found: str, folder: Path) -> None:
        super().__init__(f"the images are others: {recorded} were recorded, {found} are in {folder}.")
        self.recorded, self.found, self.folder = recorded, found, folder


def case_of(protocol: Protocol, digest: str, dataset: str | None = None, *, render: bool = True) -> Case:
    """Load the images and places of a result, if they are those it was made of.

    Parameters
    ----------
    protocol : Protocol
        Of the result; the case has it, whatever a folder is called by now.
    digest : str
        ``sha256:…`` of the images and places.
    dataset : str, optional
        Where the images are, as for :func:`~vpr_bench.dataset.load.load_case`: a folder of one's own is not found by
        its name.
    render : bool
        Render simulated images that are not here yet; else they are missing.

    Raises
    ------
    OtherImagesError
        If they are others.
    UsageError
        If there is no such dataset or protocol.
    DataError
        If they are missing or damaged.
    """
    if dataset is None:
        case = load_case(str(protocol), render=render)
    else:
        case = load_case(dataset, f"{protocol.pairing}@{protocol.reach}", unmatched=protocol.unmatched, render=render)
    if case.digest != digest:
        raise OtherImagesError(digest, case.digest, case.folder)
    return replace(case, protocol=protocol)
