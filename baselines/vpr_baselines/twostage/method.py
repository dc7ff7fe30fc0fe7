"""The two-stage system of the thesis (ch. 4), with one trunk shared by all its parts."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from safetensors.numpy import load_file, save_file

from vpr_baselines.backbones.architectures import Backbone
from vpr_baselines.backbones.pooling import gem
from vpr_baselines.backbones.trunk import Trunk, load_trunk
from vpr_baselines.hog import Hog
from vpr_baselines.photometry import resized
from vpr_baselines.retrieval import normalised
from vpr_baselines.twostage.augment import augmented
from vpr_baselines.twostage.clusters import Clusters, by_count, by_similarity
from vpr_baselines.twostage.components import Components, train_components
from vpr_baselines.twostage.heads import LinearHead, train_head
from vpr_bench.progress import track
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse
from vpr_bench.weights.choice import choose_weights

AtLeastOne = Annotated[int, Field(ge=1)]

_CLUSTERING_HOG = Hog(width=224, height=224, cell=8)
_CLUSTER_SIZE = 12  # chosen on day_left-day_right and the simulated walk, where 5 to 25 hardly differ
_MAP_FILE = "map.safetensors"


@dataclass
class TwoStage:
    """Stage one picks clusters, components pick images inside them, cosine similarity re-ranks.

    Fitting cuts the reference sequence into clusters of similar HOG, enlarges it five-fold by augmentation,
    describes every image once by the frozen trunk, and learns one linear layer for stage one (image → cluster)
    and one per component (image → reference within the cluster). A query costs one pass through the trunk,
    whatever ``n_components`` is.

    Parameters
    ----------
    n_components : int
        How many of the best clusters trigger their component; more than there are triggers all.
    answers_per_component : int
        How many references each triggered component names.
    n_clusters : int, optional
        How many clusters, cut where the HOG of neighbours differ most; by default one per 12 references.
    similarity : float, optional
        Instead of a number, the thesis's threshold: a new cluster starts where the HOG's cosine similarity to the
        cluster's first image falls below it. It does not carry over from one dataset to another: 0.65 makes 17
        clusters of Gardens Point's day_left and a single one of the simulated day_left.
    backbone : {"efficientnet-lite0", "resnet18", "alexnet"}
        The trunk, with its ImageNet weights; those of the first come with the installation.
    width, height : int
        Input size of the trunk in pixels.
    penalty : float
        Inverse strength of the L2 penalty on the linear layers.
    seed : int
        Of the augmentations.
    """

    version: ClassVar[str] = "1"
    expected_failures: ClassVar[dict[str, str]] = {
        "permuted-references": "clusters are stretches of the reference sequence",
    }

    n_components: AtLeastOne = 7
    answers_per_component: AtLeastOne = 3
    n_clusters: AtLeastOne | None = None
    similarity: Annotated[float, Field(ge=-1, le=1)] | None = None
    backbone: Backbone = "efficientnet-lite0"
    width: Annotated[int, Field(ge=32)] = 416
    height: Annotated[int, Field(ge=32)] = 256
    penalty: Annotated[float, Field(gt=0)] = 10.0
    seed: Annotated[int, Field(ge=0)] = 0

    def __post_init__(self) -> None:
        """Check that the clusters are asked for in one way.

        Raises
        ------
        ValueError
            If both a number and a threshold are given.
        """
        if self.n_clusters is not None and self.similarity is not None:
            raise ValueError("give n_clusters or similarity, not both")

    def weights_digest(self) -> str:
        """Name the trunk's weights by their SHA-256."""
        return choose_weights(self.backbone, "imagenet").identity()

    def fit(self, references: Traverse) -> None:
        """Cluster the references and train stage one and the components on them.

        Raises
        ------
        DataError
            If an image cannot be decoded, or the weights are missing or damaged.
        """
        raw, owners, hogs = self._describe_references(references)
        originals = np.arange(len(references)) * (len(raw) // len(references))
        self.mean_ = raw[originals].mean(axis=0)
        descriptors = self._centred(raw)
        self.database_ = descriptors[originals]
        clusters = self._cluster(hogs)
        self.stage_one_ = train_head(descriptors, clusters.labels[owners], len(clusters), self.penalty)
        self.components_ = train_components(clusters, descriptors, owners, self.penalty)

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with at most ``n_components × answers_per_component`` references; the score is their cosine."""
        with stage("encode"):
            descriptor = self._centred(gem(self._trunk.encode([image])))[0]
        with stage("match"):
            logits = self.stage_one_.logits(descriptor)
            triggered = np.argsort(-logits, kind="stable")[: self.n_components]
            candidates = self.components_.answer(descriptor, triggered, self.answers_per_component)
        with stage("rerank"):
            return Match.from_scores(self.database_[candidates] @ descriptor, k, candidates)

    def save(self, folder: Path) -> None:
        """Write the fitted map as one safetensors file."""
        arrays = {
            "mean": self.mean_,
            "database": self.database_,
            "bounds": self.components_.clusters.bounds,
            "stage_one.weight": self.stage_one_.weight,
            "stage_one.bias": self.stage_one_.bias,
            "components.weight": self.components_.head.weight,
            "components.bias": self.components_.head.bias,
        }
        # safetensors writes an array's memory as it lies there, column by column for some.
        save_file({name: np.ascontiguousarray(array) for name, array in arrays.items()}, folder / _MAP_FILE)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        stored = load_file(folder / _MAP_FILE)
        self.mean_, self.database_ = stored["mean"], stored["database"]
        self.stage_one_ = LinearHead(stored["stage_one.weight"], stored["stage_one.bias"])
        head = LinearHead(stored["components.weight"], stored["components.bias"])
        self.components_ = Components(Clusters(stored["bounds"]), head)
        return self

    @property
    def _trunk(self) -> Trunk:
        return load_trunk(self.backbone, self.width, self.height)

    def _describe_references(
        self, references: Traverse
    ) -> tuple[NDArray[np.float32], NDArray[np.int64], NDArray[np.float32]]:
        """Describe every reference and its augmentations, each original before its own.

        Returns
        -------
        descriptors : (n · 6, D) float32
            Pooled, neither centred nor normalised.
        owners : (n · 6,) int64
            The reference that each belongs to.
        hogs : (n, H) float32
            Unit length, of the originals.
        """
        descriptors, owners, hogs = [], [], []
        for index, image in enumerate(track(references, "Describing references, augmented five-fold")):
            # Augmenting at the trunk's own size costs a fifth of it and shows the trunk the same.
            small = resized(image, self.width, self.height)
            variants = [image, *augmented(small, self.seed, index)]
            descriptors.append(gem(self._trunk.encode(variants)))
            owners.extend([index] * len(variants))
            hogs.append(_CLUSTERING_HOG.describe(image))
        return np.concatenate(descriptors), np.array(owners, dtype=np.int64), normalised(np.stack(hogs))

    def _cluster(self, hogs: NDArray[np.float32]) -> Clusters:
        if self.similarity is not None:
            return by_similarity(hogs, self.similarity)
        return by_count(hogs, self.n_clusters or max(round(len(hogs) / _CLUSTER_SIZE), 1))

    def _centred(self, descriptors: NDArray[np.float32]) -> NDArray[np.float32]:
        """Take away what all references have in common; what is left tells places apart."""
        return normalised(descriptors - self.mean_)
