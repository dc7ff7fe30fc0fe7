"""How often the right place is among the first answers, and how well the score tells right from wrong."""

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.counts import ratio


def recall_at_k(answers: Answers, k: int) -> NDArray[np.float64]:
    """Share of the queries that have a true match with one among the first ``k`` answers, in [0, 1].

    NaN where no query has a true match, and where ``k`` is deeper than the answers that are known.

    Examples
    --------
    >>> flags = np.array([True, False])
    >>> answers = Answers(flags, np.array([0.9, 0.8]), np.ones(2, bool), np.array([0, 4]))
    >>> float(recall_at_k(answers, 1)), float(recall_at_k(answers, 5))
    (0.5, 1.0)
    """
    if k > answers.depth:
        return np.full(answers.weight.shape[:-1], np.nan)[()]
    return ratio(answers.total(answers.expected & (answers.rank < k)), answers.total(answers.expected))


def accuracy(answers: Answers) -> NDArray[np.float64]:
    """Share of all queries that end well, in [0, 1]; NaN without queries.

    A right best match ends well and, where unmatched queries are to be rejected, so does no answer to one of
    them. Otherwise this is recall@1.
    """
    well = answers.correct
    if answers.unmatched == "reject":
        well = well | ~(answers.has_match | answers.answered)
    return ratio(answers.total(well), answers.weight.sum(axis=-1))


def roc_auc(answers: Answers) -> NDArray[np.float64]:
    """Chance that a right answer scores higher than a wrong one, ties counting half, in [0, 1].

    It is scikit-learn's ``roc_auc_score(correct, score)``: the negatives are the wrong answers, those to
    unmatched queries included. A query without an answer is a negative below all others. NaN where there is
    no right answer or no wrong one.
    """
    counts = answers.counts
    negatives = answers.total(~answers.correct)
    right = np.diff(counts.true_positives, axis=-1, prepend=0.0)
    above = counts.false_positives
    above_or_tied_half = above - np.diff(above, axis=-1, prepend=0.0) / 2
    wins = (right * (negatives[..., None] - above_or_tied_half)).sum(axis=-1)
    return ratio(wins, answers.total(answers.correct) * negatives)
