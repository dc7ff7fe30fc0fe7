"""A run whose fit was interrupted goes on with the steps that the method keeps."""

import numpy as np
import pytest

from vpr_bench.checkpoint import CheckpointWarning, kept
from vpr_bench.errors import VprBenchError
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.types.match import Match


class TwoSteps:
    """Describes, then trains; can be told to fail in between. Cannot save."""

    def __init__(self, fail_after=None, error=KeyboardInterrupt, fail_answer=False):
        self.fail_after, self.error, self.fail_answer = fail_after, error, fail_answer
        self.steps = []

    def fit(self, references):
        self.colours_ = self.step("describe", lambda: np.stack([image.mean(axis=(0, 1)) for image in references]))
        self.scale_ = self.step("train", lambda: np.array(2.0))

    def step(self, name, compute):
        def counted():
            self.steps.append(name)
            return {"array": compute()}

        array = kept(name, counted)["array"]
        if len(self.steps) == self.fail_after:
            raise self.error("told to fail")
        return array

    def match(self, image, k):
        if self.fail_answer:
            raise KeyboardInterrupt
        return Match.from_scores(-self.scale_ * np.linalg.norm(self.colours_ - image.mean(axis=(0, 1)), axis=1), k)


class Kept(TwoSteps):
    """The same, and it can save."""

    def save(self, folder):
        np.savez(folder / "map.npz", colours=self.colours_, scale=self.scale_)

    def load(self, folder):
        with np.load(folder / "map.npz") as stored:
            self.colours_, self.scale_ = stored["colours"], stored["scale"]
        return self


@pytest.fixture(params=[TwoSteps, Kept])
def method(request):
    return request.param


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError])
def test_goes_on_with_what_was_kept(case, store, built, method, error):
    first, second = method(fail_after=1, error=error), method()
    with pytest.raises((KeyboardInterrupt, VprBenchError)):
        run(case, built(first), store)
    stored = run(case, built(second), store)
    assert (first.steps, second.steps) == (["describe"], ["train"])
    assert stored.record.resumed
    assert sorted(path.name for path in stored.folder.iterdir()) == [
        "labels.npz",
        "matches.npz",
        "run.json",
        "timings.npz",
    ]
    fresh = run(case, built(method()), store, RunOptions(overwrite="always"))
    assert not fresh.record.resumed
    np.testing.assert_array_equal(fresh.indices, stored.indices)
    np.testing.assert_array_equal(fresh.scores, stored.scores)


def test_a_method_that_cannot_save_is_not_fitted_twice_for_its_answers(case, store, built):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(TwoSteps(fail_answer=True)), store)
    second = TwoSteps()
    run(case, built(second), store)
    assert second.steps == []


def test_what_is_damaged_is_computed_again(case, store, built, method):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(method(fail_after=1)), store)
    (file,) = store.root.rglob("describe*.npz")
    file.write_bytes(file.read_bytes()[:100])
    second = method()
    with pytest.warns(CheckpointWarning, match="computed again"):
        run(case, built(second), store)
    assert second.steps == ["describe", "train"]


def test_another_method_does_not_read_it(case, store, built, method):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(method(fail_after=1), size=1), store)
    other = method()
    run(case, built(other, size=2), store)
    assert other.steps == ["describe", "train"]
