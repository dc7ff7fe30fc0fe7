import numpy as np
import pytest

from vpr_bench.envs.exchange import Batch, in_words, spans
from vpr_bench.envs.judge import Judge


def batch_of(case, *references):
    """Answer the queries from the first one on, each with one reference or, with -1, with none."""
    queries, indices = np.arange(len(references)), np.array(references)[:, None]
    scores = np.where(indices >= 0, np.float32(0.5), -np.inf).astype(np.float32)
    judged = Judge(case.ground_truth, case.protocol.unmatched)(queries, indices)
    return Batch(queries, indices, scores, judged, asked=10, earned=7)


def test_the_tally_counts_on(make_case):
    rows = batch_of(make_case(), 0, 5, 2)
    assert [(rows.row(make_case(), row).asked, rows.row(make_case(), row).earned) for row in range(3)] == [
        (11, 8),
        (12, 8),
        (13, 9),
    ]


@pytest.mark.parametrize(
    ("unmatched", "answered", "lost", "unanswered"),
    [
        ("exclude", "not counted", "not counted", "no answer"),
        ("miss", "wrong", "no answer", "no answer"),
        ("reject", "wrong", "right", "no answer"),
    ],
)
def test_verdicts(make_case, unmatched, answered, lost, unanswered):
    case = make_case(unmatched=unmatched)
    verdicts = [batch_of(case, 0, 5, -1, 3, last).row(case, row).verdict for last in (4, -1) for row in (0, 1, 2, 4)]
    assert verdicts == ["right", "wrong", unanswered, answered, "right", "wrong", unanswered, lost]


def test_words(make_case):
    case = make_case()
    rows = batch_of(case, 1, -1, 7, 0, 0)
    lines = [in_words(case, rows.row(case, row)) for row in range(5)]
    assert lines[0] == "11/5 right       0 (winter[0]) → 1 (summer[1]) 0.5, truth 0–1"
    assert lines[1] == "12/5 no answer   1 (winter[1]) → nothing, truth 0–2"
    assert lines[4].endswith("truth none")


def test_words_before_the_first_answer_tell_nothing(make_case):
    assert in_words(make_case(), None) == "plain/summer-winter@1f: 5 queries, none answered yet"


def test_many_spans_are_cut_off():
    assert spans(np.array([1, 3, 5, 7, 8])) == "1, 3, 5, …"
