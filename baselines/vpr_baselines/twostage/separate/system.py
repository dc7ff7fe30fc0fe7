"""The system as the thesis has it: a whole network per part, candidates compared by what stage one's answers."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import load_file, save

from vpr_baselines.matrices import product
from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage.components import Answers
from vpr_baselines.twostage.report import TrainingReport
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.networks import SeparateNetworks
from vpr_baselines.twostage.system import Query
from vpr_bench.errors import DataError, blaming
from vpr_bench.types.clusters import Clusters

_DATABASE, _REPORT = "database.safetensors", "training.json"


@dataclass(eq=False)
class SeparateSystem:
    """Networks, and the references' descriptors.

    Attributes
    ----------
    networks : SeparateNetworks
        One for stage one and one per component.
    database : (n, D) float32
        What stage one's network answers to the references, of unit length.
    report : TrainingReport
        How they were trained.
    """

    networks: SeparateNetworks
    database: NDArray[np.float32]
    report: TrainingReport

    @property
    def clusters(self) -> Clusters:
        """Which references belong to which component."""
        return self.networks.clusters

    def encode(self, image: NDArray[np.uint8]) -> Query:
        """Pass one (H, W, 3) uint8 RGB image through stage one's network."""
        return Query(image, self.networks.describe(image))

    def rank(self, query: Query) -> NDArray[np.float32]:
        """Return stage one's (C,) logits of the clusters."""
        return self.networks.rank(query.descriptor)

    def answers(self, query: Query, triggered: NDArray[np.int64], best: int | None) -> Answers:
        """Pass the image through each triggered component, which names its ``best`` references."""
        return self.networks.answers(query.image, triggered, best)

    def scores(self, query: Query, candidates: NDArray[np.int64]) -> NDArray[np.float32]:
        """Return the cosine similarity of the query to each candidate, in [-1, 1]: (K,) float32."""
        return product(self.database[candidates], normalised(query.descriptor))

    def save(self, folder: Path) -> None:
        """Write everything into an existing folder."""
        (folder / _DATABASE).write_bytes(save({"database": self.database, "labels": self.clusters.labels}))
        (folder / _REPORT).write_text(self.report.model_dump_json(), "utf-8")
        self.networks.save(folder)

    @classmethod
    def load(cls, folder: Path, body: Body, *, finetune: bool) -> "SeparateSystem":
        """Read what :meth:`save` wrote.

        Raises
        ------
        DataError
            If files are missing or damaged, or do not belong together.
        """
        with blaming(f"The map in {folder} is damaged; fit it again", DataError):
            stored = load_file(folder / _DATABASE)
            report = TrainingReport.model_validate_json((folder / _REPORT).read_text("utf-8"))
            networks = SeparateNetworks.load(folder, Clusters(stored["labels"]), body, finetune=finetune)
            if len(stored["database"]) != len(networks.clusters.labels):
                raise ValueError("its parts are of different maps")
        return cls(networks, stored["database"], report)
