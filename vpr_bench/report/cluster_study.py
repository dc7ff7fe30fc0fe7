"""What becomes of the clusters as one parameter changes: a table, and a picture."""

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vpr_bench.report.cluster_table import ClusterReport, cell, to_csv
from vpr_bench.report.figure import diagram
from vpr_bench.report.grid import Grid
from vpr_bench.report.ink import AMBER, BLUE, GREEN, RED

_COLUMNS = {
    "n_clusters": "clusters",
    "min_size": "least",
    "median_size": "median",
    "max_size": "most",
    "contiguous": "contiguous",
    "mean_cohesion": "cohesion",
    "silhouette": "silhouette",
    "distortion": "SSE",
}
_PANELS = {
    "n_clusters": ("number of clusters", BLUE),
    "mean_cohesion": ("mean cohesion", GREEN),
    "silhouette": ("silhouette coefficient", RED),
    "distortion": ("distortion (SSE)", AMBER),
}


@dataclass(frozen=True, eq=False)
class ClusterStudy:
    """Clusters of the same references, by the same method with one parameter at several values.

    Attributes
    ----------
    method, references : str
        As in a :class:`~vpr_bench.report.cluster_table.ClusterReport`; the method without that parameter.
    parameter : str
        What changes.
    values : sequence of str
        As they were asked for.
    reports : sequence of ClusterReport
        One per value, at least one.
    """

    method: str
    references: str
    parameter: str
    values: Sequence[str]
    reports: Sequence[ClusterReport]

    def lines(self) -> list[dict[str, Any]]:
        """One line per value: the value, then what the clusters come to."""
        pairs = zip(self.values, self.reports, strict=True)
        return [{"parameter": self.parameter, "value": value, **one.summary} for value, one in pairs]

    def grid(self) -> Grid:
        """Lay the study out."""
        rows = [[line["value"], *(cell(line[name]) for name in _COLUMNS)] for line in self.lines()]
        note = "least, median, most: sizes of clusters; SSE: sum of squared distances to the clusters' means"
        title = f"{self.references}  {self.method} by {self.parameter}"
        return Grid(title, [self.parameter, *_COLUMNS.values()], rows, note)

    def json(self) -> str:
        """Write the study as an array of objects."""
        return json.dumps(self.lines(), indent=2, ensure_ascii=False)

    def csv(self) -> str:
        """Write one line per value."""
        return to_csv(self.lines())

    def draw(self, file: Path) -> Path:
        """Draw what can be measured against the parameter, a panel each.

        Raises
        ------
        DataError
            If the file cannot be written.
        """
        places = _numbers(self.values)
        shown = [name for name in _PANELS if any(one.summary[name] is not None for one in self.reports)]
        if places == [one.summary["n_clusters"] for one in self.reports]:
            shown.remove("n_clusters")
        with diagram(max(3.4 * len(shown), 5), 3.4, file) as figure:
            panels = figure.subplots(1, max(len(shown), 1), squeeze=False)[0]
            for axes, name in zip(panels, shown, strict=False):
                title, colour = _PANELS[name]
                heights = [math.nan if one.summary[name] is None else one.summary[name] for one in self.reports]
                where = range(len(heights)) if places is None else places
                axes.plot(where, heights, color=colour, marker="o", markersize=4, linewidth=1.6)
                axes.set_title(title, fontsize=10, loc="left")
                axes.set_xlabel(self.parameter)
                axes.grid(alpha=0.3)
                if name in ("n_clusters", "distortion"):
                    axes.set_ylim(bottom=0)
                if places is None:
                    axes.set_xticks(range(len(heights)), self.values)
            above = figure.suptitle(f"{self.references}  {self.method}", fontsize=10, x=0.01, ha="left")
            above.set_parse_math(False)  # what a method is called may hold a dollar
        return file


def _numbers(values: Sequence[str]) -> list[float] | None:
    """Read values as numbers; None if they are words."""
    try:
        numbers = [float(value) for value in values]
    except ValueError:
        return None
    return numbers if all(map(math.isfinite, numbers)) else None
