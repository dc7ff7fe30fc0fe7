"""What a baseline keeps of each query: enough to compute every metric of the best answers again."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.answers import NEVER, Answers
from vpr_bench.types.protocol import Unmatched

NONE, UNMATCHED = "-", "x"
"""What is written where there is no answer, and where the query has no true match."""

_NOTHING = -1


@dataclass(frozen=True, eq=False)
class Answered:
    """One row per query of the protocol, in the order of the traverse.

    Metrics do not change under a monotone rescaling of the scores, so that the order of the scores stands for them.

    Attributes
    ----------
    best : (n,) int64
        The reference that was answered first, -1 for none.
    rank : (n,) int64
        Position of the first right one among the ranked answers, from 0; ``NEVER`` when none.
    has_match : (n,) bool
        The query has a true match.
    order : (n,) int64
        How many distinct scores are lower than that of the best answer; -1 without an answer, and for queries that the
        protocol excludes.
    """

    best: NDArray[np.int64]
    rank: NDArray[np.int64]
    has_match: NDArray[np.bool_]
    order: NDArray[np.int64]

    @classmethod
    def of(cls, best: NDArray[np.int64], answers: Answers) -> "Answered":
        """Take what is kept from the answers of a whole run.

        Parameters
        ----------
        best : (n,) int64
            The first answers, -1 for none.
        answers : Answers
            Of the same run; queries that the protocol excludes are not among them.
        """
        rank, order = np.full(len(best), NEVER), np.full(len(best), _NOTHING)
        has_match = np.zeros(len(best), dtype=bool)
        rows = answers.queries
        rank[rows], has_match[rows] = answers.rank, answers.has_match
        answered = answers.answered
        order[rows[answered]] = np.unique(answers.score[answered], return_inverse=True)[1]
        return cls(best.astype(np.int64), rank, has_match, order)

    def answers(self, unmatched: Unmatched, depth: int) -> Answers:
        """Return what metrics are computed from; scores are their order.

        Parameters
        ----------
        unmatched : {"exclude", "miss", "reject"}
            The protocol's policy for queries without a true match.
        depth : int
            How many answers per query were known.
        """
        counted = np.flatnonzero(self.has_match) if unmatched == "exclude" else np.arange(len(self.best))
        order = self.order[counted]
        return Answers(
            correct=self.rank[counted] == 0,
            score=np.where(order == _NOTHING, -np.inf, order).astype(np.float64),
            has_match=self.has_match[counted],
            rank=self.rank[counted],
            unmatched=unmatched,
            depth=depth,
            queries=counted,
        )

    def texts(self) -> dict[str, list[str]]:
        """Return the columns as texts: ``best``, ``rank`` and ``score``."""
        ranks = zip(self.rank.tolist(), self.has_match.tolist(), strict=True)
        return {
            "best": [_text(value) for value in self.best.tolist()],
            "rank": [UNMATCHED if not known else NONE if rank == NEVER else str(rank) for rank, known in ranks],
            "score": [_text(value) for value in self.order.tolist()],
        }

    @classmethod
    def from_texts(cls, best: list[str], rank: list[str], score: list[str], *, n_references: int) -> "Answered":
        """Read what :meth:`texts` returned.

        Raises
        ------
        ValueError
            If a value is no number in its range, or the scores are not the order of some scores.
        """
        has_match = np.array([text != UNMATCHED for text in rank], dtype=bool)
        found = [NONE if text == UNMATCHED else text for text in rank]
        orders = np.array([_number(text, len(score)) for text in score], dtype=np.int64)
        distinct = np.unique(orders[orders != _NOTHING])
        if not np.array_equal(distinct, np.arange(len(distinct))):
            raise ValueError("the numbers under score leave some out")
        ranks = np.array([_number(text, n_references) for text in found], dtype=np.int64)
        return cls(
            np.array([_number(text, n_references) for text in best], dtype=np.int64),
            np.where(ranks == _NOTHING, NEVER, ranks),
            has_match,
            orders,
        )


def _text(value: int) -> str:
    return NONE if value == _NOTHING else str(value)


def _number(text: str, below: int) -> int:
    """Read a whole number in [0, below), -1 for none."""
    if text == NONE:
        return _NOTHING
    if not (text.isascii() and text.isdigit() and len(text) < 12 and int(text) < below):
        raise ValueError(f"{text!r:.40} is no whole number below {below}")
    return int(text)
