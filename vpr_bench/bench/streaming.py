"""How much memory and time a whole run takes on traverses of any length, image by image."""

import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from itertools import cycle, islice
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from vpr_bench.bench.memory import peak_rss_bytes
from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.load import Case, load_case
from vpr_bench.method.build import build_method
from vpr_bench.metrics.latency import latency
from vpr_bench.runner.run import RunOptions
from vpr_bench.runner.run import run as run_method
from vpr_bench.runner.store import RunStore
from vpr_bench.types.places import Places
from vpr_bench.types.traverse import Traverse


def run(dataset: str, method: str, parameters: dict[str, str], frames: int = 27592, limit: int = 200) -> dict[str, Any]:
    """Run a method on a dataset whose images are repeated until each traverse has ``frames`` of them.

    Everything of a real run is done in a fresh process: digests of all images, fitting on all references, asking
    ``limit`` queries, storing. Accuracy means nothing on repeated images and is not reported.

    Parameters
    ----------
    dataset : str
        Whose images are repeated; its default protocol.
    method : str
        Name of the method.
    parameters : dict
        Of the method, as on the command line.
    frames : int
        References, and as many queries; the default is the size of the Nordland test set.
    limit : int
        Queries that are asked.

    Returns
    -------
    dict
        JSON-able: sizes, method, ``fit_seconds``, ``latency_ms`` and ``peak_rss_bytes`` of the whole process.
    """
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(_measure, dataset, method, parameters, frames, limit).result()


def _repeated(case: Case, frames: int) -> Case:
    def repeat(traverse: Traverse) -> Traverse:
        return Traverse(traverse.name, list(islice(cycle(traverse.sources), frames)), traverse.convert)

    references, queries = repeat(case.references), repeat(case.queries)
    numbers = np.arange(frames, dtype=np.float64)
    digest = traverse_digest(Traverse("both", [*references.sources, *queries.sources]), afresh=True)
    protocol = replace(case.protocol, unit="f", radius=1)
    return replace(
        case, protocol=protocol, references=references, queries=queries, places=Places(numbers, numbers), digest=digest
    )


def _measure(dataset: str, method: str, parameters: dict[str, str], frames: int, limit: int) -> dict[str, Any]:
    case = _repeated(load_case(dataset), frames)
    built = build_method(method, parameters)
    with tempfile.TemporaryDirectory() as folder:
        stored = run_method(case, built, RunStore(Path(folder)), RunOptions(limit=limit))
        milliseconds = latency(stored.seconds)
    return {
        "benchmark": "streaming",
        "images": f"{case.protocol.source}, repeated",
        "size": list(case.references[0].shape),
        "references": frames,
        "queries": frames,
        "asked": limit,
        "method": stored.record.label,
        "threads": stored.record.key.threads,
        "processor": stored.record.machine.processor,
        "fit_seconds": stored.record.fit_seconds,
        "latency_ms": milliseconds,
        "peak_rss_bytes": peak_rss_bytes(),
    }
