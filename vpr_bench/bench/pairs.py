"""How long the exact area over all query-reference pairs takes, and how much memory, at full size."""

import platform
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.bench.memory import peak_rss_bytes
from vpr_bench.cores import available_cores
from vpr_bench.metrics.pairs import MAX_THREADS, pr_auc_pairs
from vpr_bench.types.ground_truth import GroundTruth

NOISE = 2.0
"""What each traverse adds to a place, relative to the spread of the places: hard, and far from hopeless."""


def run(queries: int = 27592, dimensions: int = 256, radius: float = 10, seed: int = 0) -> dict[str, Any]:
    """Measure :func:`vpr_bench.metrics.pairs.pr_auc_pairs` on made-up descriptors, in a fresh process.

    Two traverses of the same route are described, with one reference per query: neighbouring frames resemble
    each other, and both traverses add noise of their own. The clock runs from the descriptors in memory to
    the value, computing every score twice; making the descriptors and the ground truth is not timed. The
    peak memory is that of the whole process, interpreter and descriptors included.

    Parameters
    ----------
    queries : int
        Frames of each traverse; the default is the size of the Nordland test set.
    dimensions : int
        Of each float32 descriptor.
    radius : float
        In frames.
    seed : int
        Of the descriptors.

    Returns
    -------
    dict
        JSON-able: sizes, threads, machine, ``seconds``, ``peak_rss_bytes`` and the value ``pr_auc_pairs``.
    """
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(_measure, queries, dimensions, radius, seed).result()


def route(frames: int, dimensions: int, smoothness: float, seed: int) -> tuple[NDArray[np.float32], ...]:
    """Describe two traverses of one made-up route.

    Returns
    -------
    queries, references : (frames, dimensions) float32
        Of unit length. The similarity of places fades over about ``smoothness`` frames.
    """
    from scipy.ndimage import gaussian_filter1d

    generator = np.random.default_rng(seed)

    def draw() -> NDArray[np.float32]:
        return generator.standard_normal((frames, dimensions), dtype=np.float32)

    places = gaussian_filter1d(draw(), smoothness, axis=0)
    places /= places.std()
    seen = (places + np.float32(NOISE) * draw() for _ in range(2))
    return tuple(descriptors / np.linalg.norm(descriptors, axis=1, keepdims=True) for descriptors in seen)


def _measure(n_queries: int, dimensions: int, radius: float, seed: int) -> dict[str, Any]:
    frames = np.arange(n_queries)
    ground_truth = GroundTruth.from_radius(frames, frames, radius)
    queries, references = route(n_queries, dimensions, max(radius, 1.0), seed)
    threads = min(available_cores(), MAX_THREADS)
    start = time.perf_counter()
    value = pr_auc_pairs(lambda rows: queries[rows] @ references.T, ground_truth, threads=threads)
    seconds = time.perf_counter() - start
    return {
        "benchmark": "pairs",
        "queries": n_queries,
        "references": n_queries,
        "dimensions": dimensions,
        "radius": radius,
        "seed": seed,
        "pairs": n_queries * n_queries,
        "true_pairs": len(ground_truth.references),
        "threads": threads,
        "machine": platform.machine(),
        "seconds": seconds,
        "peak_rss_bytes": peak_rss_bytes(),
        "pr_auc_pairs": value,
    }
