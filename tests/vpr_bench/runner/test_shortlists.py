"""What a method notes on the way to its answer is stored with the run, or is a fault of the method."""

import json

import numpy as np
import pytest

from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import StoredRun
from vpr_bench.shortlist import shortlist
from vpr_bench.types.match import Match

STEPS = {
    "halves": lambda place: np.arange(6) + 6 * (place // 6),
    "passed": lambda place: None,
    "pairs": lambda place: [place // 2 * 2 + 1, place // 2 * 2],
}


class Narrowing:
    """Finds the place by its colour, and rules references out on the way."""

    def __init__(self, steps=STEPS, fail_after=None):
        self.steps, self.fail_after, self.asked = steps, fail_after, 0

    def fit(self, references):
        self.colours_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def match(self, image, k):
        if self.asked == self.fail_after:
            raise KeyboardInterrupt
        self.asked += 1
        distance = np.linalg.norm(self.colours_ - image.mean(axis=(0, 1)), axis=1)
        place = int(distance.argmin())
        for name, left in self.steps.items():
            shortlist(name, left(place))
        return Match.from_scores(-distance, k)


def test_shortlists_are_stored(case, store, built):
    stored = StoredRun.open(run(case, built(Narrowing()), store, RunOptions(limit=7)).folder)
    assert stored.record.files["shortlists.npz"] == sha256_of_file(stored.folder / "shortlists.npz")
    assert [step.step for step in stored.survivors] == list(STEPS)
    halves, passed, pairs = stored.survivors
    for row, query in enumerate(stored.queries):
        assert halves[row].tolist() == list(STEPS["halves"](query))
        assert passed[row] is None
        assert pairs[row].tolist() == sorted(STEPS["pairs"](query))


def test_who_notes_nothing_has_no_file(case, store, built, mean_colour):
    stored = run(case, built(mean_colour()), store)
    assert stored.survivors == [] and not (stored.folder / "shortlists.npz").exists()
    assert "shortlists.npz" not in stored.record.files


def test_an_interrupted_run_loses_none(case, store, built):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(Narrowing(fail_after=3 + 5)), store, RunOptions())
    again = Narrowing()
    broken = run(case, built(again), store, RunOptions())
    assert again.asked == 3 + len(case.queries) - 5
    content = (broken.folder / "shortlists.npz").read_bytes()
    whole = run(case, built(Narrowing()), store, RunOptions(overwrite="always"))
    assert (whole.folder / "shortlists.npz").read_bytes() == content


def test_a_time_limit_changes_nothing(case, store, built):
    assert len(run(case, built(Narrowing()), store, RunOptions(timeout=5)).survivors) == 3


@pytest.mark.parametrize(
    ("left", "said"),
    [
        ([0, 12], "the shortlist 'coarse' names reference 12 of a map of 12"),
        ([0, -1], "the shortlist 'coarse' names reference -1 of a map of 12"),
        ([0, 1, 0], "the shortlist 'coarse' names reference 0 twice"),
        ([0.0, 1.0], "the shortlist 'coarse' must be made of integers. Got dtype float64"),
        ([True, False], "the shortlist 'coarse' must be made of integers. Got dtype bool"),
        (["a"], "the shortlist 'coarse' must be made of integers"),
        ([[0, 1]], r"the shortlist 'coarse' must have shape \(m,\). Got \(1, 2\)"),
        ([], "the best answer is reference [0-9]+, which 'coarse' had ruled out"),
    ],
)
@pytest.mark.parametrize("timeout", [None, 5])
def test_a_wrong_shortlist_is_a_fault_that_is_named(case, store, built, left, said, timeout):
    method = Narrowing({"coarse": lambda place: left})
    with pytest.raises(
        VprBenchError, match=rf"'mean-colour' failed while answering winter\[[0-9]+\].*{said}"
    ) as caught:
        run(case, built(method), store, RunOptions(timeout=timeout))
    assert "\n" not in str(caught.value) and caught.value.exit_code == 1
    assert not list(store.root.rglob("run.json"))


@pytest.mark.parametrize("name", ["", "two\nlines", "x" * 41, 7])
def test_a_step_has_a_name(case, store, built, name):
    with pytest.raises(VprBenchError, match="name must be printable text"):
        run(case, built(Narrowing({name: lambda place: None})), store)


def test_what_was_ruled_out_stays_out(case, store, built):
    steps = {"coarse": lambda place: [place], "passed": lambda place: None, "fine": lambda place: [place, 11 - place]}
    with pytest.raises(VprBenchError, match=r"'fine' names reference [0-9]+, which 'coarse' had ruled out"):
        run(case, built(Narrowing(steps)), store)


def test_a_damaged_file_is_noticed(case, store, built):
    stored = run(case, built(Narrowing()), store)
    np.savez(stored.folder / "shortlists.npz", steps=np.array(["x"]))
    with pytest.raises(DataError, match=r"not what run\.json recorded"):
        StoredRun.open(stored.folder)
    record = json.loads((stored.folder / "run.json").read_text())
    record["files"]["shortlists.npz"] = sha256_of_file(stored.folder / "shortlists.npz")
    (stored.folder / "run.json").write_text(json.dumps(record))
    with pytest.raises(DataError, match=r"shortlists\.npz is damaged"):
        _ = StoredRun.open(stored.folder).survivors
