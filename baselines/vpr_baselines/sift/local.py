"""References ranked by how many key points of the query match theirs."""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.sift.keypoints import KeyPoints, detect
from vpr_baselines.sift.ratio_test import KeyPointMap, Pairs
from vpr_baselines.sift.verification import Geometry, consistent
from vpr_bench.progress import track
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse


@dataclass
class LocalMatching:
    """What :class:`~vpr_baselines.sift.method.Sift` does in the mode ``local``; the parameters are described there."""

    size: int
    n_features: int
    ratio: float
    verify: Geometry | None
    n_verified: int

    def fit(self, references: Traverse) -> None:
        """Detect the key points of every reference."""
        self.map_ = KeyPointMap(len(references), self.n_features)
        for index, image in enumerate(track(references, "Detecting key points of references")):
            self.map_.put(index, self._detect(image))

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with the ``k`` references of most matches; those without any are no answer."""
        with stage("encode"):
            points = self._detect(image)
        with stage("match"):
            found = self.map_.best(points, self.ratio, k if self.verify is None else self.n_verified)
        if self.verify is None:
            return _ranked(found, k)
        with stage("rerank"):
            best = _ranked(found, self.n_verified).indices.tolist()
            return _ranked({index: self._verified(points, index, found[index]) for index in best}, k)

    def scores(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the score of every reference before any verification, 0 without a match: (N,) float32."""
        scores = np.zeros(len(self.map_), dtype=np.float32)
        for index, pairs in self.map_.best(self._detect(image), self.ratio, len(self.map_)).items():
            scores[index] = pairs.score
        return scores

    def save(self, folder: Path) -> None:
        """Write the key points of the map."""
        self.map_.save(folder)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        self.map_ = KeyPointMap.load(folder)
        return self

    def _detect(self, image: NDArray[np.uint8]) -> KeyPoints:
        return detect(image, self.size, self.n_features)

    def _verified(self, points: KeyPoints, index: int, pairs: Pairs) -> Pairs:
        assert self.verify is not None  # noqa: S101
        places = points.positions[pairs.query], self.map_.positions(index)[pairs.reference]
        kept = consistent(*places, self.verify)
        return Pairs(pairs.query[kept], pairs.reference[kept], pairs.similarities[kept])


def _ranked(found: dict[int, Pairs], k: int) -> Match:
    """Rank references by score, those of equal score in the order of the map."""
    indices = np.array(sorted(index for index in found if found[index].score > 0), dtype=np.int64)
    return Match.from_scores([found[index].score for index in indices.tolist()], k, indices)
