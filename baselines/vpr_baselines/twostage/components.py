"""Stage two: one component per cluster, all in one matrix, so that a component is a slice of it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vpr_baselines.twostage.heads import LinearHead
from vpr_bench.types.clusters import Clusters


@dataclass(frozen=True, eq=False)
class Answers:
    """What triggered components name, component by component, each with its best first.

    Attributes
    ----------
    references : (m,) int64
        Unique.
    components : (m,) int64
        Which component named each.
    logits : (m,) float32
        Not comparable between components, which were trained apart.
    probabilities : (m,) float32
        In [0, 1]; those of one component's whole cluster sum to 1.
    """

    references: NDArray[np.int64]
    components: NDArray[np.int64]
    logits: NDArray[np.float32]
    probabilities: NDArray[np.float32]

    @classmethod
    def best(
        cls, component: int, members: NDArray[np.int64], logits: NDArray[np.float32], count: int | None
    ) -> "Answers":
        """Take the ``count`` best of one component's (m,) members by their (m,) logits, or all there are."""
        chosen = np.argsort(-logits, kind="stable")[:count]
        exponentials = np.exp(logits - logits.max())
        probabilities = exponentials / exponentials.sum()
        return cls(members[chosen], np.full(len(chosen), component), logits[chosen], probabilities[chosen])

    def most_likely(self, clusters: NDArray[np.float32], count: int) -> NDArray[np.int64]:
        """Return the (at most ``count``) references of highest probability, best first.

        Parameters
        ----------
        clusters : (C,) float32
            Stage one's logits. The probability of a reference is that of its cluster among the triggered ones times
            its own within the cluster.
        count : int
            How many.
        """
        likely = np.exp(clusters[self.components] - clusters[self.components].max()) * self.probabilities
        return self.references[np.argsort(-likely, kind="stable")[:count]]

    @classmethod
    def join(cls, parts: Sequence["Answers"]) -> "Answers":
        """Put the answers of several components one behind the other; of none, there are none."""
        if not parts:
            none = np.empty(0, np.float32)
            return cls(none.astype(np.int64), none.astype(np.int64), none, none)
        return cls(
            np.concatenate([one.references for one in parts]),
            np.concatenate([one.components for one in parts]),
            np.concatenate([one.logits for one in parts]),
            np.concatenate([one.probabilities for one in parts]),
        )


@dataclass(frozen=True, eq=False)
class Components:
    """The classifiers image → reference within the cluster.

    Attributes
    ----------
    clusters : Clusters
        The index: which references belong to which component.
    head : LinearHead
        One row per reference, cluster by cluster and in each ascending: the order of :attr:`references`. The weight
        may be memory-mapped and of half precision; only the rows of triggered components are read.
    """

    clusters: Clusters
    head: LinearHead

    @cached_property
    def references(self) -> NDArray[np.int64]:
        """(n,) int64: the reference that each row stands for."""
        return np.argsort(self.clusters.labels, kind="stable")

    @cached_property
    def bounds(self) -> NDArray[np.int64]:
        """(C + 1,) int64: the rows of component ``c`` are ``bounds[c]`` to ``bounds[c + 1]``, exclusive."""
        return np.concatenate([[0], np.cumsum(self.clusters.sizes)])

    def members(self, component: int) -> NDArray[np.int64]:
        """Return the references of one component, (m,) int64 ascending."""
        return self.references[self._rows(component)]

    def part(self, component: int) -> LinearHead:
        """Return the layer of one component: (m, D) float32, in the order of its members."""
        rows = self._rows(component)
        return LinearHead(np.asarray(self.head.weight[rows], np.float32), np.asarray(self.head.bias[rows], np.float32))

    def answers(self, descriptor: NDArray[np.float32], triggered: NDArray[np.int64], best: int | None) -> Answers:
        """Let each triggered component name its ``best`` references.

        Parameters
        ----------
        descriptor : (D,) float32
            The query's.
        triggered : (c,) int64
            Clusters, without repetition.
        best : int, optional
            Answers per component; a smaller cluster gives all it has, as do all by default.
        """
        return Answers.join(
            [
                Answers.best(one, self.members(one), self.part(one).logits(descriptor), best)
                for one in triggered.tolist()
            ]
        )

    def _rows(self, component: int) -> slice:
        return slice(int(self.bounds[component]), int(self.bounds[component + 1]))
