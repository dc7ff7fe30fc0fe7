"""Getting the real images of a dataset, and checking them."""

from pathlib import Path

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.editions import find_images, search
from vpr_bench.dataset.folders import data_root
from vpr_bench.dataset.known import known_digest, remember_digest, vouched_digest
from vpr_bench.dataset.load import load_traverse
from vpr_bench.download import extract_archive, fetch_archive
from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.progress import track

_AWAY = "It is never replaced: move it away, then fetch again."


def fetch_images(card: Card) -> Path:
    """Download a dataset into the data root unless it is there; return the folder that holds its traverses.

    Raises
    ------
    DataError
        If the dataset cannot be downloaded automatically, the download fails, or what arrives is incomplete or
        not the copy that the card knows; nothing is left in the data root then. If what is there already is
        incomplete or something else: nothing of the user's is ever replaced.
    """
    found = find_images(card)
    if found is not None:
        for fault in verify_images(card, found, card.id):
            raise type(fault)(f"What is there of {card.id} is not it: {fault}\n{_AWAY}")
        return found
    if card.download is None:
        obtain = card.obtain or f"Get it from {card.homepage}."
        raise DataError(f"{card.id} cannot be downloaded automatically. {obtain}")

    inner = card.download.inner

    def check(folder: Path) -> None:
        if inner:
            _unpack_inner(folder, inner)
        traverses = search(folder, card)
        if traverses is None:
            raise DataError(f"The archive holds none of the traverse folders of {card.id}.")
        for fault in verify_images(card, traverses, card.id):
            raise DataError(f"The archive is not {card.id} as the card knows it: {fault}")

    folder = data_root() / card.id
    url = card.download.url
    expected = card.download.sha256 or known_digest(url)
    fetch_archive(url, folder, sha256=expected, check=check, record=lambda found: remember_digest(url, found, folder))
    traverses = search(folder, card)
    if traverses is None:  # it was there before, and so nothing was fetched
        raise DataError(f"{folder} holds none of the traverse folders of {card.id}. {_AWAY}")
    return traverses


def _unpack_inner(folder: Path, name: str) -> None:
    found = sorted(path for path in folder.rglob(name) if path.is_file())
    if len(found) != 1:
        raise DataError(f"The archive should hold one {name}: found {len(found)}.")
    archive = found[0].rename(found[0].with_name(f".{name}"))  # which may have no ending to tell the folder by
    extract_archive(archive, archive.with_name(Path(name).stem))
    archive.unlink()


def accept_images(card: Card, folder: Path, source: str) -> None:
    """Record the digests of what is there as those that it should have, where the card itself knows none.

    Raises
    ------
    DataError
        If a traverse is incomplete or its record cannot be written.
    """
    for one in card.traverses:
        if one.digest is None:
            digest = traverse_digest(load_traverse(card, one, folder).traverse, afresh=True)
            remember_digest(f"{source}/{one.name}", digest, folder / one.path)


def verify_images(card: Card, folder: Path, source: str | None) -> list[VprBenchError]:
    """Check every traverse: complete, every image decodes, and the digest is the card's or that of first contact.

    Parameters
    ----------
    card : Card
        The dataset, in its edition.
    folder : Path
        Holds the traverses.
    source : str, optional
        Dataset with its edition; None for the user's own images, of which no record is kept.

    Returns
    -------
    list of VprBenchError
        What is wrong; empty if all is well. What is missing or damaged is a :class:`DataError`; another copy
        than the known one is not. Images are decoded only where the digest does not vouch for them.
    """
    faults: list[VprBenchError] = []
    for one in card.traverses:
        try:
            traverse = load_traverse(card, one, folder).traverse
            digest = traverse_digest(traverse, afresh=True)
            expected, whose = vouched_digest(one, source)
            if expected == digest:
                continue
            for index in track(range(len(traverse)), f"Decoding {one.name}"):
                traverse[index]
        except DataError as error:
            faults.append(error)
            continue
        if expected is not None:
            where = folder / one.path
            faults.append(VprBenchError(f"{where} is not the copy that {whose}: expected {expected}, found {digest}."))
    return faults
