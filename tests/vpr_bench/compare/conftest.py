"""Stored runs with hand-made answers, to be compared."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.runner.machine import Machine
from vpr_bench.runner.provenance import Provenance
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.store import StoredRun

N_PLACES = 8
QUIET = Provenance(elsewhere=0.01)
MACHINE = Machine(
    system="Linux-6", processor="One", cores=2, threads=2, memory_bytes=2**33, python="3.11", libraries={}
)


def ranked(first, k=3):
    """(n, k) references whose best ones are given; -1 stands for no answer."""
    first = np.asarray(first)
    rows = (first[:, None] + np.arange(k)) % N_PLACES
    rows[first < 0] = -1
    return rows


@dataclass
class Answered:
    """What a run is made of; eight queries on eight places, one frame apart, unless said otherwise."""

    first: list = field(default_factory=lambda: list(range(N_PLACES)))
    label: str = "hog"
    protocol: str = "gardens/day_left-night_right@0f"
    queries: list | None = None
    labels: dict | None = None
    seconds: dict | None = None
    scores: list | None = None
    digest: str = "0"
    limit: int | None = None
    k: int = 3
    machine: Machine = MACHINE
    provenance: Provenance = QUIET
    record: dict = field(default_factory=dict)
    folder: str = ""

    def arrays(self):
        indices = ranked(self.first, self.k)
        best = np.linspace(0.9, 0.2, len(indices)) if self.scores is None else np.array(self.scores)
        scores = np.where(indices < 0, -np.inf, best[:, None] - 0.01 * np.arange(self.k))
        queries = np.arange(len(indices)) if self.queries is None else np.array(self.queries)
        seconds = {"decode": 0.5, "encode": 0.02, "total": 0.03} if self.seconds is None else self.seconds
        columns = {f"seconds.{name}": np.broadcast_to(value, len(indices)) for name, value in seconds.items()}
        places = {"queries": np.arange(float(N_PLACES)), "references": np.arange(float(N_PLACES))}
        return {
            "matches.npz": {"queries": queries, "indices": indices, "scores": scores.astype(np.float32)},
            "timings.npz": columns,
            "labels.npz": places if self.labels is None else self.labels,
        }


@pytest.fixture
def stored(tmp_path):
    """Write a run; every call one more."""

    def make(**changes):
        one = Answered(**changes)
        number = len(list(tmp_path.rglob("run.json")))
        folder = tmp_path / (one.folder or f"run{number}")
        folder.mkdir(parents=True)
        for name, content in one.arrays().items():
            write_arrays(folder / name, content)
        source, _, rest = one.protocol.partition("/")
        key = RunKey(
            source=source,
            pairing=rest.partition("@")[0],
            dataset_digest="sha256:" + one.digest * 64,
            method=one.label,
            version="1",
            parameters={},
            weights=None,
            seed=0,
            k=one.k,
            limit=one.limit,
            threads=one.machine.threads,
        )
        content = {
            "key": key,
            "protocol": one.protocol,
            "label": one.label,
            "n_references": N_PLACES,
            "n_queries": len(one.first),
            "partial": one.limit is not None,
            "resumed": False,
            "fit_seconds": 1.5,
            "peak_memory": {"fit": 10, "match": 20},
            "machine": one.machine,
            "provenance": one.provenance,
            "created": f"2024-01-01T00:00:00.run{number}",
            "files": {name: sha256_of_file(folder / name) for name in one.arrays()},
        }
        record = RunRecord(**{**content, **one.record})
        write_bytes(folder / "run.json", record.model_dump_json().encode())
        return StoredRun.open(folder)

    return make


@pytest.fixture
def pair_of_runs(stored):
    """A is right on queries 0 to 3, B on 2 to 6, at radius 0."""
    return stored(first=[0, 1, 2, 3, 0, 0, 0, 0], label="hog"), stored(first=[5, 5, 2, 3, 4, 5, 6, 0], label="sad")
