"""Where runs lie on disk: ``runs/<dataset>/<references>-<queries>/<method>/<hash>/``."""

import itertools
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DamagedError, DataError, blaming
from vpr_bench.files.atomic import read_arrays
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.files.lock import held
from vpr_bench.files.swap import recover, swap_in
from vpr_bench.runner.answers import SECONDS
from vpr_bench.runner.record import RunKey, RunRecord, read_record
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.survivors import Survivors, from_arrays

RECORD, MATCHES, TIMINGS, LABELS = "run.json", "matches.npz", "timings.npz", "labels.npz"
SHORTLISTS = "shortlists.npz"
"""Only there if the method noted any."""

_REDO = "`vpr-bench run` with the same method and dataset does the run again."


class StoreWarning(UserWarning):
    """Something on disk is not as it was left."""


@dataclass(frozen=True, eq=False)
class StoredRun:
    """A complete run on disk; its arrays are read when they are asked for.

    Attributes
    ----------
    folder : Path
        Holds ``run.json``, ``matches.npz``, ``timings.npz`` and ``labels.npz``, perhaps ``shortlists.npz``.
    record : RunRecord
        What it is.
    """

    folder: Path
    record: RunRecord

    @classmethod
    def open(cls, folder: Path) -> "StoredRun":
        """Open a run and check its files against their digests.

        Raises
        ------
        DamagedError
            If something is missing or not as it was written; of a folder with the name that a store gives, also if the
            name is not the hash of the run's key.
        DataError
            If it was written by a version with another schema, or cannot be read.
        """
        record = read_record(folder / RECORD)
        for name, digest in record.files.items():
            if not (folder / name).is_file():
                raise DamagedError(f"{folder / name} is missing. {_REDO}")
            if sha256_of_file(folder / name) != digest:
                raise DamagedError(f"{folder / name} is damaged: it is not what run.json recorded. {_REDO}")
        found = record.key.digest()
        if re.fullmatch("[0-9a-f]{12}", folder.name) and folder.name != found:
            raise DamagedError(f"{folder / RECORD} was edited: the hash of its key is {found}. {_REDO}")
        return cls(folder, record)

    @property
    def protocol(self) -> Protocol:
        """The protocol that the run was asked for."""
        return Protocol.parse(self.record.protocol)

    @cached_property
    def _matches(self) -> dict[str, NDArray[Any]]:
        return read_arrays(self.folder / MATCHES, "queries", "indices", "scores")

    @property
    def queries(self) -> NDArray[np.int64]:
        """(n,) int64: which queries were asked, ascending."""
        return self._matches["queries"].astype(np.int64, copy=False)

    @property
    def indices(self) -> NDArray[np.int64]:
        """(n, k) int64: ranked references per query, padded with -1."""
        return self._matches["indices"].astype(np.int64, copy=False)

    @property
    def scores(self) -> NDArray[np.float32]:
        """(n, k) float32: their scores, padded with -inf."""
        return self._matches["scores"].astype(np.float32, copy=False)

    @cached_property
    def places(self) -> Places:
        """The places of the queries that were asked, and of the references.

        Raises
        ------
        DataError
            If they cannot be read.
        """
        path = self.folder / LABELS
        with blaming(f"{path} is damaged", DataError):
            return Places.from_arrays(read_arrays(path)).take(self.queries)

    @cached_property
    def seconds(self) -> dict[str, NDArray[np.float64]]:
        """(n,) float64 seconds per stage: ``decode``, the method's own stages, and ``total`` without decode."""
        columns = read_arrays(self.folder / TIMINGS, SECONDS + "total")
        return {name.removeprefix(SECONDS): column for name, column in columns.items()}

    @cached_property
    def survivors(self) -> list[Survivors]:
        """What each step that the method noted left in the running, first step first; empty if it noted none.

        Raises
        ------
        DataError
            If they cannot be read.
        """
        if SHORTLISTS not in self.record.files:
            return []
        path = self.folder / SHORTLISTS
        with blaming(f"{path} is damaged", DataError):
            return from_arrays(read_arrays(path), len(self.queries), self.record.n_references)


@dataclass(frozen=True)
class RunStore:
    """All runs under one folder."""

    root: Path

    def folder(self, key: RunKey) -> Path:
        """Return where the run of this key lies, or will."""
        return self.root / _file_name(key.source) / key.pairing / _file_name(key.method) / key.digest()

    def find(self, key: RunKey) -> StoredRun | None:
        """Return the complete run of this key, None if there is none.

        Raises
        ------
        DataError
            If it is there and damaged.
        """
        folder = self.folder(key)
        return StoredRun.open(folder) if folder.exists() else None

    def folders(self) -> list[Path]:
        """Return the folders of all runs, whole or damaged, but for those being written or put aside."""
        folders = sorted(record.parent for record in self.root.glob(f"*/*/*/*/{RECORD}"))
        return [folder for folder in folders if "." not in folder.name]

    def runs(self) -> list[StoredRun]:
        """Return all complete runs, oldest first; damaged ones are left out with a warning."""
        found = []
        for folder in self.folders():
            try:
                found.append(StoredRun.open(folder))
            except DataError as error:
                warnings.warn(str(error), StoreWarning, stacklevel=2)
        return sorted(found, key=lambda run: (run.record.created, run.folder))

    @contextmanager
    def claim(self, key: RunKey) -> Iterator[Path]:
        """Hold the run against other processes and yield the folder to work in; wait while another holds it.

        Raises
        ------
        DataError
            If the store cannot be written to.
        """
        folder = self.folder(key)
        with held(folder.with_name(folder.name + ".lock"), "Waiting for another process that does the same run"):
            recover(folder)
            yield folder.with_name(folder.name + ".partial")

    def complete(self, key: RunKey) -> StoredRun:
        """Move the finished working folder into place, over an older run of the same key."""
        folder = self.folder(key)
        swap_in(folder.with_name(folder.name + ".partial"), folder)
        return StoredRun.open(folder)

    def put_aside(self, key: RunKey) -> Path:
        """Move a damaged run out of the way, without deleting anything; return where it is."""
        folder = self.folder(key)
        names = (folder.with_name(f"{folder.name}.damaged{number or ''}") for number in itertools.count())
        return folder.replace(next(aside for aside in names if not aside.exists()))


def _file_name(name: str) -> str:
    """Make a name that any system takes for one folder, whatever a plug-in is called; the hash keeps runs apart."""
    return re.sub(r"[^A-Za-z0-9_.-]", ".", name).strip(".") or "unnamed"
