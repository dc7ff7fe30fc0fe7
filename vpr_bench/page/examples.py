"""Which answers of a run are worth looking at: where it was sure and wrong, and where it was right by little."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import without_soft
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Protocol

Ranked = tuple[NDArray[np.int64], NDArray[np.floating]]

FAILURES, SUCCESSES = 9, 3
"""How many of each are shown of a run."""


@dataclass(frozen=True)
class Example:
    """One query and what a run said to it.

    Attributes
    ----------
    query : int
        In the numbering of the query traverse.
    answer : int or None
        The reference that was put first; None if nothing was answered.
    score : float or None
        Of that answer.
    truth : int or None
        The true match nearest to the query; None if it has none.
    truth_rank : int or None
        Its place among the answers, from 1; None if it is not among those that are kept.
    truth_score : float or None
        The score it was given there.
    away : float or None
        How far the answer lies from the query, in frames or metres; None where places are measured otherwise.
    """

    query: int
    answer: int | None
    score: float | None
    truth: int | None
    truth_rank: int | None
    truth_score: float | None
    away: float | None


@dataclass(frozen=True)
class Examples:
    """The most confident failures, most confident first, and the least confident successes, least confident first."""

    failures: list[Example]
    successes: list[Example]


def examples_of(run: StoredRun, protocol: Protocol) -> Examples:
    """Choose the examples of a run; parameters and errors are those of :func:`vpr_bench.report.rows.score_run`."""
    answers = answers_of(run, protocol)
    truth = run.places.ground_truth(protocol)
    rows = np.searchsorted(run.queries, answers.queries)
    rejected = (protocol.unmatched == "reject") & ~answers.has_match & ~answers.answered
    wrong = np.flatnonzero(~answers.correct & ~rejected)
    wrong = wrong[np.argsort(-answers.score[wrong], kind="stable")][:FAILURES]
    right = np.flatnonzero(answers.correct)
    right = right[np.argsort(answers.score[right], kind="stable")][:SUCCESSES]
    ranked = without_soft(run.indices, run.scores, truth)
    shown = [[_example(run, protocol, truth, ranked, int(row)) for row in rows[chosen]] for chosen in (wrong, right)]
    return Examples(*shown)


def _example(run: StoredRun, protocol: Protocol, truth: GroundTruth, ranked: Ranked, row: int) -> Example:
    indices, scores = ranked[0][row], ranked[1][row]
    answer = int(indices[0]) if indices[0] >= 0 else None
    true = run.places.nearest_of(row, truth[row]) if len(truth[row]) else None
    found = np.flatnonzero(indices == true) if true is not None else np.empty(0, np.int64)
    measured = answer is not None and protocol.unit in ("f", "m")
    return Example(
        query=int(run.queries[row]),
        answer=answer,
        score=None if answer is None else float(scores[0]),
        truth=true,
        truth_rank=int(found[0]) + 1 if len(found) else None,
        truth_score=float(scores[found[0]]) if len(found) else None,
        away=float(run.places.distances(row, np.array([answer]))[0]) if measured else None,
    )
