"""The clusters of a sequence as a table for people, or as JSON or CSV for programs."""

import csv
import io
import json
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from vpr_bench.method.clustering import Clustered
from vpr_bench.metrics.clustering import central_members, distortion, silhouette
from vpr_bench.metrics.undefined import or_none
from vpr_bench.report.grid import Grid
from vpr_bench.report.numbers import UNDEFINED, share


@dataclass(frozen=True, eq=False)
class ClusterReport:
    """The clusters of a sequence with where they come from.

    Attributes
    ----------
    method : str
        What made them, with its parameters.
    references : str
        What is clustered: dataset, edition and traverse, as ``gardens:simulated/day_left``.
    found : Clustered
        The clusters, and the descriptors that they follow from, if those are known.
    """

    method: str
    references: str
    found: Clustered

    @cached_property
    def lines(self) -> list[dict[str, Any]]:
        """One line per cluster.

        Its number, first reference, the one after its last, size, whether it is a stretch, cohesion, and the
        reference nearest to its centre.
        """
        clusters = self.found.clusters
        central = central_members(clusters, self.found.descriptors)
        cohesion = [None] * len(clusters) if clusters.cohesion is None else clusters.cohesion.tolist()
        return [
            {
                "cluster": number,
                "start": int(clusters.starts[number]),
                "stop": int(clusters.stops[number]),
                "size": int(clusters.sizes[number]),
                "contiguous": bool(clusters.stops[number] - clusters.starts[number] == clusters.sizes[number]),
                "cohesion": cohesion[number],
                "central": int(central[number]),
            }
            for number in range(len(clusters))
        ]

    @cached_property
    def summary(self) -> dict[str, Any]:
        """What all clusters come to: numbers that do not exist are None."""
        clusters, descriptors = self.found.clusters, self.found.descriptors
        sizes = clusters.sizes
        quality = {
            "mean_cohesion": None if clusters.cohesion is None else float(clusters.cohesion.mean()),
            "silhouette": None if descriptors is None else silhouette(descriptors, clusters),
            "distortion": None if descriptors is None else distortion(descriptors, clusters),
        }
        return {
            "n_references": len(clusters.labels),
            "n_clusters": len(clusters),
            "min_size": int(sizes.min()),
            "median_size": float(np.median(sizes)),
            "max_size": int(sizes.max()),
            "contiguous": clusters.contiguous,
            **{name: or_none(value) for name, value in quality.items()},
        }

    def grid(self) -> Grid:
        """Lay the clusters out, with one more line for all of them."""
        rows = [[cell(value) for value in line.values()] for line in self.lines]
        total = self.summary
        sizes = " / ".join(cell(total[f"{one}_size"]) for one in ("min", "median", "max"))
        whole = [cell(total[name]) for name in ("contiguous", "mean_cohesion")]
        rows.append([f"all {total['n_clusters']}", "0", cell(total["n_references"]), sizes, *whole, ""])
        note = (
            "stop: the reference after the last; size of all: least / median / most; cohesion: mean cosine similarity "
            "to the cluster's mean; central: the reference nearest to it"
        )
        if total["distortion"] is not None:
            note += f"\nsilhouette: {cell(total['silhouette'])}; distortion: {cell(total['distortion'])}"
        return Grid(f"{self.references}  {self.method}", list(self.lines[0]), rows, note)

    def json(self) -> str:
        """Write everything, with the cluster of each reference."""
        content = {
            "method": self.method,
            "references": self.references,
            **self.summary,
            "clusters": self.lines,
            "labels": self.found.clusters.labels.tolist(),
        }
        return json.dumps(content, indent=2, ensure_ascii=False)

    def csv(self) -> str:
        """Write one line per cluster."""
        return to_csv(self.lines)


def to_csv(lines: list[dict[str, Any]]) -> str:
    """Write lines that have the same columns; what does not exist is empty."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(lines[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(lines)
    return text.getvalue().rstrip("\n")


def cell(value: bool | int | float | None) -> str:
    """Write a fact about clusters for people.

    Examples
    --------
    >>> cell(True), cell(12), cell(12.5), cell(0.87654), cell(1234.5), cell(None)
    ('yes', '12', '12.5', '0.877', '1234.5', '–')
    """
    if value is None:
        return UNDEFINED
    if isinstance(value, bool):
        return "yes" if value else "no"
    return share(value) if abs(value) < 1 and value else f"{value:.6g}"
