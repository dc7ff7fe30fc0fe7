import cv2
import numpy as np
import pytest

from vpr_baselines.sift.method import Sift
from vpr_bench.errors import UsageError
from vpr_bench.method.build import build_method
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse

GREY = np.full((180, 240, 3), 128, np.uint8)
MODES = {
    "local": {"size": 240},
    "verified": {"size": 240, "verify": "homography", "n_verified": 3},
    "descriptor": {"mode": "descriptor", "size": 240, "n_features": 128},
}


def moved(image, right=9, down=4):
    """Return what a camera that turned a little sees."""
    return cv2.warpAffine(image, np.float32([[1, 0, right], [0, 1, down]]), image.shape[1::-1])


def fit(images, **parameters):
    method = Sift(**parameters)
    method.fit(Traverse("map", images))
    return method


@pytest.mark.parametrize("mode", MODES)
def test_every_reference_finds_itself_first(mode, scenes):
    method = fit(scenes, **MODES[mode])
    for index, image in enumerate(scenes):
        assert method.match(image, 3).indices[0] == index


@pytest.mark.parametrize("mode", ["local", "verified"])
def test_it_recognises_places_after_the_camera_moved(mode, scenes):
    method = fit(scenes, **MODES[mode])
    for index, image in enumerate(scenes):
        match = method.match(moved(image), 6)
        assert match.indices[0] == index and match.scores[0] > 20


def test_the_score_is_the_number_of_matches_and_their_mean_similarity(scenes):
    method = fit(scenes, size=240)
    pairs = method._engine.map_.best(method._engine._detect(moved(scenes[2])), 0.8, 6)
    match = method.match(moved(scenes[2]), 6)
    assert match.scores.tolist() == pytest.approx(sorted((one.score for one in pairs.values()), reverse=True))
    assert int(match.scores[0]) == len(pairs[2].query)


def test_verification_only_takes_matches_away(scenes):
    plain, verified = (fit(scenes, **MODES[mode]) for mode in ("local", "verified"))
    for image in scenes:
        before, after = plain.match(moved(image), 6), verified.match(moved(image), 6)
        assert len(after) <= 3
        assert after.scores[0] <= before.scores[0] + 1


def test_no_key_points_no_answer(scenes):
    method = fit([*scenes[:2], GREY], size=240)
    assert len(method.match(GREY, 3)) == 0
    assert 2 not in method.match(scenes[0], 3).indices
    assert method.scores(GREY).tolist() == [0, 0, 0]
    assert len(fit([GREY], size=240, verify="fundamental").match(scenes[0], 3)) == 0


def test_the_descriptor_of_the_thesis_has_16384_numbers_and_zeros_at_its_end(scenes):
    built = build_method("sift:thesis")
    assert built.label == "sift:thesis" and built.parameters["metric"] == "manhattan"
    built.method.fit(Traverse("map", [scenes[0], GREY]))
    database = built.method._engine.index_.database
    assert database.shape == (2, 16384) and not database[1].any()
    assert database[0].max() > 50
    distance = -np.abs(database[0]).sum(dtype=np.float64)
    assert built.method.match(GREY, 2).scores == pytest.approx([0, distance], rel=1e-6)


@pytest.mark.parametrize("mode", MODES)
def test_what_is_saved_answers_as_before(mode, scenes, tmp_path):
    method = fit(scenes, **MODES[mode])
    method.save(tmp_path)
    loaded = Sift(**MODES[mode]).load(tmp_path)
    before, after = method.match(moved(scenes[4]), 6), loaded.match(moved(scenes[4]), 6)
    assert before.indices.tolist() == after.indices.tolist() and before.scores.tolist() == after.scores.tolist()


@pytest.mark.parametrize("mode", ["local", "descriptor"])
def test_scores_of_all_references_rank_as_it_answers(mode, scenes):
    method = fit(scenes, **MODES[mode])
    scores, match = method.scores(moved(scenes[1])), method.match(moved(scenes[1]), 6)
    assert scores.shape == (6,) and scores.dtype == np.float32
    assert np.array_equal(scores[match.indices], match.scores)


@pytest.mark.parametrize(
    ("mode", "stages"),
    [("local", ["encode", "match"]), ("verified", ["encode", "match", "rerank"]), ("descriptor", ["encode", "match"])],
)
def test_its_stages(mode, stages, scenes):
    method = fit(scenes, **MODES[mode])
    with collect_stages() as seconds:
        method.match(scenes[0], 3)
    assert list(seconds) == stages


@pytest.mark.parametrize("shape", [(1, 1), (3, 200), (600, 7)])
def test_images_of_any_size_are_matched(shape, scenes):
    image = np.random.default_rng(0).integers(0, 256, (*shape, 3), dtype=np.uint8)
    for mode in MODES.values():
        assert np.isfinite(fit([image, scenes[0]], **mode).match(image, 2).scores).all()


@pytest.mark.parametrize(
    "parameters",
    [{"ratio": "1.5"}, {"ratio": "0"}, {"n_features": "0"}, {"size": "3"}, {"verify": "affine"}, {"mode": "global"}],
    ids=str,
)
def test_parameters_out_of_range_are_refused(parameters):
    with pytest.raises(UsageError, match=f"Got '{next(iter(parameters.values()))}' instead"):
        build_method("sift", parameters)
