"""What the results page measures: every run, those of most interest first."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

NIGHT, RIGHT, DAY = "day_left-night_right", "day_right-night_right", "day_left-day_right"
PARTS = ("gardens", "simulated", "ablations")
DATASETS = (
    "nordland",
    "gardens",
    "berlin-a100",
    "berlin-halenseestrasse",
    "berlin-kudamm",
    "amstertime",
    "st-lucia",
)
ALL = 99
"""More components than day_left has clusters."""

ABLATIONS: tuple[dict[str, Any], ...] = (
    {"rerank": "cosine"},
    {"answers_per_component": 3},
    {"n_clusters": 12},
    {"pooling": "gem"},
    {"whitening": 0},
    {"normalise": "none"},
    {"cluster_by": "hog"},
    {"cells": 416},
    {"width": 320, "height": 192},
    {"cell_dimensions": 112},
    {"penalty": 100},
)
"""One choice changed at a time; everything else as by default."""


@dataclass(frozen=True)
class Variant:
    """What is asked of which method.

    Attributes
    ----------
    part : str
        Of :data:`PARTS`.
    source : str
        Dataset with its edition.
    pairing : str, optional
        Protocol; by default the dataset's first.
    method : str
    parameters : dict
        Those that are set.
    """

    part: str
    source: str
    pairing: str | None = None
    method: str = "twostage"
    parameters: dict[str, Any] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Of its line in the tables: the same for no other variant of its part."""
        return f"{self.source}/{self.pairing or 'default'} {self.method}({self.settings})"

    @property
    def settings(self) -> str:
        """The parameters as they are written on the command line."""
        return ", ".join(f"{name}={value}" for name, value in self.parameters.items())


def variants() -> Iterator[Variant]:
    """Yield every run of the page."""
    for pairing, counts in ((NIGHT, (1, 3, 7, ALL)), (RIGHT, (1, 7)), (DAY, (1, 7))):
        for count in counts:
            yield Variant("gardens", "gardens:real", pairing, parameters={"n_components": count})
    for method in ("efficientnet-lite0", "hog", "sift"):
        for pairing in (NIGHT, RIGHT, DAY):
            yield Variant("gardens", "gardens:real", pairing, method)
    for dataset in DATASETS:
        for count in (1, 7):
            yield Variant("simulated", f"{dataset}:simulated", parameters={"n_components": count})
    for changed in ({}, *ABLATIONS):
        for source, pairing in (("gardens:real", DAY), ("gardens:simulated", NIGHT)):
            yield Variant("ablations", source, pairing, parameters=dict(changed))
