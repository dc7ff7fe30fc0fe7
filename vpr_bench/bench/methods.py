"""How long methods take beside each other: one process, the same images in memory, asked in turn."""

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from vpr_bench.bench.comparison import Comparison, VariantTimes
from vpr_bench.bench.variants import Variant
from vpr_bench.cores import available_cores
from vpr_bench.dataset.load import Case
from vpr_bench.errors import UsageError
from vpr_bench.method.interfaces import is_sequential
from vpr_bench.progress import task, track
from vpr_bench.runner.answers import SECONDS, AnswerTable
from vpr_bench.runner.asking import Questioner, query_order
from vpr_bench.runner.machine import describe_machine
from vpr_bench.runner.resources import limit_threads
from vpr_bench.runner.run import RunOptions, run_key
from vpr_bench.types.traverse import Traverse


def run(
    case: Case,
    variants: Sequence[Variant],
    *,
    limit: int | None = 50,
    rounds: int = 3,
    threads: int | None = None,
    seed: int = 0,
    k: int | None = None,
) -> Comparison:
    """Time methods side by side.

    All are fitted, and all images decoded, before the first is asked. In each round every method warms up and is
    then asked every image: one image after the other, and each by all methods in an order that is drawn anew, so that
    whatever else the machine does, and whatever one method leaves in the caches, hits all alike. Sequence methods are
    reset before each round; if there is one, all are shown the first images in their order.

    Parameters
    ----------
    case : Case
        Whose references are learnt, and whose queries are asked.
    variants : sequence of Variant
        At least one. What the others take is compared with what the first takes.
    limit : int, optional
        How many queries are asked, drawn by the seed; None for all.
    rounds : int
        How often each is asked.
    threads : int, optional
        For numerical libraries; by default one per core.
    seed : int
        Of the images, and of the order of the methods.
    k : int, optional
        Answers per query; by default 20, or the whole map if it is smaller.

    Raises
    ------
    UsageError
        If a number is out of range, or a map is of other references.
    DataError
        If an image cannot be decoded, or a map cannot be read.
    VprBenchError
        If a method fails or answers nonsense; names it and the image.
    """
    if not variants or rounds < 1:
        raise UsageError(f"There must be something to time, in at least 1 round. Got {rounds} instead.")
    threads = threads or available_cores()
    keys = [run_key(case, one.built, RunOptions(seed, k, limit, threads)) for one in variants]
    key = keys[0]  # they differ in the method only
    with limit_threads(threads):
        fitted = [one.fitted(case.references) for one in track(variants, "Fitting")]
    sequential = any(is_sequential(method) for method, _ in fitted)
    chosen = query_order(len(case.queries), key, sequential=sequential)
    images = [case.queries[query] for query in track(chosen, "Decoding")]
    asked = replace(case, queries=Traverse(case.queries.name, images))
    generator = np.random.default_rng(seed)
    tables = []
    with limit_threads(threads), task("Asking in turn", rounds * len(images)) as advance:
        for _ in range(rounds):
            pairs = zip(variants, fitted, strict=True)
            asking = [Questioner(asked, one.built, method, AnswerTable(key.k)) for one, (method, _) in pairs]
            for _ in _ask_in_turn(asking, len(images), threads, generator):
                advance(1)
            tables.append([one.table for one in asking])
    times = [
        VariantTimes(one, fit_seconds, _columns(answered))
        for one, (_, fit_seconds), answered in zip(variants, fitted, zip(*tables, strict=True), strict=True)
    ]
    return Comparison(
        protocol=case.protocol.source + "/" + case.protocol.pairing,
        n_references=len(case.references),
        size=images[0].shape if images else (),
        rounds=rounds,
        order="sequential" if sequential else "shuffled",
        k=key.k,
        seed=seed,
        machine=describe_machine(threads),
        variants=times,
    )


def _ask_in_turn(
    asking: Sequence[Questioner], n_images: int, threads: int, generator: np.random.Generator
) -> Iterator[None]:
    """Ask one round; yield after each image."""
    with ExitStack() as stack:
        for one in asking:
            stack.enter_context(one.ready(threads))
        for image in range(n_images):
            for turn in generator.permutation(len(asking)):
                asking[turn].ask(image)
            yield


def _columns(tables: Sequence[AnswerTable]) -> dict[str, NDArray[np.float64]]:
    """Return the (rounds, n) seconds of each stage; images come from memory, so that decoding is none."""
    rounds = [
        {name.removeprefix(SECONDS): column for name, column in table.timing_arrays().items()} for table in tables
    ]
    names = [name for name in dict.fromkeys(name for one in rounds for name in one) if name != "decode"]
    nothing = np.zeros(len(tables[0].matches))
    return {name: np.stack([one.get(name, nothing) for one in rounds]).astype(np.float64) for name in names}
