"""Letting methods cluster references."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError, VprBenchError, blaming, one_line
from vpr_bench.method.build import METHODS, BuiltMethod
from vpr_bench.method.interfaces import Clustering, DescribedClustering
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

_PROBED = 2  # references that tell whether two methods describe them alike


@dataclass(frozen=True, eq=False)
class Clustered:
    """Clusters, and what they follow from.

    Attributes
    ----------
    clusters : Clusters
        Of the references.
    descriptors : (n, D) float32, optional
        What they were clustered by, where the method says so.
    """

    clusters: Clusters
    descriptors: NDArray[np.float32] | None = None


def clustering_method() -> str:
    """Return the first registered method that clusters references, found without importing any.

    Raises
    ------
    UsageError
        If there is none.
    """
    for entry in METHODS.entries():
        definition = entry.definition()
        if definition is not None and definition.defines("cluster"):
            return entry.name
    raise UsageError("No installed method clusters references: name one by --method module:Class.")


class ReferenceClusterer:
    """Lets several methods, or one with several parameters, cluster the same references, described once.

    Parameters
    ----------
    references : Traverse
        At least one image.
    """

    def __init__(self, references: Traverse) -> None:
        self._references = references
        self._described: NDArray[np.float32] | None = None

    def cluster(self, built: BuiltMethod) -> Clustered:
        """Cluster the references.

        Raises
        ------
        UsageError
            If the method does not cluster, or finds no clusters as its parameters ask for.
        VprBenchError
            If it fails, or returns something else.
        """
        method = built.method
        if not isinstance(method, Clustering):
            raise UsageError(f"The method {built.id!r} does not cluster references: it has no cluster(references).")
        with blaming(f"The method {built.label!r} failed to cluster {self._references.name}"):
            try:
                if isinstance(method, DescribedClustering):
                    descriptors = self._describe(method)
                    return self._checked(built, Clustered(method.cluster_described(descriptors), descriptors))
                return self._checked(built, Clustered(method.cluster(self._references)))
            except ValueError as error:
                raise UsageError(
                    f"The method {built.label!r} cannot cluster {self._references.name}: {one_line(error)}"
                ) from error

    def _describe(self, method: DescribedClustering) -> NDArray[np.float32]:
        """Return what the method describes, or what one before it did where a few references show it to be the same."""
        if self._described is not None and len(self._references) > _PROBED:
            probed = np.linspace(0, len(self._references) - 1, _PROBED, dtype=np.int64)
            few = np.asarray(method.describe_for_clusters(self._references.subset(probed)))
            if np.array_equal(few, self._described[probed]):
                return self._described
        self._described = np.asarray(method.describe_for_clusters(self._references), dtype=np.float32)
        return self._described

    def _checked(self, built: BuiltMethod, clustered: Clustered) -> Clustered:
        found, count = clustered.clusters, len(self._references)
        if not isinstance(found, Clusters) or len(found.labels) != count:
            what = f"{len(found.labels)} references" if isinstance(found, Clusters) else type(found).__name__
            raise VprBenchError(
                f"The method {built.label!r} must return Clusters of {count} references. Got {what} instead."
            )
        if clustered.descriptors is not None and (clustered.descriptors.ndim, len(clustered.descriptors)) != (2, count):
            raise VprBenchError(
                f"The method {built.label!r} must describe {count} references by one row each. "
                f"Got shape {clustered.descriptors.shape} instead."
            )
        return clustered
