"""What a user writes to name a dataset, an edition, or a protocol."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from vpr_bench.dataset.card import DATASETS
from vpr_bench.errors import DataError, UsageError
from vpr_bench.types.protocol import Protocol, Unmatched


@dataclass(frozen=True)
class Request:
    """What was asked for on the command line, before anything is looked up."""

    dataset: str
    pairing: str | None
    edition: str
    unmatched: Unmatched | None = None

    @classmethod
    def parse(cls, text: str, pairing: str | None = None, edition: str = "auto") -> "Request":
        """Read ``gardens``, ``gardens:simulated``, ``gardens/day_left-day_right``, a whole protocol id, or a folder.

        Raises
        ------
        UsageError
            If the edition or protocol is given twice and differently.
        """
        if own_folder(text) is not None:
            return cls(text, pairing, edition)
        source, slash, rest = text.partition("/")
        dataset, colon, named = source.partition(":")
        unmatched = None
        if "@" in rest:
            whole = Protocol.parse(text)
            rest, unmatched = f"{whole.pairing}@{whole.reach}", whole.unmatched
            named, colon = whole.edition, ":"
        if colon:
            if edition not in ("auto", named):
                raise UsageError(f"{text!r} names the edition {named!r}, but --edition says {edition!r}.")
            edition = named
        if slash:
            if pairing not in (None, rest):
                raise UsageError(f"{text!r} names the protocol {rest!r}, but --protocol says {pairing!r}.")
            pairing = rest
        return cls(dataset, pairing, edition, unmatched)


def own_folder(text: str) -> Path | None:
    """Return the folder that a user names in place of a dataset, None if it is the name of a dataset.

    A folder is what begins with ``.``, ``/`` or ``~``, and any other path to a folder whose first part is not the
    name of a dataset.

    Raises
    ------
    DataError
        If it looks like a folder and is none.
    """
    path = Path(os.path.expanduser(text))  # noqa: PTH111 - Path's raises where there is no such user
    marked = text.startswith((".", "~")) or path.is_absolute()
    if not marked:
        named = re.split("[/:]", text)[0]
        if not path.is_dir() or any(entry.name == named for entry in DATASETS.entries()):
            return None
    if not path.is_dir():
        raise DataError(f"There is no folder {path}. A dataset is named by its id or by an existing folder.")
    return path.resolve()
