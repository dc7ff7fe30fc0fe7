"""What the harness asks of a method, and the optional capabilities it looks for."""

from pathlib import Path
from typing import Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse


@runtime_checkable
class Method(Protocol):
    """Fitted on references, shown queries one at a time, answers with ranked places.

    Its constructor only stores parameters (a dataclass does), which must be JSON-able; what it learns in
    ``fit`` ends in ``_``. It never sees place labels.
    """

    def fit(self, references: Traverse) -> None:
        """Learn the map. Fitting again forgets the former map."""
        ...

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer one (H, W, 3) uint8 RGB query with at most ``k`` references, best first."""
        ...


@runtime_checkable
class Persistent(Protocol):
    """A method whose fitted state can be kept on disk."""

    def save(self, folder: Path) -> None:
        """Write what ``fit`` learnt into an existing empty folder."""
        ...

    def load(self, folder: Path) -> Self:
        """Restore what :meth:`save` wrote into a method of the same parameters; return it."""
        ...


@runtime_checkable
class Weighted(Protocol):
    """A method that uses pre-trained weights."""

    def weights_digest(self) -> str:
        """Return what identifies the weights, as ``name sha256:…``, without loading them into memory twice."""
        ...
