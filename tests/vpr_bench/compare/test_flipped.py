import numpy as np

from vpr_bench.compare.flipped import Best, flipped_queries
from vpr_bench.compare.pair import RunPair
from vpr_bench.files.atomic import read_arrays
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places

GIVEN = "gardens/day_left-night_right@given"


def test_what_each_answered_and_what_is_true(pair_of_runs):
    lost, gained = flipped_queries(RunPair.of(*pair_of_runs))
    assert [one.query for one in lost] == [0, 1] and not any(one.gained for one in lost)
    assert [one.query for one in gained] == [4, 5, 6] and all(one.gained for one in gained)
    assert (lost[1].first.reference, lost[1].second.reference, lost[1].truth) == (1, 5, 1)
    scores = pair_of_runs[0].scores[:, 0]
    assert lost[1].first.score == lost[1].second.score == float(scores[1])


def test_nothing_answered(stored):
    lost, _ = flipped_queries(RunPair.of(stored(), stored(first=[0, 1, 2, -1, 4, 5, 6, 7], label="sad")))
    assert lost[0].query == 3 and lost[0].second == Best(None, None)


def test_partial_runs_keep_the_numbers_of_their_queries(stored):
    runs = [stored(first=first, queries=[2, 6], limit=2, label=str(first)) for first in ([2, 0], [2, 6])]
    _, gained = flipped_queries(RunPair.of(*runs))
    assert [(one.query, one.truth) for one in gained] == [(6, 6)]


def test_the_nearest_of_several_true_places(stored):
    runs = [stored(first=first, label=str(first)) for first in ([5] * 8, [4, 2, 3, 4, 5, 6, 7, 7])]
    _, gained = flipped_queries(RunPair.of(*runs, radius=1))
    assert [(one.query, one.truth) for one in gained] == [(1, 1), (2, 2), (3, 3), (7, 7)]


def test_positions_in_metres(stored):
    places = np.stack([np.arange(8.0), np.arange(8.0) % 2], axis=1)
    labels = {"queries": places + np.array([0.0, 0.4]), "references": places}
    protocol = "gardens/day_left-night_right@2m"
    runs = [stored(first=first, labels=labels, protocol=protocol, label=str(first)) for first in ([7] * 8, range(8))]
    assert [one.truth for one in flipped_queries(RunPair.of(*runs))[1]] == [0, 1, 2, 3, 4, 5]


def test_where_places_have_no_labels_the_first_true_one(stored):
    truth = GroundTruth.from_lists([[3, 5]] + [[0]] * 7, n_references=8)
    labels = Places(given=truth).arrays()
    runs = [stored(first=first, labels=labels, protocol=GIVEN) for first in ([5] + [0] * 7, [0] * 8)]
    lost, gained = flipped_queries(RunPair.of(*runs))
    assert [(one.query, one.truth) for one in lost] == [(0, 3)] and gained == []


def test_a_list_with_labels_has_a_nearest_true_place(stored):
    truth = GroundTruth.from_lists([[3, 5]] + [[0]] * 7, n_references=8)
    labels = Places(np.full(8, 4.5), np.arange(8.0), truth).arrays()
    runs = [stored(first=first, labels=labels, protocol=GIVEN) for first in ([5] + [0] * 7, [0] * 8)]
    assert [one.truth for one in flipped_queries(RunPair.of(*runs))[0]] == [5]


def test_soft_matches_are_passed_over(stored):
    truth = GroundTruth.from_lists([[2]] + [[0]] * 7, n_references=8)
    soft = GroundTruth.from_lists([[0, 1]] + [[]] * 7, n_references=8)
    labels = Places(given=truth.with_soft(soft)).arrays()
    runs = [stored(first=first, labels=labels, protocol=GIVEN) for first in ([0] * 8, [4] + [0] * 7)]
    lost, _ = flipped_queries(RunPair.of(*runs))
    stored_scores = read_arrays(runs[0].folder / "matches.npz")["scores"]
    assert lost[0].first == Best(2, float(stored_scores[0, 2])) and lost[0].second.reference == 4
