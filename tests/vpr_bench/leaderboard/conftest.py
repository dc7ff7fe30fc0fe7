"""Rows and stored runs made by hand: ten queries on ten places, with right and wrong answers as they are asked for."""

import dataclasses
import math

import numpy as np
import pytest

from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.leaderboard.entry import METRICS, Entry
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.runner.machine import Machine
from vpr_bench.runner.provenance import Provenance, SourceState
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.store import RunStore, StoredRun
from vpr_bench.types.protocol import Protocol

PROTOCOL = "streets/day-night@0f"
DIGEST = "sha256:" + "0" * 64
PLACES = 10


@pytest.fixture(scope="session")
def make_entry():
    """Return a function that makes a row: ``right`` says how many of ten queries, the first ones, were answered."""

    def make(method="hog", right=5, protocol=PROTOCOL, pr_auc=0.5, total=10.0, **changes):
        flags = np.arange(PLACES) < right if isinstance(right, int) else np.asarray(right, bool)
        metrics = dict.fromkeys(METRICS, Interval(0.5, 0.25, 0.75))
        metrics["recall@1"] = Interval(float(flags.mean()) if len(flags) else math.nan, 0.0, 1.0)
        metrics["pr_auc"] = Interval(pr_auc, 0.0, 1.0)
        entry = Entry(
            method=method,
            protocol=Protocol.parse(protocol),
            partial=False,
            n_references=PLACES,
            n_queries=len(flags),
            n_available=len(flags),
            n_counted=len(flags),
            metrics=metrics,
            latency={"latency_total_p50": total, "latency_total_p95": 2 * total},
            elsewhere=0.01,
            fit_seconds=1.5,
            peak_memory={"fit": 10, "match": 20},
            machine="0123abcd",
            machine_about="Processor, 2 cores",
            sequential=False,
            future=0,
            weights=None,
            version="1",
            seed=0,
            k=4,
            threads=2,
            dataset_digest=DIGEST,
            run="0123456789ab",
            package="0.1.0",
            commit=None,
            changed=None,
            created="2026-01-01T00:00:00+00:00",
            right=flags,
        )
        return dataclasses.replace(entry, **changes)

    return make


@pytest.fixture
def make_run(tmp_path):
    """Return a function that stores a run under ``runs``."""

    def make(
        method="hog",
        right=5,
        protocol=PROTOCOL,
        created="2026-01-01T00:00:00+00:00",
        asked=PLACES,
        processor="Processor",
        digest=DIGEST,
        seed=0,
        order="shuffled",
        label=None,
        elsewhere=0.01,
        k=2,
    ):
        queries = np.arange(asked)
        best = np.where(queries < right, queries, (queries + 5) % PLACES)
        arrays = {
            "matches.npz": {
                "queries": queries,
                "indices": (best[:, None] + np.arange(k)) % PLACES,
                "scores": (1 - queries[:, None] / 100 - np.arange(k)).astype(np.float32),
            },
            "timings.npz": {
                "seconds.decode": np.full(asked, 0.5),
                "seconds.encode": np.full(asked, 0.02),
                "seconds.odd": np.full(asked, 0.001),
                "seconds.total": np.full(asked, 0.03),
            },
            "labels.npz": {"queries": np.arange(float(PLACES)), "references": np.arange(float(PLACES))},
        }
        source, _, rest = protocol.partition("/")
        key = RunKey(
            source=source,
            pairing=rest.partition("@")[0],
            dataset_digest=digest,
            method=method,
            version="1",
            parameters={},
            weights=None,
            seed=seed,
            k=k,
            limit=asked if asked < PLACES else None,
            threads=2,
        )
        folder = RunStore(tmp_path / "runs").folder(key)
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in arrays.items():
            write_arrays(folder / name, content)
        machine = Machine(
            system="Linux-6", processor=processor, cores=2, threads=2, python="3.11", libraries={"vpr-bench": "0.1.0"}
        )
        record = RunRecord(
            key=key,
            protocol=protocol,
            label=label or method,
            n_references=PLACES,
            n_queries=asked,
            partial=asked < PLACES,
            resumed=False,
            order=order,
            fit_seconds=1.5,
            peak_memory={"fit": 10, "match": 20},
            machine=machine,
            provenance=Provenance(elsewhere=elsewhere, source=SourceState(commit="c" * 40, changed=True)),
            created=created,
            files={name: sha256_of_file(folder / name) for name in arrays},
        )
        write_bytes(folder / "run.json", record.model_dump_json().encode())
        return StoredRun.open(folder)

    return make
