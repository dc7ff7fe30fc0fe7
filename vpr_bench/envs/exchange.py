"""One query and what was answered to it, for people to look at."""

from dataclasses import dataclass
from itertools import groupby
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case
from vpr_bench.envs.judge import Judgement
from vpr_bench.errors import one_line
from vpr_bench.types.traverse import Traverse

Verdict = Literal["right", "wrong", "no answer", "not counted"]


@dataclass(frozen=True, eq=False)
class Exchange:
    """A query, its answer, and the truth.

    Attributes
    ----------
    query : int
        Index of the query.
    answer : int
        The reference that counts, -1 for none.
    score : float
        Of that answer.
    truth : (m,) int64
        The references that are right; empty if there is none.
    verdict : {"right", "wrong", "no answer", "not counted"}
        What became of it.
    asked, earned : int
        Queries of the episode so far, and the sum of their rewards.
    """

    query: int
    answer: int
    score: float
    truth: NDArray[np.int64]
    verdict: Verdict
    asked: int
    earned: int


@dataclass(frozen=True, eq=False)
class Batch:
    """The answers of one step, kept until somebody wants to look at them.

    Attributes
    ----------
    queries : (n,) int64
        What was asked.
    indices, scores : (n, k)
        What was answered.
    judged : Judgement
        What became of it.
    asked, earned : int
        Queries of the episode before this step, and the sum of their rewards.
    """

    queries: NDArray[np.int64]
    indices: NDArray[np.int64]
    scores: NDArray[np.float32]
    judged: Judgement
    asked: int
    earned: int

    def row(self, case: Case, row: int) -> Exchange:
        """Return one of the answers."""
        answer, truth = int(self.judged.answer[row]), self.judged.truth[row]
        score = float(self.scores[row][self.indices[row] == answer][0]) if answer >= 0 else float("-inf")
        verdict: Verdict = "wrong"
        if self.judged.reward[row]:
            verdict = "right"
        elif case.protocol.unmatched == "exclude" and not self.judged.has_match[row]:
            verdict = "not counted"
        elif answer < 0:
            verdict = "no answer"
        earned = self.earned + int(self.judged.reward[: row + 1].sum())
        return Exchange(int(self.queries[row]), answer, score, truth[truth >= 0], verdict, self.asked + row + 1, earned)


def in_words(case: Case, one: Exchange | None) -> str:
    """Describe it on one line; before the first answer, nothing is said that could help to give it."""
    if one is None:
        return f"{case.protocol}: {len(case.queries)} queries, none answered yet"
    query, answer = _name(case.queries, one.query), "nothing"
    if one.answer >= 0:
        answer = f"{_name(case.references, one.answer)} {one.score:.4g}"
    count = f"{one.asked:{len(str(len(case.queries)))}}/{len(case.queries)}"
    return f"{count} {one.verdict:11} {query} → {answer}, truth {spans(one.truth)}"


def spans(references: NDArray[np.int64], most: int = 3) -> str:
    """Write ascending indices as spans.

    Examples
    --------
    >>> spans(np.array([3, 4, 5, 9])), spans(np.array([], dtype=np.int64))
    ('3–5, 9', 'none')
    """
    numbers = references.tolist()
    groups = [[number for _, number in group] for _, group in groupby(enumerate(numbers), lambda one: one[1] - one[0])]
    written = [f"{group[0]}–{group[-1]}" if len(group) > 1 else str(group[0]) for group in groups]
    return ", ".join(written[:most] + (["…"] if len(written) > most else [])) or "none"


def _name(traverse: Traverse, index: int) -> str:
    return f"{index} ({one_line(traverse.name_of(index))})"
