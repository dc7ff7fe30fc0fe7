"""Getting weights from the internet into the folder of weights."""

from pathlib import Path

from vpr_bench.dataset.known import known_digest, remember_digest
from vpr_bench.download import download, sha256_of_file
from vpr_bench.errors import DataError
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.lock import held
from vpr_bench.weights.card import WeightsCard
from vpr_bench.weights.digest import check_published, published_digest, weights_digest
from vpr_bench.weights.place import find_file, weights_path

_LARGEST = 8_000_000_000  # bytes; no server may fill the disk


def fetch_weights(card: WeightsCard) -> Path:
    """Download weights unless they are here, and verify them; an interrupted download is continued.

    Returns
    -------
    Path
        The file. It appears when it is complete and the right one.

    Raises
    ------
    DataError
        If they cannot be had, come with a package that is not installed, or are not the ones that were published.
        What is here already is never replaced.
    OtherWeightsError
        If what is here already is not what was met here first.
    """
    path = weights_path(card)
    if card.url is not None and not path.is_file():
        with held(path.with_name(f".{path.name}.lock"), f"Waiting for another process that is fetching {path.name}"):
            if not path.is_file():
                _download(card, card.url, path)
                return path
    weights_digest(card)
    return find_file(card)


def _download(card: WeightsCard, url: str, path: Path) -> None:
    # Only a whole digest can be checked by who downloads: until more is known the file has another name.
    arrived = path.with_name(f".{path.name}.arrived")
    expected = card.sha256 or (None if published_digest(card) else known_digest(url))
    download(url, arrived, sha256=expected, max_bytes=_LARGEST)
    digest = expected or sha256_of_file(arrived)
    try:
        check_published(card, digest, arrived)
        if not published_digest(card):
            _check_content(url, arrived)
            remember_digest(url, digest, path.parent)
    except DataError:
        arrived.unlink(missing_ok=True)
        raise
    with disk_errors(path):
        arrived.replace(path)


def _check_content(url: str, arrived: Path) -> None:
    """Refuse what is no checkpoint, such as a web page that says that the file has moved."""
    from vpr_bench.weights.checkpoint import load_checkpoint

    try:
        load_checkpoint(arrived)
    except DataError as error:
        raise DataError(f"What came from {url} is refused. {error}") from None
