"""What the harness asks of a method, and the optional capabilities it looks for."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from vpr_bench.types.clusters import Clusters
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
        """Answer one (H, W, 3) uint8 RGB query with ``k`` references, best first; a smaller map with all of it."""
        ...


@runtime_checkable
class Persistent(Protocol):
    """A method whose fitted state can be kept on disk."""

    def save(self, folder: Path) -> None:
        """Write what ``fit`` learnt into an existing empty folder.

        Raises
        ------
        NotImplementedError
            If it cannot be kept after all, as by a wrapper around a method that is not persistent.
        """
        ...

    def load(self, folder: Path) -> Self:
        """Restore what :meth:`save` wrote into a method of the same parameters; return it."""
        ...


@runtime_checkable
class Extendable(Protocol):
    """A method whose map can grow without being learnt anew."""

    def extend(self, references: Traverse) -> None:
        """Put references behind those that are there, whose indices stay; at least one.

        Raises
        ------
        NotImplementedError
            If it cannot grow after all, as by a wrapper around a method that is not extendable.
        """
        ...


@runtime_checkable
class Augmenting(Protocol):
    """A method that learns from changed copies of the references."""

    def augmented(self, image: NDArray[np.uint8], index: int) -> Mapping[str, NDArray[np.uint8]]:
        """Return the copies of the ``index``-th reference that ``fit`` learns from, by what was done to them.

        Parameters
        ----------
        image : (H, W, 3) uint8
            RGB.
        index : int
            Of the reference, so that what is random is the same as in ``fit``.
        """
        ...


@runtime_checkable
class Weighted(Protocol):
    """A method that uses pre-trained weights."""

    def weights_digest(self) -> str:
        """Return what identifies the weights, as ``name sha256:…``, without loading them into memory twice."""
        ...


@runtime_checkable
class Scoring(Protocol):
    """A method that can say how similar an image is to every reference, which is what sequence methods build on."""

    def scores(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the (N,) finite similarities of one (H, W, 3) uint8 RGB image to all references, higher is better."""
        ...


@runtime_checkable
class Clustering(Protocol):
    """A method that puts similar references into clusters."""

    def cluster(self, references: Traverse) -> Clusters:
        """Return the clusters that ``fit`` would make of the references; what is fitted stays as it is.

        Raises
        ------
        ValueError
            If there are none as the parameters ask for.
        """
        ...


@runtime_checkable
class DescribedClustering(Clustering, Protocol):
    """A method whose clusters follow from one descriptor per reference.

    ``cluster(references)`` is then ``cluster_described(describe_for_clusters(references))``: whoever tries many
    parameters, or measures what came out, describes the references once.
    """

    def describe_for_clusters(self, references: Traverse) -> NDArray[np.float32]:
        """Return the (n, D) descriptors that the references are clustered by."""
        ...

    def cluster_described(self, descriptors: NDArray[np.float32]) -> Clusters:
        """Return the clusters of what :meth:`describe_for_clusters` returned."""
        ...


@runtime_checkable
class Selective(Protocol):
    """A method that may answer with fewer references than it was asked for, or with none.

    From all others that is taken for a fault: what they leave out would quietly lower recall@k.
    """

    @property
    def may_answer_fewer(self) -> str:
        """Why, in a few words; empty if it does not after all. A class attribute will do."""
        ...


@runtime_checkable
class Batched(Protocol):
    """A method that answers many queries at once faster than one after the other."""

    def match_batch(self, images: Sequence[NDArray[np.uint8]], k: int) -> list[Match]:
        """Answer (H, W, 3) uint8 RGB queries, which may differ in size, as :meth:`Method.match` answers each."""
        ...


@runtime_checkable
class Sequential(Protocol):
    """A method whose answer depends on the queries before it: it is shown them in their order, after a reset.

    The others are shown them shuffled, because in a dataset where frame *i* is frame *i* whoever counts the
    queries is right without looking at one.
    """

    @property
    def sequential(self) -> bool:
        """Whether it is; a class attribute will do."""
        ...

    def reset(self) -> None:
        """Forget the queries so far, and nothing of the map."""
        ...


@runtime_checkable
class Foresighted(Sequential, Protocol):
    """A sequential method that is shown some frames after the query before it answers.

    Every frame is given to :meth:`foresee` once, in order, the query's own included, so that it need not be
    described twice. ``match`` then answers the oldest frame that has not been answered. At the end of the
    sequence there are fewer frames to foresee.
    """

    @property
    def future(self) -> int:
        """How many frames after the query it looks at; a parameter, so that it stands in the result."""
        ...

    def foresee(self, image: NDArray[np.uint8]) -> None:
        """Take in the next (H, W, 3) uint8 RGB frame of the sequence."""
        ...


def is_sequential(method: Any) -> bool:
    """Say whether a method is to be shown the queries in their order.

    Raises
    ------
    TypeError
        If it says so and cannot be reset.
    """
    if getattr(method, "sequential", False) is not True:
        return False
    if not isinstance(method, Sequential):
        raise TypeError("it is sequential and has no reset()")
    return True


def frames_ahead(method: Any) -> int:
    """Return how many frames after the query a method is shown before it answers, 0 for all that answer at once."""
    return method.future if is_sequential(method) and isinstance(method, Foresighted) else 0
