"""What stands below the pictures."""

import pytest

from vpr_bench.page.album import Album
from vpr_bench.page.gallery import Galleries
from vpr_bench.types.protocol import Protocol

pytestmark = pytest.mark.usefixtures("tiny")


def notes(run, group, protocol=None):
    """Return title, name and note of the panels of the first example."""
    gallery = Galleries(Album(), pytest.fail).gallery(run, protocol or run.protocol)
    return [(panel["title"], panel["name"], panel["note"]) for panel in gallery[group][0]]


def test_a_failure_says_how_far_off_it_is_and_where_the_truth_came(make_run):
    run = make_run("some", wrong=1, seed=5)
    score, *_ = run.scores[11]
    assert notes(run, "failures") == [
        ("Query", "day_right/Image011.jpg", ""),
        ("Answer", "day_left/Image005.jpg", f"score {score:.4g}, 6 frames away"),
        ("True place", "day_left/Image011.jpg", "not among the first 5 answers"),
    ]


def test_a_success_says_which_answer_the_nearest_place_was(make_run):
    run = make_run("some", wrong=0, seed=5)
    [_, answer, truth] = notes(run, "successes")
    assert answer[2].endswith(", 0 frames away")
    assert truth[2] == f"score {run.scores[11][0]:.4g}, answer 1 of 5"


def test_nothing_answered_and_no_place_are_said(make_run):
    run = make_run("some", wrong=0, seed=6)
    indices = run.indices.copy()
    indices[0] = -1
    vars(run)["_matches"] = {**run._matches, "indices": indices}
    run.places.queries[0] = 999
    assert notes(run, "failures", Protocol.parse("tiny/day_left-day_right@1f~miss"))[1:] == [
        ("Answer", "", "nothing answered"),
        ("True place", "", "the map does not show this place"),
    ]
