from dataclasses import dataclass

import numpy as np
import pytest

from vpr_baselines.retrieval import Retrieval, normalised
from vpr_bench.method.build import build_method
from vpr_bench.method.interfaces import Persistent
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse


@dataclass
class MeanColour(Retrieval):
    channels: int = 3

    def describe(self, image):
        return image.mean(axis=(0, 1), dtype=np.float32)[: self.channels]


def plain(*colour):
    return np.full((4, 4, 3), colour, np.uint8)


MAP = Traverse("map", [plain(200, 0, 0), plain(0, 100, 0), plain(50, 50, 0), plain(0, 0, 0)])


def fit(**parameters):
    method = MeanColour(**parameters)
    method.fit(MAP)
    return method


@pytest.mark.parametrize(
    ("metric", "expected"),
    [
        ("cosine", [1, 0, np.sqrt(0.5), 0]),
        ("euclidean", [-110, -np.hypot(90, 100), -np.hypot(40, 50), -90]),
        ("manhattan", [-110, -190, -90, -90]),
    ],
)
def test_the_score_is_the_similarity_or_minus_the_distance(metric, expected):
    method = fit(metric=metric)
    assert method.scores(plain(90, 0, 0)) == pytest.approx(expected, abs=1e-5)
    match = method.match(plain(90, 0, 0), k=4)
    assert match.indices.tolist() == np.argsort(-np.float32(expected), kind="stable").tolist()
    assert match.scores == pytest.approx(sorted(expected, reverse=True), abs=1e-5)


def test_it_answers_with_the_best_k():
    assert fit().match(plain(90, 0, 0), k=2).indices.tolist() == [0, 2]
    assert len(fit().match(plain(90, 0, 0), k=99)) == 4


def test_fitting_again_forgets_the_former_map():
    method = fit()
    method.fit(Traverse("map", [plain(0, 0, 9)]))
    assert method.match(plain(0, 0, 5), k=9).indices.tolist() == [0]


def test_an_image_without_any_content_scores_zero():
    assert fit().match(plain(0, 0, 0), k=4).scores.tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("metric", ["cosine", "euclidean", "manhattan"])
def test_what_is_saved_answers_as_before(metric, tmp_path):
    method = fit(metric=metric)
    assert isinstance(method, Persistent)
    method.save(tmp_path)
    loaded = MeanColour(metric=metric).load(tmp_path)
    for colour in ((9, 3, 1), (0, 0, 0)):
        before, after = method.match(plain(*colour), 3), loaded.match(plain(*colour), 3)
        assert after.indices.tolist() == before.indices.tolist() and after.scores.tolist() == before.scores.tolist()


def test_its_stages_are_encode_and_match():
    with collect_stages() as seconds:
        fit().match(plain(1, 2, 3), 1)
    assert list(seconds) == ["encode", "match"]


def test_metric_and_index_are_parameters_of_every_method_of_this_kind():
    built = build_method("hog", {"metric": "manhattan", "width": "32", "height": "32"})
    assert built.parameters["index"] == "exact"
    assert built.label == "hog(width=32, height=32, metric=manhattan)"


def test_own_parameters_stay_the_first_by_position():
    assert MeanColour(2).channels == 2


def test_vectors_become_unit_length_and_zero_stays_zero():
    vectors = normalised(np.array([[[3, 4], [0, 0]], [[1e-30, 0], [-2, 0]]], np.float32))
    assert vectors == pytest.approx(np.array([[[0.6, 0.8], [0, 0]], [[0, 0], [-1, 0]]]))
    assert vectors.dtype == np.float32
