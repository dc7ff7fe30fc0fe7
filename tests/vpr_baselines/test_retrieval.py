import numpy as np
import pytest

from vpr_baselines.retrieval import Retrieval, normalised
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse


class MeanColour(Retrieval):
    def describe(self, image):
        return image.mean(axis=(0, 1), dtype=np.float32)


def plain(*colour):
    return np.full((4, 4, 3), colour, np.uint8)


@pytest.fixture
def fitted():
    method = MeanColour()
    method.fit(Traverse("map", [plain(200, 0, 0), plain(0, 100, 0), plain(50, 50, 0), plain(0, 0, 0)]))
    return method


def test_the_score_is_the_cosine_similarity(fitted):
    match = fitted.match(plain(90, 0, 0), k=4)
    assert match.indices.tolist() == [0, 2, 1, 3]
    assert match.scores == pytest.approx([1, np.sqrt(0.5), 0, 0], abs=1e-6)


def test_it_answers_with_the_best_k(fitted):
    assert fitted.match(plain(90, 0, 0), k=2).indices.tolist() == [0, 2]
    assert len(fitted.match(plain(90, 0, 0), k=99)) == 4


def test_fitting_again_forgets_the_former_map(fitted):
    fitted.fit(Traverse("map", [plain(0, 0, 9)]))
    assert fitted.match(plain(0, 0, 5), k=9).indices.tolist() == [0]


def test_an_image_without_any_content_scores_zero(fitted):
    assert fitted.match(plain(0, 0, 0), k=4).scores.tolist() == [0, 0, 0, 0]


def test_what_is_saved_answers_as_before(fitted, tmp_path):
    fitted.save(tmp_path)
    loaded = MeanColour().load(tmp_path)
    for colour in ((9, 3, 1), (0, 0, 0)):
        before, after = fitted.match(plain(*colour), 3), loaded.match(plain(*colour), 3)
        assert after.indices.tolist() == before.indices.tolist() and after.scores.tolist() == before.scores.tolist()


def test_its_stages_are_encode_and_match(fitted):
    with collect_stages() as seconds:
        fitted.match(plain(1, 2, 3), 1)
    assert list(seconds) == ["encode", "match"]


def test_vectors_become_unit_length_and_zero_stays_zero():
    vectors = normalised(np.array([[[3, 4], [0, 0]], [[1e-30, 0], [-2, 0]]], np.float32))
    assert vectors == pytest.approx(np.array([[[0.6, 0.8], [0, 0]], [[0, 0], [-1, 0]]]))
    assert vectors.dtype == np.float32
