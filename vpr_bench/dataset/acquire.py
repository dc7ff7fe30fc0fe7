"""Getting the real images of a dataset, and checking them."""

from pathlib import Path

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.editions import find_real, search
from vpr_bench.dataset.folders import data_root
from vpr_bench.dataset.load import load_traverse
from vpr_bench.download import fetch_archive
from vpr_bench.errors import DataError
from vpr_bench.progress import track


def fetch_images(card: Card) -> Path:
    """Download a dataset into the data root unless it is there; return the folder that holds its traverses.

    Raises
    ------
    DataError
        If the dataset cannot be downloaded automatically, the download fails, or what arrives is incomplete or
        not the copy that the card knows. Nothing is left in the data root then.
    """
    found = find_real(card)
    if found is not None:
        return found
    if card.download is None:
        raise DataError(f"{card.id} cannot be downloaded automatically. Get it from {card.homepage}.")

    def check(folder: Path) -> None:
        traverses = search(folder, card)
        faults = ["it holds none of the traverse folders"] if traverses is None else verify_images(card, traverses)
        if faults:
            raise DataError(f"What {card.download.url if card.download else ''} sent is not {card.id}: {faults[0]}")

    folder = data_root() / card.id
    fetch_archive(card.download.url, folder, sha256=card.download.sha256, check=check)
    return search(folder, card) or folder


def verify_images(card: Card, folder: Path) -> list[str]:
    """Check every traverse: complete, every image decodes, and the digest is the card's.

    Parameters
    ----------
    card : Card
        The dataset.
    folder : Path
        Holds the traverses.

    Returns
    -------
    list of str
        What is wrong, one line each; empty if all is well. Images are decoded only where the digest does not
        vouch for them.
    """
    faults = []
    for one in card.traverses:
        try:
            traverse, _, digest = load_traverse(card, one.name, "unverified", folder)
            if one.digest == digest:
                continue
            for index in track(range(len(traverse)), f"Decoding {one.name}"):
                traverse[index]
        except DataError as error:
            faults.append(str(error))
            continue
        if one.digest is not None:
            faults.append(f"{folder / one.path} is not the copy the card knows: expected {one.digest}, found {digest}.")
    return faults
