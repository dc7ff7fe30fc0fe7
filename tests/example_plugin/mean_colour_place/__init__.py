"""An example of a method for vpr-bench in a package of its own."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from vpr_bench import Match, Traverse


@dataclass
class MeanColour:
    """Compares the mean colours of a grid of cells.

    Parameters
    ----------
    cells : int
        Rows and columns of the grid.
    """

    cells: int = 4

    def fit(self, references: Traverse) -> None:
        """Describe every reference."""
        self.database_ = np.stack([self._describe(image) for image in references])

    def match(self, image: np.ndarray, k: int) -> Match:
        """Answer with the references of most similar colours; the score is minus the Euclidean distance."""
        return Match.from_scores(-np.linalg.norm(self.database_ - self._describe(image), axis=1), k)

    def _describe(self, image: np.ndarray) -> Any:
        rows = np.array_split(image.astype(np.float32), self.cells)
        return np.concatenate([cell.mean((0, 1)) for row in rows for cell in np.array_split(row, self.cells, axis=1)])
