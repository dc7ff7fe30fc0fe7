"""Stored runs with made-up answers: 200 queries on 200 places, of which about 70 % are answered right."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.gate.verdict import Judgement
from vpr_bench.runner.machine import Machine
from vpr_bench.runner.provenance import Provenance
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.store import RunStore, StoredRun

N, K = 200, 5
PROTOCOL = "gardens/day_left-day_right@0f"
DIGEST = "sha256:" + "0" * 64


def made_up(n=N, seed=0):
    """Return (n, 5) ranked references and scores; query ``i`` shows place ``i``."""
    random = np.random.default_rng(seed)
    others = (np.arange(n)[:, None] + random.integers(1, 9, (n, 1)) * np.arange(1, K)) % n
    indices = np.concatenate([np.arange(n)[:, None], others], axis=1)
    wrong = random.random(n) > 0.7
    indices[wrong] = np.roll(indices[wrong], 1, axis=1)
    scores = np.sort(random.random((n, K)), axis=1)[:, ::-1] - 0.3 * wrong[:, None]
    return indices, scores


def shifted(indices, queries):
    """Return the answers with the best one of some queries replaced by the reference 30 places on."""
    moved = indices.copy()
    moved[queries, 0] = (moved[queries, 0] + 30) % len(indices)
    return moved


MACHINE = Machine(system="Linux-6", processor="P", cores=4, threads=2, python="3", libraries={"vpr-bench": "0.1.0"})


@pytest.fixture
def store(tmp_path) -> Callable[..., StoredRun]:
    """Write a run below ``runs`` in the test's folder and open it."""

    def write(indices=None, scores=None, *, root=tmp_path / "runs", total=0.03, unasked=0, **facts) -> StoredRun:
        if indices is None:
            indices, scores = made_up()
        n = len(indices)
        protocol, label = facts.pop("protocol", PROTOCOL), facts.pop("label", "made-up")
        source, _, rest = protocol.partition("/")
        key = {
            "source": source,
            "pairing": rest.partition("@")[0],
            "dataset_digest": DIGEST,
            "method": label.partition("(")[0],
            "version": "1",
            "parameters": {"size": 8, "seed": 0},
            "weights": None,
            "seed": 0,
            "k": K,
            "limit": None,
            "threads": 2,
        }
        key = RunKey(**{name: facts.pop(name, value) for name, value in key.items()})
        where = RunStore(root).folder(key)
        where.mkdir(parents=True)
        matches = {"queries": np.arange(n), "indices": indices, "scores": np.asarray(scores, np.float32)}
        write_arrays(where / "matches.npz", matches)
        seconds = {"seconds.encode": np.full(n, total / 2), "seconds.total": np.full(n, total)}
        write_arrays(where / "timings.npz", seconds)
        places = np.arange(float(n))
        queries = np.where(places >= n - unasked, 10**6, places)  # the last ones show no place of the map
        write_arrays(where / "labels.npz", {"queries": queries, "references": places})
        record = RunRecord(
            key=key,
            protocol=protocol,
            label=label,
            n_references=n,
            n_queries=n,
            partial=key.limit is not None,
            resumed=False,
            fit_seconds=1.0,
            peak_memory={},
            machine=facts.pop("machine", MACHINE),
            provenance=Provenance(elsewhere=facts.pop("elsewhere", 0.0)),
            created=facts.pop("created", "2026-01-01T00:00:00+00:00"),
            files={file.name: sha256_of_file(file) for file in where.glob("*.npz")},
        )
        assert not facts, facts
        write_bytes(where / "run.json", record.model_dump_json().encode())
        return StoredRun.open(where)

    return write


@pytest.fixture
def made_up_answers():
    return made_up


@pytest.fixture
def shift():
    return shifted


@pytest.fixture
def machine() -> Machine:
    return MACHINE


HOSTILE = "<script>alert(1)</script>|`*_[x](y)\x1b[31m\x00\n# big\ud800&amp;\"'"


@pytest.fixture
def hostile() -> str:
    """Return a name that tries to be markup."""
    return HOSTILE


@pytest.fixture
def failing(store, tmp_path) -> Judgement:
    """Return a judgement with a cell that fails, one that passes, one without a run, and a run without a cell."""
    from vpr_bench.gate import Baseline, judge, record_cell

    indices, scores = made_up()
    names = ("fails", "passes", "absent")
    old = [store(label=name, root=tmp_path / "old") for name in names]
    runs = [
        store(shifted(indices, np.arange(0, 40)), scores, label="fails"),
        store(label="passes"),
        store(label="fresh"),
    ]
    judged = judge(Baseline().with_cells(map(record_cell, old)), runs)
    names = {query: f"day_right/Image{query:03d}.jpg" for query in judged.verdicts[1].lost}
    return replace(judged, verdicts=[replace(one, names=names) for one in judged.verdicts])


@pytest.fixture
def elsewhere(tmp_path) -> Path:
    return tmp_path / "old"
