"""What answers queries once it is fitted, in the same steps whether its parts share one trunk or not."""

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.spatial.cells import Cells
from vpr_baselines.twostage.components import Answers
from vpr_bench.types.clusters import Clusters


@dataclass(frozen=True, eq=False)
class Query:
    """An image as stage one's pass through its network sees it.

    Attributes
    ----------
    image : (H, W, 3) uint8
        RGB.
    descriptor : (D,) float32
        Global.
    cells : Cells, optional
        Local, if they are used.
    """

    image: NDArray[np.uint8]
    descriptor: NDArray[np.float32]
    cells: Cells | None = None


class System(Protocol):
    """The fitted parts."""

    @property
    def clusters(self) -> Clusters:
        """Which references belong to which component."""
        ...

    def encode(self, image: NDArray[np.uint8]) -> Query:
        """Pass one (H, W, 3) uint8 RGB image through stage one's network."""
        ...

    def rank(self, query: Query) -> NDArray[np.float32]:
        """Return stage one's (C,) logits of the clusters."""
        ...

    def answers(self, query: Query, triggered: NDArray[np.int64], best: int | None) -> Answers:
        """Let each triggered component name its ``best`` references."""
        ...

    def scores(self, query: Query, candidates: NDArray[np.int64]) -> NDArray[np.float32]:
        """Return the (K,) similarities of the query to candidates, higher is better."""
        ...

    def save(self, folder: Path) -> None:
        """Write everything into an existing folder."""
        ...
