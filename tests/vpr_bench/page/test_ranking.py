"""The table says what the board says, and blanks what must not be shown."""

import re

import pytest

from vpr_bench.page.ranking import COLUMNS, METRICS, Ranking, ranking

LETTERS = 2


@pytest.fixture(scope="module")
def table(made) -> Ranking:
    board = made.boards[0]
    return ranking(board, {one.entry.machine: letter for one, letter in zip(board.standings, "ABABA", strict=False)})


def test_there_is_a_row_for_each_method_and_each_published_number(table):
    assert [line.kind for line in table.lines] == ["ranked"] * 4 + ["unranked", "published"]
    assert [line.rank for line in table.lines] == ["1", "2", "3", "4", "", ""]
    assert all(len(line.cells) == len(METRICS) + 2 == len(COLUMNS) - 3 for line in table.lines)


def test_values_have_intervals_and_an_order(table):
    cell = table.lines[0].cells[0]
    assert cell.text == "0.917" and float(cell.order) == pytest.approx(11 / 12)
    assert cell.interval.low < 11 / 12 < cell.interval.high
    assert re.fullmatch(r"\.\d{3}–(\.\d{3}|1\.00)", cell.between)
    assert [cell.text for cell in table.lines[0].cells[2:3]] == ["–"]  # recall@10 of 5 answers


def test_the_partial_row_is_blank_and_says_why(table):
    line = table.lines[4]
    assert {cell.text for cell in line.cells} == {""}
    assert line.marks == ["partial: 3 of 12 queries"]


def test_a_time_that_was_measured_on_a_busy_machine_is_blank(table):
    times = {line.method: [cell.text for cell in line.cells[-2:]] for line in table.lines}
    assert times["busy"] == ["", ""]
    assert all(times["best"])
    assert table.has_blank_times


def test_what_uses_several_frames_is_marked(table):
    [second] = [line for line in table.lines if line.method == "second"]
    assert (second.marks, second.frames) == (["sequence"], "several")
    assert table.has_both


def test_ties_are_marked_and_the_best_is_not(table):
    assert not table.lines[0].tied
    assert any(line.tied for line in table.lines[1:4])
    assert not any(line.tied for line in table.lines[4:])


def test_a_published_number_has_a_source_and_no_rank(table):
    published = table.lines[-1]
    assert table.sources == ["<i>who</i>, radius not stated"]
    assert (published.source, published.rank, published.machine) == (1, "", "")
    assert [cell.text for cell in published.cells] == ["", "", "", "0.990", "", "", ""]
