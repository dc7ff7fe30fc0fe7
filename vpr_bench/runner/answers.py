"""The growing table of what a method answered and how long it took."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.types.match import Match

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

    def add(self, query: int, match: Match, seconds: Mapping[str, float]) -> None:
        """Keep the answer to one query and the seconds of each of its stages."""
        self.matches[query] = match
        self.seconds[query] = dict(seconds)

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

    def save(self, path: Path) -> None:
        """Write everything into one file, to continue from."""
        write_arrays(path, {**self.match_arrays(), **self.timing_arrays()})

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
            for row, query in enumerate(arrays["queries"].tolist()):
                answered = arrays["indices"][row] >= 0
                match = Match(arrays["indices"][row][answered], arrays["scores"][row][answered])
                table.add(query, match, {name: float(column[row]) for name, column in columns.items()})
        return table
