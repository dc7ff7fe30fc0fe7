from dataclasses import replace

from vpr_bench.gate.verdict import Changed, Judgement, Verdict
from vpr_bench.gate.words import SHOWN, advice, failure, listed, moved


def test_a_failure_says_what_fell_and_which_queries(failing):
    told = failure(failing.verdicts[1])
    assert told.startswith("fails on gardens/day_left-day_right@0f: fail")
    assert "recall@1 fell by" in told
    assert "recall@1: 0." in told
    assert "0 (day_right/Image000.jpg: 0 → 30)" in told
    assert "and " in told
    assert "more" in told


def test_only_the_first_queries_are_listed():
    many = Verdict("a", "b", "fail", lost=range(50), changed=[Changed(query, 1, -1) for query in range(90)])
    listed = dict(moved(many))
    assert listed["lost"].count("→ none") == SHOWN
    assert listed["lost"].endswith("and 30 more")
    assert listed["answered otherwise"].startswith("50 (1 → none)")
    assert listed["answered otherwise"].endswith("and 20 more")


def test_nothing_in_a_name_moves_the_cursor(failing, hostile):
    verdict = replace(failing.verdicts[1], label=hostile, names=dict.fromkeys(range(200), hostile), reasons=[hostile])
    told = failure(verdict)
    assert "\x1b" not in told
    assert "\x00" not in told


def test_what_can_be_done(failing):
    assert advice(failing) == ["The baseline does not hold what is new: --update records it."]
    assert advice(Judgement([failing.verdicts[2]])) == []


def test_what_is_not_listed_is_not_written():
    written = []
    assert listed(range(10**6), lambda number: written.append(number) or "x").endswith("x and 999980 more")
    assert written == list(range(SHOWN))
