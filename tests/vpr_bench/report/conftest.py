"""A stored run with hand-made answers."""

from datetime import UTC, datetime

import numpy as np
import pytest

from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.runner.machine import describe_machine
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.store import StoredRun


@pytest.fixture
def stored(tmp_path):
    """Four queries on four places: right, right, wrong by one, wrong by two; scores fall in that order."""

    def make(protocol="gardens/day_left-night_right@0f", label="hog", folder="run", limit=None):
        where = tmp_path / folder
        where.mkdir()
        indices = np.array([[0, 1, 2, 3], [1, 0, 2, 3], [3, 2, 1, 0], [1, 3, 2, 0]])
        scores = np.array([[0.9, 0.5, 0.4, 0.1], [0.8, 0.5, 0.4, 0.1], [0.7, 0.5, 0.4, 0.1], [0.6, 0.5, 0.4, 0.1]])
        arrays = {
            "matches.npz": {"queries": np.arange(4), "indices": indices, "scores": scores.astype(np.float32)},
            "timings.npz": {
                "seconds.decode": np.full(4, 0.5),
                "seconds.encode": np.full(4, 0.02),
                "seconds.total": np.full(4, 0.03),
            },
            "labels.npz": {"queries": np.arange(4.0), "references": np.arange(4.0)},
        }
        for name, content in arrays.items():
            write_arrays(where / name, content)
        source, _, rest = protocol.partition("/")
        key = RunKey(
            source=source,
            pairing=rest.partition("@")[0],
            dataset_digest="sha256:" + "0" * 64,
            method=label,
            version="1",
            parameters={},
            weights=None,
            seed=0,
            k=4,
            limit=limit,
            threads=2,
        )
        record = RunRecord(
            key=key,
            protocol=protocol,
            label=label,
            n_references=4,
            n_queries=4,
            partial=limit is not None,
            resumed=False,
            fit_seconds=1.5,
            peak_memory={"fit": 10, "match": 20},
            machine=describe_machine(2),
            created=datetime.now(UTC).isoformat(timespec="seconds"),
            files={name: sha256_of_file(where / name) for name in arrays},
        )
        write_bytes(where / "run.json", record.model_dump_json().encode())
        return StoredRun.open(where)

    return make
