"""The two-stage system of the thesis (ch. 4), and past it: one trunk shared by all parts, spatial re-ranking."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.backbones.architectures import ARCHITECTURES, Backbone
from vpr_baselines.backbones.pooling import Pooling
from vpr_baselines.backbones.trunk import Normalise, load_trunk
from vpr_baselines.clustering.closeness import Distance
from vpr_baselines.clustering.cluster import cluster_descriptors
from vpr_baselines.clustering.describers import ClusterBy, describe_references
from vpr_baselines.clustering.options import ClusteringOptions, Kind
from vpr_baselines.twostage.augment import augmented_by_name
from vpr_baselines.twostage.encoder import Encoder, Look
from vpr_baselines.twostage.fitting import extend_shared, fit_separate, fit_shared
from vpr_baselines.twostage.reranking import Rerank
from vpr_baselines.twostage.separate.body import Body, load_body
from vpr_baselines.twostage.separate.system import SeparateSystem
from vpr_baselines.twostage.shared import SharedSystem
from vpr_baselines.twostage.system import System
from vpr_bench.checkpoint import kept
from vpr_bench.errors import UsageError
from vpr_bench.shortlist import shortlist
from vpr_bench.timing import stage
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse
from vpr_bench.weights.choice import choose_weights

AtLeastOne = Annotated[int, Field(ge=1)]
Share = Annotated[float, Field(ge=0, le=1)]
Side = Annotated[int, Field(ge=32, le=4000)]

_CLUSTER_SIZE = 8  # references; see docs/twostage.md for what it was chosen on
_CANDIDATES = 21


@dataclass
class TwoStage:
    """Stage one picks clusters, components pick images inside them, their cells decide between those.

    Fitting cuts the reference sequence into clusters, enlarges it five-fold by augmentation, describes every image
    once by the frozen trunk, and learns one linear layer for stage one (image → cluster) and one per component
    (image → reference within the cluster). A query costs one pass through the trunk, whatever ``n_components`` is;
    the score is a confidence that is calibrated on the references' own augmentations. The preset ``thesis`` is the
    system as published: a ResNet-18 per part, cosine similarity.

    Parameters
    ----------
    n_components : int
        How many of the best clusters trigger their component; more than there are triggers all.
    answers_per_component : int, optional
        How many references each triggered component names, 3 in the thesis. By default the 21 that are most likely,
        by their cluster's probability times their own in it, whichever components they are of.
    rerank : {"spatial", "cosine"}, optional
        Compare candidates by the displacement that most of their cells agree on, or by descriptors alone. By default
        ``spatial`` where parts share a trunk; separate networks know ``cosine`` only.
    components : {"shared", "separate"}
        One trunk for all parts, or a whole network for each, run one after the other.
    finetune : bool
        Of separate networks: train all layers, not the last one alone.
    epochs : int
        Of ``finetune``, at most.
    clustering : {"count", "leader", "chain", "kmeans", "focus", "labels"}
        How clusters are made, see :class:`~vpr_baselines.clustering.options.ClusteringOptions`.
    cluster_by : {"trunk", "hog", "hog:thesis", "sift", "alexnet"}
        What references are compared by for it: the trunk's global descriptor, or those of the thesis.
    distance : {"cosine", "l1", "l2"}
        How.
    threshold : float, optional
        For ``leader``, ``chain`` and ``focus``. None carries over from one dataset to another.
    n_clusters : int, optional
        For ``count`` and ``kmeans``; by default one per 8 references.
    labels : list of int, optional
        For ``labels``: the cluster of each reference.
    min_size, max_size : int, optional
        How many references a cluster has at least and at most.
    backbone : {"efficientnet-lite0", "resnet18", "alexnet"}
        The trunk; the weights of the first come with the installation.
    weights : str
        ``imagenet``, ``places365``, the path of a checkpoint, or ``random``.
    layer : str, optional
        The convolution that the shared trunk ends with, cut short; by default its last one.
    width, height : int
        Input size of the trunk in pixels.
    normalise : {"grey+clahe", "none"}
        Grey and locally equalised, or colours as they are.
    pooling : {"gem", "average", "grid1x3", "grid2x3"}
        How the last map becomes a descriptor where the trunk is shared; separate networks average.
    dimensions : int
        Of the descriptor, per part of the grid.
    cells : int
        Cells kept per image.
    cell_dimensions : int
        Of each.
    whitening : float
        How far principal directions of the references are made equally long, in [0, 1].
    penalty : float
        Inverse strength of the L2 penalty on the linear layers.
    seed : int
        Of augmentations, splits, K-means and random weights.
    """

    version: ClassVar[str] = "2"
    expected_failures: ClassVar[dict[str, str]] = {
        "permuted-references": "clusters are stretches of the reference sequence",
    }
    may_answer_fewer: ClassVar[str] = "only what the triggered components name is in the running"
    presets: ClassVar[dict[str, dict[str, Any]]] = {
        "thesis": {
            "components": "separate",
            "rerank": "cosine",
            "answers_per_component": 3,
            "clustering": "leader",
            "cluster_by": "hog",
            "threshold": 0.65,
            "backbone": "resnet18",
            "weights": "places365",
            "width": 227,
            "height": 227,
            "normalise": "none",
            "pooling": "average",
        },
    }

    n_components: AtLeastOne = 7
    answers_per_component: AtLeastOne | None = None
    rerank: Rerank | None = None
    components: Literal["shared", "separate"] = "shared"
    finetune: bool = False
    epochs: AtLeastOne = 10
    clustering: Kind = "count"
    cluster_by: Literal["trunk"] | ClusterBy = "trunk"
    distance: Distance = "cosine"
    threshold: Annotated[float, Field(allow_inf_nan=False)] | None = None
    n_clusters: AtLeastOne | None = None
    labels: list[int] | None = None
    min_size: AtLeastOne = 1
    max_size: AtLeastOne | None = None
    backbone: Backbone = "efficientnet-lite0"
    weights: str = "imagenet"
    layer: str | None = None
    width: Side = 416
    height: Side = 256
    normalise: Normalise = "grey+clahe"
    pooling: Pooling = "grid2x3"
    dimensions: AtLeastOne = 128
    cells: AtLeastOne = 300
    cell_dimensions: AtLeastOne = 48
    whitening: Share = 0.3
    penalty: Annotated[float, Field(gt=0)] = 10.0
    seed: Annotated[int, Field(ge=0)] = 0

    def __post_init__(self) -> None:
        """Check that the parameters go together.

        Raises
        ------
        ValueError
            If they do not.
        """
        if self.components == "separate" and (self.rerank == "spatial" or self.layer is not None):
            what = "no layer" if self.layer is not None else "rerank='cosine' only"
            raise ValueError(f"components='separate' knows {what}")
        if self.components == "shared" and self.finetune:
            raise ValueError("finetune=True needs components='separate': a shared trunk stays as it is")
        if self.layer is not None:
            ARCHITECTURES[self.backbone].cut_at(self.layer)
        self._options(1)

    def weights_digest(self) -> str:
        """Name the trunk's weights by training set and SHA-256; it raises what :func:`choose_weights` raises."""
        return choose_weights(self.backbone, self.weights, self.seed).identity()

    def fit(self, references: Traverse) -> None:
        """Cluster the references and train stage one and the components on them.

        Raises
        ------
        DataError
            If an image cannot be decoded, or the weights are missing or damaged.
        UsageError
            If there are no references, or they cannot be clustered as the parameters ask for.
        """
        if not len(references):
            raise UsageError("There are no references to fit.")
        self.system_: System
        if self.components == "separate":
            labels = kept("clusters", lambda: {"labels": self._clustered(references, None).labels})["labels"]
            clusters = Clusters(labels)
            self.system_ = fit_separate(
                references, clusters, self._body, self.penalty, self.seed, self.epochs if self.finetune else None
            )
        else:
            encoder = self._encoder(references)
            self.system_ = fit_shared(
                references, encoder, self._clustered, self.rerank or "spatial", self.penalty, self.seed
            )

    def match(self, image: NDArray[np.uint8], k: int) -> Match:
        """Answer with at most as many references as the triggered components name, by the score of the re-ranking."""
        system = self.system_
        with stage("encode"):
            query = system.encode(image)
        with stage("match"):
            logits = system.rank(query)
            triggered = np.argsort(-logits, kind="stable")[: self.n_components]
            answers = system.answers(query, triggered, self.answers_per_component)
            by_share = self.answers_per_component is None
            candidates = answers.most_likely(logits, _CANDIDATES) if by_share else answers.references
        with stage("rerank"):
            match = Match.from_scores(system.scores(query, candidates), k, candidates)
        everything = len(triggered) == len(system.clusters)
        shortlist("clusters", None if everything else np.flatnonzero(np.isin(system.clusters.labels, triggered)))
        shortlist("components", candidates)
        return match

    def extend(self, references: Traverse) -> None:
        """Put references behind those that are there: they get clusters and components of their own.

        The other components stay as they are, and so does what was learnt about the trunk's responses; stage one is
        trained again on stored descriptors.

        Raises
        ------
        NotImplementedError
            If every part has a network of its own.
        UsageError
            If labels were given: there are none for the new references.
        """
        if not isinstance(self.system_, SharedSystem):
            raise NotImplementedError(
                "components='separate' cannot be extended: all of stage one would be trained again"
            )
        if self.clustering == "labels":
            raise UsageError("A map that was clustered by given labels cannot be extended: fit all references again.")
        self.system_ = extend_shared(self.system_, references, self._clustered, self.penalty, self.seed)

    def cluster(self, references: Traverse) -> Clusters:
        """Return the clusters that :meth:`fit` makes of the references."""
        return self.cluster_described(self.describe_for_clusters(references))

    def describe_for_clusters(self, references: Traverse) -> NDArray[np.float32]:
        """Return the (n, D) descriptors that the references are clustered by."""
        if self.cluster_by != "trunk":
            return describe_references(self.cluster_by, references)
        return self._encoder(references).describe_traverse(references)

    def cluster_described(self, descriptors: NDArray[np.float32]) -> Clusters:
        """Return the clusters of what :meth:`describe_for_clusters` returned."""
        return cluster_descriptors(descriptors, self._options(len(descriptors)))

    def augmented(self, image: NDArray[np.uint8], index: int) -> dict[str, NDArray[np.uint8]]:
        """Return the augmentations of the ``index``-th reference, by name."""
        return augmented_by_name(image, self.seed, index)

    def save(self, folder: Path) -> None:
        """Write the fitted map into an existing folder."""
        self.system_.save(folder)

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote.

        Raises
        ------
        DataError
            If it is damaged, or the weights are missing.
        """
        if self.components == "separate":
            self.system_ = SeparateSystem.load(folder, self._body, finetune=self.finetune)
        else:
            self.system_ = SharedSystem.load(folder, self._look, self.rerank or "spatial")
        return self

    @property
    def _look(self) -> Look:
        one = ARCHITECTURES[self.backbone]
        layers = one.cut_at(self.layer) if self.layer else (one.middle, one.last)
        size = self.width, self.height
        return Look(load_trunk(one, *size, self.weights, self.normalise, layers, self.seed), self.pooling)

    @property
    def _body(self) -> Body:
        return load_body(self.backbone, self.weights, self.width, self.height, self.normalise, self.seed)

    def _encoder(self, references: Traverse) -> Encoder:
        return Encoder.learn(self._look, references, self.dimensions, self.cell_dimensions, self.cells, self.whitening)

    def _clustered(self, references: Traverse, originals: NDArray[np.float32] | None) -> Clusters:
        """Cluster references whose descriptors by the trunk may be known already."""
        known = originals if self.cluster_by == "trunk" else None
        try:
            return self.cluster_described(self.describe_for_clusters(references) if known is None else known)
        except ValueError as error:
            raise UsageError(f"{len(references)} references cannot be clustered so: {error}") from error

    def _options(self, references: int) -> ClusteringOptions:
        count = self.n_clusters
        if count is None and self.clustering in ("count", "kmeans"):
            count = max(round(references / _CLUSTER_SIZE), 1)
        return ClusteringOptions(
            kind=self.clustering,
            distance=self.distance,
            threshold=self.threshold,
            n_clusters=None if count is None else min(count, references),
            labels=None if self.labels is None else tuple(self.labels),
            min_size=self.min_size,
            max_size=self.max_size,
            seed=self.seed,
        )
