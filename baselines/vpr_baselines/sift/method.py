"""SIFT as a method, in two modes."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.indexes import IndexName, Metric
from vpr_baselines.sift.descriptor import StackedSift
from vpr_baselines.sift.local import LocalMatching
from vpr_baselines.sift.verification import Geometry
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse


@dataclass(kw_only=True)
class Sift:
    """SIFT key points (Lowe, IJCV 2004): matched one by one, or stacked into one vector.

    The mode ``local`` compares RootSIFT (Arandjelović and Zisserman, CVPR 2012). A key point of the query matches a
    reference if its nearest descriptor there is clearly nearer than the second nearest; a reference's score is the
    number of matches plus their mean similarity, which only decides between equal numbers. References without a
    match are no answer, so a query without key points has none.

    The mode ``descriptor`` is what the thesis clustered (ch. 2), by its preset ``thesis``: SIFT of 128 key points one
    after the other, zeros where there are fewer, by Manhattan distance.

    Parameters
    ----------
    mode : {"local", "descriptor"}
        Which of the two.
    size : int
        Images are resized to a longer side of so many pixels.
    n_features : int
        At most so many key points of an image, those of highest contrast.
    ratio : float
        Local: of the distances to the nearest and the second nearest; 1 accepts every nearest.
    verify : {"homography", "fundamental"}, optional
        Local: count only the matches that one such matrix explains, found by RANSAC, and answer with nothing but
        verified references. Where neighbouring places are seen alike, as in Gardens Point, it tells them apart less
        well than the number of matches does.
    n_verified : int
        Local: how many references with the most matches are verified.
    metric : {"manhattan", "euclidean", "cosine"}
        Descriptor: what the score is.
    index : {"exact", "hnsw", "ivf"}
        Descriptor: how the map is searched.
    """

    version: ClassVar[str] = "1"
    presets: ClassVar[dict[str, dict[str, Any]]] = {
        "thesis": {"mode": "descriptor", "n_features": 128, "metric": "manhattan"},
    }

    mode: Literal["local", "descriptor"] = "local"
    size: Annotated[int, Field(ge=16)] = 480
    n_features: Annotated[int, Field(ge=1)] = 500
    ratio: Annotated[float, Field(gt=0, le=1)] = 0.8
    verify: Geometry | None = None
    n_verified: Annotated[int, Field(ge=1)] = 20
    metric: Metric = "manhattan"
    index: IndexName = "exact"

    def __post_init__(self) -> None:
        """Choose the mode.

        Raises
        ------
        ValueError
            If the index knows no such metric.
        UsageError
            If FAISS is needed and not installed.
        """
        self._engine: LocalMatching | StackedSift
        if self.mode == "local":
            self._engine = LocalMatching(self.size, self.n_features, self.ratio, self.verify, self.n_verified)
        else:
            self._engine = StackedSift(self.size, self.n_features, metric=self.metric, index=self.index)

    @property
    def may_answer_fewer(self) -> str:
        """Why there can be fewer answers than were asked for."""
        return "references without a match are no answer" if self.mode == "local" else ""

    def fit(self, references: Traverse) -> None:
        """Describe every reference."""
        self._engine.fit(references)

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with the ``k`` references of highest score."""
        return self._engine.match(image, k)

    def scores(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the (N,) float32 scores of all references."""
        return self._engine.scores(image)

    def save(self, folder: Path) -> None:
        """Write the map."""
        self._engine.save(folder)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        self._engine.load(folder)
        return self
