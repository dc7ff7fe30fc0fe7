"""Images that are there twice, byte for byte."""

import hashlib
from collections.abc import Collection
from pathlib import Path

import numpy as np

from vpr_bench.dataset.folders import cache_root
from vpr_bench.dataset.lint.finding import Finding, listed, share
from vpr_bench.dataset.load import Case
from vpr_bench.files.digest_cache import sha256_of_files
from vpr_bench.types.traverse import Traverse


def find_given_away(case: Case, unreadable: Collection[Path]) -> list[Finding]:
    """Find queries that lie among the references too: whoever compares bytes, or features, has their answer."""
    known = {digest: index for index, digest in _digests(case.references, unreadable).items()}
    twins = [
        f"{case.queries.name_of(index)} is {case.references.name_of(known[digest])}"
        for index, digest in _digests(case.queries, unreadable).items()
        if digest in known
    ]
    if not twins:
        return []
    message = (
        "byte for byte a reference, which gives the answer away: "
        f"{share(len(twins), len(case.queries), 'query')}: {listed(twins)}"
    )
    return [Finding("duplicate", "error", case.protocol.pairing, message)]


def find_repeated(traverse: Traverse, unreadable: Collection[Path]) -> list[Finding]:
    """Find images of a traverse that repeat an earlier one."""
    first: dict[str, int] = {}
    twins = []
    for index, digest in _digests(traverse, unreadable).items():
        original = first.setdefault(digest, index)
        if original != index:
            twins.append(f"{traverse.name_of(index)} is {traverse.name_of(original)}")
    if not twins:
        return []
    message = f"byte for byte an earlier image: {share(len(twins), len(traverse), 'image')}: {listed(twins)}"
    return [Finding("duplicate", "warning", traverse.name, message)]


def _digests(traverse: Traverse, unreadable: Collection[Path]) -> dict[int, str]:
    """Return the digest of each image by its index; damaged ones are left out, since all empty files are alike."""
    digests, files = {}, {}
    for index, source in enumerate(traverse.sources):
        if isinstance(source, np.ndarray):
            digests[index] = f"sha256:{hashlib.sha256(source.tobytes()).hexdigest()}"
        elif source not in unreadable:
            files[index] = source
    digests |= zip(files, sha256_of_files(files.values(), cache_root() / "digests"), strict=True)
    return dict(sorted(digests.items()))
