import numpy as np
import pytest

from vpr_bench.compare.pair import RunPair
from vpr_bench.errors import DataError, UsageError


def test_both_are_judged_by_one_truth(pair_of_runs):
    pair = RunPair.of(*pair_of_runs)
    assert str(pair.protocol) == "gardens/day_left-night_right@0f"
    assert [answers.correct.sum() for answers in pair.answers] == [4, 5]


def test_the_radius_and_the_policy_can_be_others(pair_of_runs):
    pair = RunPair.of(*pair_of_runs, radius=1, unmatched="miss")
    assert str(pair.protocol) == "gardens/day_left-night_right@1f~miss"
    assert [int(answers.correct.sum()) for answers in pair.answers] == [4, 5]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"protocol": "gardens/day_left-day_right@0f"},
            "A was asked gardens/day_left-night_right, B gardens/day_left-",
        ),
        ({"protocol": "gardens:simulated/day_left-night_right@0f"}, "B gardens:simulated/"),
        ({"protocol": "gardens/day_left-night_right@2nearest"}, "A was asked for @0f, B for @2nearest"),
        ({"protocol": "gardens/day_left-night_right@2f"}, "Say which counts with --radius"),
        ({"protocol": "gardens/day_left-night_right@0f~miss"}, "asked to exclude, B to miss. Say which"),
        (
            {"first": [0, 1], "queries": [3, 5], "limit": 2},
            r"8 queries, B 2 queries \(--limit 2, --seed 0\), and only 2",
        ),
        ({"first": [0] * 8, "queries": [0, 1, 2, 3, 4, 5, 6, 6]}, "and only 7 of them"),
    ],
)
def test_what_was_asked_something_else_is_refused(stored, changes, said):
    with pytest.raises(UsageError, match=said):
        RunPair.of(stored(), stored(**changes))


def test_what_is_said_on_the_command_line_settles_what_differs(stored):
    first, second = stored(), stored(protocol="gardens/day_left-night_right@2f~reject")
    assert str(RunPair.of(first, second, radius=1, unmatched="exclude").protocol).endswith("@1f")
    with pytest.raises(UsageError, match="--unmatched"):
        RunPair.of(first, second, radius=1)


def test_other_images_are_other_data(stored):
    with pytest.raises(DataError, match="were not the same: sha256:000000000000… for A, sha256:111111111111… for B"):
        RunPair.of(stored(), stored(digest="1"))


def test_other_places_of_the_same_images_are_not_believed(stored):
    moved = {"queries": np.arange(8.0) + 1, "references": np.arange(8.0)}
    with pytest.raises(DataError, match="different places"):
        RunPair.of(stored(), stored(labels=moved))


def test_a_run_is_not_compared_with_itself(stored):
    run = stored()
    with pytest.raises(UsageError, match="the same run"):
        RunPair.of(run, type(run).open(run.folder))


def test_partial_runs_on_the_same_queries_are_compared(stored):
    runs = [stored(first=[1, 4], queries=[1, 5], limit=2, label=label) for label in ("hog", "sad")]
    pair = RunPair.of(*runs)
    assert pair.answers[0].queries.tolist() == [1, 5] and pair.answers[0].correct.tolist() == [True, False]


def test_a_damaged_run_is_blamed(stored):
    wrong = stored(first=[0, 1, 2, 3, 4, 5, 6, 7], k=1, scores=[float("nan")] * 8)
    with pytest.raises(DataError, match=f"{wrong.folder} is damaged"):
        RunPair.of(stored(), wrong)
