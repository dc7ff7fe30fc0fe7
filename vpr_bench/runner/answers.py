"""The growing table of what a method answered, how long it took, and what was in the running on the way."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.types.match import Match
from vpr_bench.types.survivors import Shortlist, from_arrays, gathered, to_arrays

_FIRST_STAGES = ("decode", "encode", "match", "rerank")
SECONDS = "seconds."
"""What the names of timing arrays start with, so that a stage may be called anything."""


@dataclass
class AnswerTable:
    """Answers by query, in the order in which they came.

    Parameters
    ----------
    k : int
        Answers kept per query.
    """

    k: int
    matches: dict[int, Match] = field(default_factory=dict)
    seconds: dict[int, dict[str, float]] = field(default_factory=dict)
    shortlists: dict[int, dict[str, Shortlist]] = field(default_factory=dict)

    def add(
        self,
        query: int,
        match: Match,
        seconds: Mapping[str, float],
        shortlists: Mapping[str, Shortlist] | None = None,
    ) -> None:
        """Keep the answer to one query, the seconds of each of its stages, and its shortlists."""
        self.matches[query] = match
        self.seconds[query] = dict(seconds)
        self.shortlists[query] = dict(shortlists or {})

    def match_arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return ``queries`` (n,) ascending, ``indices`` (n, k) padded with -1, ``scores`` padded with -inf.

        The order in which queries were asked leaves no trace, so equal answers give equal bytes.
        """
        queries = sorted(self.matches)
        indices = np.full((len(queries), self.k), -1, dtype=np.int64)
        scores = np.full((len(queries), self.k), -np.inf, dtype=np.float32)
        for row, query in enumerate(queries):
            match = self.matches[query]
            indices[row, : len(match)] = match.indices
            scores[row, : len(match)] = match.scores
        return {"queries": np.array(queries, dtype=np.int64), "indices": indices, "scores": scores}

    def timing_arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return ``seconds.<stage>`` (n,) float64 for each stage, rows as in :meth:`match_arrays`."""
        names = {name for row in self.seconds.values() for name in row}
        ordered = [name for name in _FIRST_STAGES if name in names] + sorted(names.difference(_FIRST_STAGES))
        rows = [self.seconds[query] for query in sorted(self.seconds)]
        return {SECONDS + name: np.array([row.get(name, 0.0) for row in rows]) for name in ordered}

    def shortlist_arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return what was left after each step, rows as in :meth:`match_arrays`; nothing if none was noted."""
        return to_arrays(gathered([self.shortlists[query] for query in sorted(self.shortlists)]))

    def save(self, path: Path) -> None:
        """Write everything into one file, to continue from."""
        write_arrays(path, {**self.match_arrays(), **self.timing_arrays(), **self.shortlist_arrays()})

    @classmethod
    def load(cls, path: Path, k: int) -> "AnswerTable":
        """Read what :meth:`save` wrote.

        Raises
        ------
        DataError
            If the file is damaged.
        """
        table = cls(k)
        arrays = read_arrays(path, "queries", "indices", "scores")
        columns = {name[len(SECONDS) :]: array for name, array in arrays.items() if name.startswith(SECONDS)}
        with blaming(f"{path} is damaged", DataError):
            steps = from_arrays(arrays, len(arrays["queries"]))
            for row, query in enumerate(arrays["queries"].tolist()):
                answered = arrays["indices"][row] >= 0
                match = Match(arrays["indices"][row][answered], arrays["scores"][row][answered])
                seconds = {name: float(column[row]) for name, column in columns.items()}
                table.add(query, match, seconds, {step.step: step[row] for step in steps})
        return table
