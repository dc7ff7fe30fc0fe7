from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from vpr_baselines.hog import Hog
from vpr_baselines.sequence.forward import ForwardFilter
from vpr_baselines.sequence.seqslam import SeqSlam
from vpr_bench.dataset.load import Case
from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method
from vpr_bench.method.interfaces import Foresighted, is_sequential
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore
from vpr_bench.shortlist import shortlist
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.traverse import Traverse

WRAPPERS = {"seqslam": SeqSlam, "hmm": ForwardFilter}
SMALL_HOG = {"inner": "hog", "inner.width": "32", "inner.height": "32", "inner.cell": "8"}


@pytest.fixture
def case():
    """Return a walk past 20 textures and the same walk, a little darker."""
    textures = np.random.default_rng(0).integers(0, 200, (20, 32, 32, 3), dtype=np.uint8)
    labels = np.arange(20, dtype=np.float64)
    return Case(
        Protocol("tiny", "day", "dusk", 1, "f"),
        Traverse("day", list(textures)),
        Traverse("dusk", list((textures * 0.8).astype(np.uint8))),
        Places(labels, labels.copy()),
        "sha256:" + "0" * 64,
        Path("nowhere"),
    )


@pytest.mark.parametrize("name", WRAPPERS)
def test_a_wrapper_runs_around_any_method(case, tmp_path, name):
    built = build_method(name, SMALL_HOG)
    assert built.label == f"{name}(inner=hog(width=32, height=32, cell=8))"
    assert (
        built.parameters["inner"]["parameters"]
        == build_method("hog", {"width": 32, "height": 32, "cell": 8}).parameters
    )
    assert is_sequential(built.method)
    stored = run(case, built, RunStore(tmp_path))
    assert stored.indices[:, 0].tolist() == list(range(20))
    assert stored.record.order == "sequential"
    assert {"encode", "match", "sequence", "total"} <= stored.seconds.keys()


def test_the_window_of_the_future_stands_in_the_result(case, tmp_path):
    stored = run(case, build_method("seqslam", {**SMALL_HOG, "future": "3"}), RunStore(tmp_path))
    assert stored.record.future == stored.record.key.parameters["future"] == 3
    assert stored.indices[:, 0].tolist() == list(range(20))
    assert isinstance(SeqSlam(), Foresighted) and not isinstance(ForwardFilter(), Foresighted)


@pytest.mark.parametrize("name", WRAPPERS)
def test_the_weights_inside_are_those_of_the_result(name):
    built = build_method(name, {"inner": "twostage"})
    assert built.weights == build_method("twostage").weights
    assert built.weights and build_method(name, {"inner": "hog"}).weights is None


@pytest.mark.parametrize("wrapper", WRAPPERS.values())
def test_a_method_inside_can_be_given_as_it_is(case, wrapper):
    method = wrapper(Hog(width=32, height=32, cell=8))
    method.fit(case.references)
    assert method.match(case.queries[3], 1).indices.tolist() == [3]


@pytest.mark.parametrize("wrapper", WRAPPERS.values())
def test_saved_maps_answer_alike(case, tmp_path, wrapper):
    first = wrapper(Hog(width=32, height=32, cell=8))
    first.fit(case.references)
    first.save(tmp_path)
    again = wrapper(Hog(width=32, height=32, cell=8)).load(tmp_path)
    for image in case.queries[:5]:
        ours, theirs = first.match(image, 4), again.match(image, 4)
        assert np.array_equal(ours.scores, theirs.scores) and np.array_equal(ours.indices, theirs.indices)


def test_a_method_that_cannot_be_kept_inside_is_no_obstacle(case, tmp_path):
    class Fleeting:
        def fit(self, references):
            self.hog = Hog(width=32, height=32, cell=8)
            self.hog.fit(references)

        def match(self, image, k):
            return self.hog.match(image, k)

    built = replace(build_method("seqslam", SMALL_HOG), method=SeqSlam(Fleeting()))
    stored = run(case, built, RunStore(tmp_path), RunOptions(limit=6))
    assert stored.indices[:, 0].tolist() == list(range(6))


@pytest.mark.parametrize("name", WRAPPERS)
def test_fitting_again_forgets(case, name):
    method = build_method(name, SMALL_HOG).method
    method.fit(case.references)
    for image in case.queries[:8]:
        method.match(image, 3)
    method.fit(case.references[:5])
    assert len(method.match(case.queries[0], 20)) == 5


@pytest.mark.parametrize("name", WRAPPERS)
def test_a_sequence_method_inside_another_is_refused(name):
    with pytest.raises(UsageError, match="inner must be a method for single images"):
        build_method(name, {"inner": "hmm"})


@pytest.mark.parametrize("name", WRAPPERS)
def test_what_the_method_inside_rules_out_is_not_ruled_out(case, tmp_path, name):
    class Narrowing(Hog):
        def match(self, image, k):
            shortlist("nearest", [0])
            return super().match(image, k)

        def scores(self, image):
            shortlist("nearest", [0])
            return super().scores(image)

    built = replace(build_method(name), method=WRAPPERS[name](inner=Narrowing(width=32, height=32, cell=8)))
    assert run(case, built, RunStore(tmp_path), RunOptions()).survivors == []


@pytest.mark.parametrize(
    ("method", "wrong"), [("seqslam", {"v_max": 1e8}), ("seqslam", {"past": 10**9}), ("hmm", {"v_max": 10**9})]
)
def test_what_would_take_for_ever_is_refused(method, wrong):
    with pytest.raises(UsageError, match="should be less than or equal to"):
        build_method(method, {"inner": "sad", **wrong})
