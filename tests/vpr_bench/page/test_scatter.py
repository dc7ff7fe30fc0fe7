"""Times are compared on one machine, and only where they were fairly measured."""

import pytest

from vpr_bench.page.scatter import scatters


@pytest.fixture(scope="module")
def board(make_run, make_boards):
    return make_boards(
        make_run("slow and right", wrong=1, seed=6),
        make_run("fast and wrong", wrong=9, seed=1),
        make_run("slow and wrong", wrong=9, seed=7),
        make_run("elsewhere", wrong=2, seed=2, memory=32),
        make_run("busy", wrong=3, seed=3, elsewhere=0.4, memory=64),
        make_run("not noted", wrong=4, seed=4, elsewhere=None),
    ).boards[0]


def test_each_machine_has_a_chart_of_what_it_measured_fairly(board):
    letters = {one.entry.machine: one.entry.method[0] for one in board.standings}
    found = scatters(board, letters)
    assert [[one.entry.method for one in chart.standings] for chart in found] == [
        ["fast and wrong", "slow and right", "slow and wrong"],
        ["elsewhere"],
    ]


def test_the_front_holds_what_nothing_beats_in_both(board):
    first = scatters(board, {one.entry.machine: "A" for one in board.standings})[0].as_dict()
    assert {one["method"]: one["front"] for one in first["points"]} == {
        "fast and wrong": True,
        "slow and right": True,
        "slow and wrong": False,
    }
    assert all(one["low"] <= one["recall"] <= one["high"] for one in first["points"])
