"""Boards of hand-made runs on the tiny dataset, whose images are there, and the page that is made of them."""

import json
import shutil
import sys
import types
from dataclasses import dataclass

import numpy as np
import pytest

from vpr_bench.dataset.card import DATASETS, Published
from vpr_bench.dataset.load import load_case
from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.leaderboard.collect import collect
from vpr_bench.leaderboard.standing import boards
from vpr_bench.page.page import write_page
from vpr_bench.registry import Entry
from vpr_bench.runner.machine import Machine
from vpr_bench.runner.provenance import Provenance
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.survivors import gathered, to_arrays

HOSTILE = (
    "<img src=x onerror=alert(1)>\"'&amp;</script><script>alert(2)</script>\u2028\u202egnp.\u05d0 %{x} $a$ " + "x" * 300
)
"""A method's name as somebody might write it who means no good."""

DAY, NIGHT, SIMULATED = (
    "tiny/day_left-day_right@1f",
    "tiny/day_left-night_right@1f~miss",
    "tiny:simulated/day_left-day_right@1f",
)
_N, _K = 12, 5


@dataclass(frozen=True)
class Made:
    """What a page is written from."""

    boards: list
    runs: dict


@pytest.fixture(scope="module")
def hostile():
    return HOSTILE


@pytest.fixture(scope="module")
def tiny(tiny_card, tiny_images, tmp_path_factory):
    """Register the dataset ``tiny``, with a published number of doubtful wording and its real images."""

    class Renderer:
        def __init__(self, options):
            pass

        def fingerprint(self):
            return "copied"

        def render(self, folder):
            shutil.copytree(tiny_images, folder, dirs_exist_ok=True)

    published = Published(
        references="day_left",
        queries="day_right",
        method="<b>they</b>",
        metric="pr_auc",
        value=0.99,
        source="<i>who</i>",
    )
    plugin = types.ModuleType("tiny_plugin")
    vars(plugin).update(card=tiny_card.model_copy(update={"published": [published]}), Renderer=Renderer)
    root = tmp_path_factory.mktemp("data")
    shutil.copytree(tiny_images, root / "tiny")
    found = {**DATASETS._found, "tiny": [Entry("tiny", "tiny_plugin:card", "tiny-plugin 1.0")]}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("VPR_BENCH_DATA", str(root))
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setitem(sys.modules, "tiny_plugin", plugin)
        patch.setitem(vars(DATASETS), "_found", found)
        yield root / "tiny"


def _arrays(case, wrong, seed, steps):
    """Answer every query rightly but the last ``wrong`` ones, with scores that fall from query to query."""
    random = np.random.default_rng(seed)
    order = np.array([np.roll(np.arange(_N), -query - (6 if query >= _N - wrong else 0))[:_K] for query in range(_N)])
    scores = np.sort(random.random((_N, _K)))[:, ::-1] + np.linspace(1, 0, _N)[:, None]
    arrays = {
        "matches.npz": {"queries": np.arange(_N), "indices": order, "scores": scores.astype(np.float32)},
        "timings.npz": {
            "seconds.decode": np.full(_N, 0.004),
            "seconds.total": random.uniform(0.9, 1.1, _N) * 0.002 * (seed + 1),
        },
        "labels.npz": case.places.arrays(),
    }
    if steps:
        kept = [{"clusters": np.sort(row).astype(np.int32)} for row in order]
        arrays["shortlists.npz"] = to_arrays(gathered(kept))
    return arrays


@pytest.fixture(scope="module")
def make_run(tiny, tmp_path_factory):
    """Return a function that stores a run."""

    def make(label, protocol=DAY, wrong=2, seed=0, limit=None, order="shuffled", elsewhere=0.01, steps=False, memory=8):
        case = load_case(protocol)
        arrays = _arrays(case, wrong, seed, steps)
        key = RunKey(
            source=case.protocol.source,
            pairing=case.protocol.pairing,
            dataset_digest=case.digest,
            method="made",
            version="1",
            parameters={"label": label},
            weights=None,
            seed=seed,
            k=_K,
            limit=limit,
            threads=1,
        )
        folder = tmp_path_factory.mktemp("runs") / key.digest()
        folder.mkdir()
        if limit is not None:
            arrays["matches.npz"] = {name: column[:limit] for name, column in arrays["matches.npz"].items()}
            arrays["timings.npz"] = {name: column[:limit] for name, column in arrays["timings.npz"].items()}
        for name, content in arrays.items():
            write_arrays(folder / name, content)
        machine = Machine(
            system="Linux-6", processor=f"<u>chip {memory}</u>", cores=2, threads=1, memory_bytes=memory * 2**30,
            python="3.11", libraries={"vpr-bench": "0.1.0"},
        )  # fmt: skip
        record = RunRecord(
            key=key,
            protocol=protocol,
            label=label,
            n_references=_N,
            n_queries=limit or _N,
            partial=limit is not None,
            resumed=False,
            order=order,
            fit_seconds=1.5,
            peak_memory={"fit": 10 * 2**20, "match": 20 * 2**20},
            machine=machine,
            provenance=Provenance(elsewhere=elsewhere),
            created=f"2026-01-{seed + 1:02d}T00:00:00+00:00",
            files={name: sha256_of_file(folder / name) for name in arrays},
        )
        write_bytes(folder / "run.json", record.model_dump_json().encode())
        return StoredRun.open(folder)

    return make


@pytest.fixture(scope="module")
def make_boards():
    """Return a function that ranks runs."""

    def make(*runs):
        entries = [collect(run, Protocol.parse(run.record.protocol)) for run in runs]
        return Made(boards(entries), {run.folder.name: run for run in runs})

    return make


@pytest.fixture(scope="module")
def made(make_run, make_boards):
    """Four methods on three protocols, one of them simulated; among them a hostile, a busy and a partial one."""
    return make_boards(
        make_run("best", wrong=1, seed=3, steps=True),
        make_run("second", wrong=9, seed=1, order="sequential"),
        make_run(HOSTILE, wrong=5, seed=2),
        make_run("busy", wrong=6, seed=0, elsewhere=0.5, memory=16),
        make_run("partial", seed=4, limit=3),
        make_run("best", NIGHT, wrong=2, seed=3),
        make_run("second", NIGHT, wrong=4, seed=1),
        make_run("best", SIMULATED, wrong=0, seed=3),
    )


@pytest.fixture(scope="module")
def page_file(made, tmp_path_factory):
    """Return the page that is made of them."""
    return write_page(made.boards, made.runs, tmp_path_factory.mktemp("page") / "index.html", pytest.fail)


@pytest.fixture(scope="module")
def read_json():
    """Return a function that reads the JSON of every ``<script type="application/json">`` with some attribute."""

    def read(html, attribute):
        return [json.loads(part.partition("</script>")[0]) for part in html.split(f"{attribute}>")[1:]]

    return read
