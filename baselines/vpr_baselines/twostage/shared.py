"""The system whose parts share one trunk: a query costs one pass through it, however many components it triggers."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import load_file, save

from vpr_baselines.twostage.components import Answers, Components
from vpr_baselines.twostage.confidence import Confidence
from vpr_baselines.twostage.description import Description
from vpr_baselines.twostage.encoder import Encoder, Look
from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.report import TrainingReport
from vpr_baselines.twostage.reranking import Rerank, without_rival
from vpr_baselines.twostage.system import Query
from vpr_bench.errors import DataError, blaming
from vpr_bench.types.clusters import Clusters

_LEARNT, _REPORT = "learnt.safetensors", "training.json"


@dataclass(eq=False)
class SharedSystem:
    """One trunk, one linear layer for stage one, and one for all components.

    Attributes
    ----------
    encoder : Encoder
        The trunk, and what was learnt about its responses.
    description : Description
        Of the references.
    stage_one : LinearHead
        Descriptor → cluster.
    components : Components
        Descriptor → reference within the cluster; of half precision.
    report : TrainingReport
        How they were trained.
    confidence : Confidence
        From similarity to score.
    rerank : Rerank
        What the similarity is.
    """

    encoder: Encoder
    description: Description
    stage_one: LinearHead
    components: Components
    report: TrainingReport
    rerank: Rerank
    confidence: Confidence = field(default_factory=lambda: Confidence(1.0, 0.0))

    @property
    def clusters(self) -> Clusters:
        """Which references belong to which component."""
        return self.components.clusters

    def encode(self, image: NDArray[np.uint8]) -> Query:
        """Pass one (H, W, 3) uint8 RGB image through the trunk."""
        if self.rerank == "cosine":
            return Query(image, self.encoder.describe([image])[0])
        return Query(image, *self.encoder.encode(image))

    def rank(self, query: Query) -> NDArray[np.float32]:
        """Return stage one's (C,) logits of the clusters."""
        return self.stage_one.logits(query.descriptor)

    def answers(self, query: Query, triggered: NDArray[np.int64], best: int | None) -> Answers:
        """Let each triggered component name its ``best`` references."""
        return self.components.answers(query.descriptor, triggered, best)

    def similarities(self, query: Query, candidates: NDArray[np.int64]) -> NDArray[np.float32]:
        """Return the (K,) similarities of the query to candidates."""
        cosines = self.description.cosines(query.descriptor, candidates)
        if query.cells is None:
            return cosines
        return self.description.local.similarities(query.cells, candidates, cosines)

    def scores(self, query: Query, candidates: NDArray[np.int64]) -> NDArray[np.float32]:
        """Return the confidence in each candidate, in (0, 1): (K,) float32."""
        return self.confidence.of(without_rival(self.similarities(query, candidates), candidates))

    def save(self, folder: Path) -> None:
        """Write everything into an existing folder: what is large in files that can be memory-mapped."""
        arrays = {
            **self.encoder.arrays(),
            "labels": self.clusters.labels,
            "stage_one.weight": self.stage_one.weight,
            "stage_one.bias": self.stage_one.bias,
            "components.bias": self.components.head.bias,
            "confidence": np.array([self.confidence.slope, self.confidence.offset]),
        }
        # safetensors writes an array's memory as it lies there, column by column for some.
        tensors = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
        (folder / _LEARNT).write_bytes(save(tensors))  # its own save_file leaves files that others cannot read
        large = {**self.description.arrays(), "components": self.components.head.weight}
        for name, array in large.items():
            np.save(folder / f"{name}.npy", array, allow_pickle=False)
        (folder / _REPORT).write_text(self.report.model_dump_json(), "utf-8")

    @classmethod
    def load(cls, folder: Path, look: Look, rerank: Rerank) -> "SharedSystem":
        """Read what :meth:`save` wrote; of what is large, nothing yet.

        Raises
        ------
        DataError
            If files are missing or damaged, or do not belong together.
        """
        with blaming(f"The map in {folder} is damaged; fit it again", DataError):
            # Copies: torch takes no memory that it must not write to.
            learnt = {name: np.array(array) for name, array in load_file(folder / _LEARNT).items()}
            names = ("descriptors", "cells", "positions", "components")
            large = {name: np.load(folder / f"{name}.npy", mmap_mode="r", allow_pickle=False) for name in names}
            clusters = Clusters(learnt["labels"])
            counts = {len(array) for array in large.values()} | {len(clusters.labels), len(learnt["components.bias"])}
            if len(counts) != 1 or len(learnt["stage_one.weight"]) != len(clusters):
                raise ValueError(f"its parts are of {sorted(counts)} references")
            slope, offset = learnt["confidence"].tolist()
            encoder = Encoder.from_arrays(look, learnt)
            return cls(
                encoder,
                Description.from_arrays(large, encoder.cells.shape),
                LinearHead(learnt["stage_one.weight"], learnt["stage_one.bias"]),
                Components(clusters, LinearHead(large["components"], learnt["components.bias"])),
                TrainingReport.model_validate_json((folder / _REPORT).read_text("utf-8")),
                rerank,
                Confidence(slope, offset),
            )
