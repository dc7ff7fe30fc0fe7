import numpy as np
import pytest
from PIL import ImageColor

from vpr_bench.envs.exchange import Exchange
from vpr_bench.envs.picture import draw
from vpr_bench.report.ink import BLUE, GREEN, GREY, RED
from vpr_bench.types.ground_truth import GroundTruth

SHAPE = (6, 8, 3)


def holds(picture, colour):
    return bool((picture == ImageColor.getrgb(colour)).all(axis=2).sum() > 500)


def shown(case, answer=1, truth=(0, 1), verdict="right"):
    return draw(case, SHAPE, None, Exchange(0, answer, 0.5, np.array(truth, dtype=np.int64), verdict, 3, 2))


@pytest.mark.parametrize(("verdict", "colour"), [("right", GREEN), ("wrong", RED), ("not counted", GREY)])
def test_the_frame_says_what_became_of_it(make_case, verdict, colour):
    picture = shown(make_case(), verdict=verdict, truth=())
    assert picture.dtype == np.uint8 and picture.ndim == 3
    assert holds(picture, colour) and holds(picture, BLUE)
    assert holds(picture, GREEN) == (verdict == "right")  # no truth, no frame around it


def test_the_truth_is_framed_in_green(make_case):
    assert holds(shown(make_case(), verdict="wrong", answer=5), GREEN)


def test_no_answer(make_case):
    assert not np.array_equal(shown(make_case(), -1, verdict="no answer"), shown(make_case(), 1, verdict="wrong"))


def test_before_the_answer_there_is_the_query_and_nothing_else(make_case):
    case = make_case()
    pictures = [draw(case, SHAPE, query, None) for query in (0, 3)]
    assert not any(holds(picture, colour) for picture in pictures for colour in (GREEN, RED))
    changed = (pictures[0] != pictures[1]).any(axis=2).nonzero()
    assert changed[1].max() < pictures[0].shape[1] // 3  # inside the first picture: no name, no number


def test_the_nearest_true_match_is_shown_else_the_first_one(make_case):
    given = make_case(given=GroundTruth.from_pairs([0, 0, 0], [2, 3, 7], 5, 8))
    bright = {int(image[0, 0, 0]): index for index, image in enumerate(given.references)}
    for labels, expected in ((np.full(5, 3.2), 3), (None, 2)):
        object.__setattr__(given.places, "queries", labels)
        picture = shown(given, -1, (2, 3, 7), "no answer")
        middle_of_third = picture[picture.shape[0] // 2, 5 * picture.shape[1] // 6]
        assert bright[int(middle_of_third[0])] == expected


def test_tall_and_wide_pictures_stay_within_bounds(make_case):
    heights = [draw(make_case(), shape, None, None).shape[0] for shape in ((900, 10, 3), (10, 900, 3), (9, 16, 3))]
    assert heights[0] < 600 and heights[1] > 200
    assert all(height % 2 == 0 for height in heights)
