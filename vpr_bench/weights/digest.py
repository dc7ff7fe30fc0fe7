"""Whether weights are the right ones: the published digest decides, else the one that was met here first."""

from pathlib import Path

from vpr_bench.dataset.folders import cache_root
from vpr_bench.dataset.known import known_digest, remember_digest
from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.files.digest_cache import sha256_of_files
from vpr_bench.weights.card import WeightsCard
from vpr_bench.weights.place import find_file


class OtherWeightsError(VprBenchError):
    """Weights are not the ones that were met here first, and nobody can say which are right."""


def weights_digest(card: WeightsCard, *, afresh: bool = False, accept: bool = False) -> str:
    """Return ``sha256:…`` of the weights of a card, if they are the right ones.

    Where nobody publishes a digest, the first one of a file that can be read is recorded.

    Parameters
    ----------
    card : WeightsCard
        The weights.
    afresh : bool
        Read the file even if it was not touched since it was read last.
    accept : bool
        Take the file for the right one if nothing published speaks against it.

    Raises
    ------
    DataError
        If they are missing, or are not the ones that were published, or are no weights where none are published.
    OtherWeightsError
        If they are not the ones that were met here first.
    """
    path = find_file(card)
    digest = file_digest(path, afresh=afresh)
    check_published(card, digest, path)
    if card.url is None or published_digest(card):
        return digest
    known = known_digest(card.url)
    if known not in (None, digest) and not accept:
        raise OtherWeightsError(
            f"{path} is not the file that was met here first: expected {known}, found {digest}.\n"
            f"If it is the right one, say so with `vpr-bench weights verify {card.id} --accept`."
        )
    if known != digest:
        from vpr_bench.weights.checkpoint import load_checkpoint

        load_checkpoint(path)  # a first contact with a web page or half a file would speak against the right one
        remember_digest(card.url, digest, path.parent)
    return digest


def file_digest(path: Path, *, afresh: bool = False) -> str:
    """Return ``sha256:…`` of any file of weights, remembered as long as the file is not touched.

    Raises
    ------
    DataError
        If the file cannot be read.
    """
    return sha256_of_files([path], None if afresh else cache_root() / "digests")[0]


def published_digest(card: WeightsCard) -> str:
    """Return the digest that the card publishes, or its beginning; empty if it publishes none."""
    return card.sha256 or (f"sha256:{card.sha256_prefix}" if card.sha256_prefix else "")


def check_published(card: WeightsCard, digest: str, path: Path) -> None:
    """Compare a digest with the one that the card publishes, as far as it does.

    Raises
    ------
    DataError
        If it is another one.
    """
    expected = published_digest(card)
    if not digest.startswith(expected):
        again = "Reinstall its package." if card.packaged else f"Delete it, then `vpr-bench weights fetch {card.id}`."
        raise DataError(f"{path} is damaged or another file: its digest {digest} does not begin {expected}.\n{again}")
