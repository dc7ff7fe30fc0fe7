"""What came out of timing methods side by side."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.bench.variants import Variant
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.metrics.latency import TOTAL, latency
from vpr_bench.metrics.ratios import paired_ratio
from vpr_bench.metrics.undefined import or_none
from vpr_bench.runner.machine import Machine

RERANK, BEFORE_RERANK = "rerank", "before_rerank"


@dataclass(frozen=True, eq=False)
class VariantTimes:
    """The times of one method.

    Attributes
    ----------
    variant : Variant
        What was timed.
    fit_seconds : float or None
        Decoding included; None for a map.
    seconds : dict of (rounds, n) float64
        Of each stage that it noted, and ``total``.
    """

    variant: Variant
    fit_seconds: float | None
    seconds: dict[str, NDArray[np.float64]]

    def latency(self) -> dict[str, float]:
        """Return percentiles of each stage over all images and rounds, in milliseconds.

        As :func:`~vpr_bench.metrics.latency.latency` names them.
        """
        return latency({name: column.ravel() for name, column in self.seconds.items()})

    def ratios(self, first: "VariantTimes") -> dict[str, Interval]:
        """Return how many times as long it took as another.

        Returns
        -------
        dict
            Of each stage that both noted, of ``before_rerank``, which is the total without re-ranking, and of
            ``total``. See :func:`~vpr_bench.metrics.ratios.paired_ratio`.
        """
        mine, others = self._compared(), first._compared()
        return {name: paired_ratio(mine[name], others[name]) for name in mine if name in others}

    def _compared(self) -> dict[str, NDArray[np.float64]]:
        total = self.seconds[TOTAL]
        return self.seconds | {BEFORE_RERANK: total - self.seconds.get(RERANK, 0.0), TOTAL: total}


@dataclass(frozen=True, eq=False)
class Comparison:
    """Methods that were timed side by side.

    Attributes
    ----------
    protocol : str
        Dataset, edition, references and queries.
    n_references : int
        That each method knows.
    size : tuple of int
        Of the first image, (H, W, 3).
    rounds : int
        How often each image was asked.
    order : {"shuffled", "sequential"}
        Of the images.
    k : int
        Answers that were asked for.
    seed : int
        Of the images, and of the order of the methods.
    machine : Machine
        With the number of threads.
    variants : sequence of VariantTimes
        At least one; the others are compared with the first.
    """

    protocol: str
    n_references: int
    size: tuple[int, ...]
    rounds: int
    order: str
    k: int
    seed: int
    machine: Machine
    variants: Sequence[VariantTimes]

    @property
    def n_images(self) -> int:
        """How many images were asked."""
        return int(self.variants[0].seconds[TOTAL].shape[1])

    def as_dict(self) -> dict[str, Any]:
        """Return everything, JSON-able; undefined numbers are None."""
        return {
            "benchmark": "methods",
            "protocol": self.protocol,
            "references": self.n_references,
            "images": self.n_images,
            "size": list(self.size),
            "rounds": self.rounds,
            "order": self.order,
            "k": self.k,
            "seed": self.seed,
            "threads": self.machine.threads,
            "machine": self.machine.model_dump(mode="json"),
            "variants": [self._described(one) for one in self.variants],
        }

    def _described(self, one: VariantTimes) -> dict[str, Any]:
        kept = one.variant.kept
        return {
            "variant": one.variant.name,
            "method": one.variant.built.label,
            "map": None if kept is None else str(kept.folder),
            "fit_seconds": one.fit_seconds,
            "latency_ms": one.latency(),
            "ratio_to_first": {
                name: {"value": or_none(ratio.value), "low": or_none(ratio.low), "high": or_none(ratio.high)}
                for name, ratio in one.ratios(self.variants[0]).items()
            },
        }
