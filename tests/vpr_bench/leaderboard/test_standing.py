import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.dataset.card import DATASETS
from vpr_bench.errors import DataError
from vpr_bench.leaderboard.standing import boards, pareto
from vpr_bench.metrics.mcnemar import mcnemar
from vpr_bench.runner.fair_times import BUSY

NAN = math.nan


def ranks(board):
    return [(one.rank, one.entry.method) for one in board.standings]


def test_the_best_recall_is_first(make_entry):
    (board,) = boards([make_entry("a", 2), make_entry("b", 9), make_entry("c", 5)])
    assert ranks(board) == [(1, "b"), (2, "c"), (3, "a")]


def test_where_recall_is_equal_the_area_decides(make_entry):
    (board,) = boards([make_entry("a", 5, pr_auc=0.2), make_entry("b", 5, pr_auc=0.4), make_entry("c", 5, pr_auc=NAN)])
    assert ranks(board) == [(1, "b"), (2, "a"), (3, "c")]


def test_where_both_are_equal_the_rank_is_shared(make_entry):
    (board,) = boards([make_entry("c", 1), make_entry("b", 5), make_entry("a", 5)])
    assert ranks(board) == [(1, "a"), (1, "b"), (3, "c")]


def test_ties_are_those_of_mcnemars_test_on_the_same_queries(make_entry):
    flags = np.arange(40)
    best, close, far = flags < 30, (flags > 2) & (flags < 31), flags < 20
    (board,) = boards([make_entry("best", best), make_entry("close", close), make_entry("far", far)])
    assert [(one.entry.method, one.tied) for one in board.standings] == [
        ("best", True),
        ("close", True),
        ("far", False),
    ]
    assert [one.p_value for one in board.standings] == [
        None,
        mcnemar(best, close).p_value,
        mcnemar(best, far).p_value,
    ]
    assert board.standings[2].p_value < 0.05 <= board.standings[1].p_value


def test_a_method_takes_one_rank_on_all_machines_by_its_newest_row(make_entry):
    (board,) = boards(
        [
            make_entry("a", 9, machine="00000001"),
            make_entry("a", 6, machine="00000002", created="2026-05-05T00:00:00+00:00"),
            make_entry("b", 8),
            make_entry("c", 1),
        ]
    )
    assert ranks(board) == [(1, "b"), (2, "a"), (2, "a"), (3, "c")]
    assert [one.entry.machine for one in board.standings if one.entry.method == "a"] == ["00000002", "00000001"]


def test_of_two_machines_the_newest_row_decides_however_many_answers_it_kept(make_entry):
    newest = make_entry("a", 6, machine="00000002", created="2026-05-05T00:00:00+00:00", k=1)
    (board,) = boards([make_entry("a", 9, machine="00000001", k=20), newest, make_entry("b", 8)])
    assert ranks(board) == [(1, "b"), (2, "a"), (2, "a")]


def test_partial_rows_and_those_without_recall_come_last_without_a_rank(make_entry):
    (board,) = boards([make_entry("p", 9, partial=True), make_entry("b", 2)])
    assert ranks(board) == [(1, "b"), (None, "p")]
    assert not board.standings[1].tied
    assert board.standings[1].p_value is None
    (board,) = boards([make_entry("e", [])])
    assert ranks(board) == [(None, "e")]


def test_real_editions_first_then_simulated_ones(make_entry):
    protocols = ["b:simulated/x-y@1f", "a:simulated/x-y@1f", "b:64x32/x-y@1f", "b/x-y@1f", "b/x-y@2f"]
    found = boards([make_entry(protocol=protocol) for protocol in protocols])
    assert [str(board.protocol) for board in found] == [
        "b/x-y@1f",
        "b/x-y@2f",
        "b:64x32/x-y@1f",
        "a:simulated/x-y@1f",
        "b:simulated/x-y@1f",
    ]
    assert [board.simulated for board in found] == [False, False, False, True, True]


@given(st.permutations(range(6)), st.lists(st.integers(0, 10), min_size=6, max_size=6))
def test_the_order_of_rows_does_not_matter(make_entry, order, right):
    entries = [make_entry("abc"[number % 3], right[number], machine=f"0000000{number}") for number in range(6)]
    (first,), (second,) = boards(entries), boards([entries[number] for number in order])
    assert [(one.rank, one.tied, one.entry.cell) for one in first.standings] == [
        (one.rank, one.tied, one.entry.cell) for one in second.standings
    ]


def test_rows_about_other_images_are_never_ranked_together(make_entry):
    with pytest.raises(DataError) as error:
        boards([make_entry("a"), make_entry("b", dataset_digest="sha256:ffff")])
    assert "sha256:ffff" in str(error.value)
    assert "sha256:0000" in str(error.value)


def test_nor_are_rows_about_other_queries(make_entry):
    with pytest.raises(DataError, match="different queries"):
        boards([make_entry("a"), make_entry("b", np.ones(9, bool))])


def test_some_of_the_queries_stand_beside_all_of_them(make_entry):
    (board,) = boards([make_entry("a"), make_entry("b", np.ones(4, bool), partial=True, n_available=10)])
    assert len(board.standings) == 2


@pytest.mark.parametrize(("elsewhere", "fair"), [(0.0, True), (BUSY, True), (BUSY + 0.01, False), (None, False)])
def test_latency_is_fair_where_the_machine_did_little_else(make_entry, elsewhere, fair):
    (board,) = boards([make_entry(elsewhere=elsewhere)])
    assert board.standings[0].fair_latency is fair


def test_latency_that_was_not_measured_is_not_fair(make_entry):
    assert not boards([make_entry(latency={})])[0].standings[0].fair_latency


def test_published_numbers_stand_on_the_real_edition_only(make_entry):
    protocols = [f"gardens{edition}/day_left-night_right@2f" for edition in ("", ":simulated")]
    real, simulated = boards([make_entry(protocol=protocol) for protocol in protocols])
    card = DATASETS.entry("gardens").load()
    assert [one.method for one in real.published] == [one.method for one in card.published]
    assert simulated.published == []


def test_a_dataset_that_is_gone_has_nothing_published(make_entry):
    assert boards([make_entry(protocol="long-gone/a-b@2f")])[0].published == []


def test_the_front_holds_what_nothing_beats_in_both(make_entry):
    (board,) = boards(
        [
            make_entry("fast", 3, total=1.0),
            make_entry("slower and worse", 2, total=2.0),
            make_entry("as good and slower", 3, total=2.0),
            make_entry("good", 8, total=5.0),
            make_entry("busy", 9, total=0.1, elsewhere=0.5),
            make_entry("another machine", 10, total=0.1, machine="ffffffff"),
            make_entry("partial", 10, total=0.1, partial=True),
        ]
    )
    assert [one.entry.method for one in pareto(board, "0123abcd")] == ["fast", "good"]
    assert [one.entry.method for one in pareto(board, "ffffffff")] == ["another machine"]
    assert pareto(board, "00000000") == []
