"""One method on one protocol: fit, ask every query, store the answers."""

import json
import shutil
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal, TypeVar

import numpy as np

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.files.disk import disk_errors
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Method, Persistent
from vpr_bench.progress import track
from vpr_bench.runner.answers import AnswerTable
from vpr_bench.runner.machine import available_cores, describe_machine
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.resources import PeakMemory, limit_threads
from vpr_bench.runner.store import LABELS, MATCHES, RECORD, TIMINGS, RunStore, StoredRun, StoreWarning
from vpr_bench.timing import collect_stages
from vpr_bench.types.match import Match

T = TypeVar("T")

Overwrite = Literal["only-missing", "always", "never"]

_DEFAULT_K = 20
_WARM_UP = 3  # answers that are not recorded, before the first that is
_CHECKPOINT_SECONDS = 10.0
_FIT, _FITTED, _ANSWERS = "fit", "fit.json", "answers.npz"


@dataclass(frozen=True)
class RunOptions:
    """How to run.

    Parameters
    ----------
    seed : int
        Of the order in which queries are asked.
    k : int, optional
        Answers kept per query, at most the size of the map; by default 20, or the whole map if it is smaller.
    limit : int, optional
        Ask only so many queries, the first in the seeded order: a quick look, marked partial.
    threads : int, optional
        For numerical libraries; by default one per core.
    overwrite : {"only-missing", "always", "never"}
        ``only-missing`` reuses a complete run, continues an interrupted one and redoes a damaged one;
        ``always`` runs again from the start; ``never`` changes nothing that is on disk.
    """

    seed: int = 0
    k: int | None = None
    limit: int | None = None
    threads: int | None = None
    overwrite: Overwrite = "only-missing"


def run_key(case: Case, built: BuiltMethod, options: RunOptions) -> RunKey:
    """Say what identifies a run.

    Raises
    ------
    UsageError
        If ``k`` or the limit is out of range.
    """
    size = len(case.references)
    k = min(_DEFAULT_K, size) if options.k is None else options.k
    if not 1 <= k <= size:
        raise UsageError(f"k must lie between 1 and {size}, the number of references. Got {k} instead.")
    if options.limit is not None and options.limit < 1:
        raise UsageError(f"The limit must be at least 1. Got {options.limit} instead.")
    limit = options.limit if options.limit is not None and options.limit < len(case.queries) else None
    return RunKey(
        source=case.protocol.source,
        pairing=case.protocol.pairing,
        dataset_digest=case.digest,
        method=built.id,
        version=built.version,
        parameters=built.parameters,
        weights=built.weights,
        seed=options.seed,
        k=k,
        limit=limit,
        threads=options.threads or available_cores(),
    )


def run(case: Case, built: BuiltMethod, store: RunStore, options: RunOptions | None = None) -> StoredRun:
    """Run a method on a protocol, or return the stored run if there is one.

    Whatever happens, what is on disk is whole: answers are checkpointed in a folder beside the final one,
    which is renamed into place at the end. The next call continues where a killed one stopped.

    Raises
    ------
    UsageError
        If an option is out of range.
    DataError
        If an image cannot be decoded or the store cannot be written, or, with ``never``, if the stored run
        is damaged or unfinished.
    VprBenchError
        If the method raises or answers nonsense; names the query.
    """
    options = options or RunOptions()
    key = run_key(case, built, options)
    if options.overwrite != "always":
        stored = _stored(store, key, options.overwrite)
        if stored is not None:
            return stored
    with store.claim(key) as work:
        if options.overwrite == "only-missing":
            stored = _stored(store, key, options.overwrite)  # another process may just have finished it
            if stored is not None:
                return stored
        if options.overwrite == "always":
            shutil.rmtree(work, ignore_errors=True)
        with disk_errors(work):
            with limit_threads(key.threads):
                _work(case, built, key, work)
            return store.complete(key)


def _stored(store: RunStore, key: RunKey, overwrite: Overwrite) -> StoredRun | None:
    try:
        found = store.find(key)
    except DataError as error:
        if overwrite == "never":
            raise
        warnings.warn(f"{error} It is put aside at {store.put_aside(key)}.", StoreWarning, stacklevel=3)
        return None
    if found is None and overwrite == "never" and store.folder(key).with_name(key.digest() + ".partial").exists():
        raise DataError(f"The run {store.folder(key)} is unfinished. Continue it with --overwrite only-missing.")
    return found


def _work(case: Case, built: BuiltMethod, key: RunKey, work: Path) -> None:
    work.mkdir(exist_ok=True)
    table = _resume(work / _ANSWERS, key.k)
    resumed = bool(table.matches) or (work / _FITTED).exists()
    method, fit_seconds, fit_peak = _fitted(case, built, work)
    with PeakMemory() as memory:
        _ask(case, method, built, key, table, work / _ANSWERS)
    write_arrays(work / MATCHES, table.match_arrays())
    write_arrays(work / TIMINGS, table.timing_arrays())
    write_arrays(work / LABELS, {"queries": case.query_labels, "references": case.reference_labels})
    record = RunRecord(
        key=key,
        protocol=str(case.protocol),
        label=built.label,
        n_references=len(case.references),
        n_queries=len(table.matches),
        partial=key.limit is not None,
        resumed=resumed,
        fit_seconds=fit_seconds,
        peak_memory={"fit": fit_peak, "match": memory.bytes},
        machine=describe_machine(key.threads),
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        files={name: sha256_of_file(work / name) for name in (MATCHES, TIMINGS, LABELS)},
    )
    write_bytes(work / RECORD, record.model_dump_json(indent=2).encode())
    (work / _ANSWERS).unlink(missing_ok=True)
    (work / _FITTED).unlink(missing_ok=True)
    shutil.rmtree(work / _FIT, ignore_errors=True)


def _resume(path: Path, k: int) -> AnswerTable:
    if not path.exists():
        return AnswerTable(k)
    try:
        return AnswerTable.load(path, k)
    except DataError as error:
        warnings.warn(f"{error} Its queries are asked again.", StoreWarning, stacklevel=2)
        return AnswerTable(k)


def _fitted(case: Case, built: BuiltMethod, work: Path) -> tuple[Method, float, int]:
    """Fit the method, or load what an interrupted run had fitted; return seconds and peak bytes with it."""
    method, folder, note = built.method, work / _FIT, work / _FITTED
    if isinstance(method, Persistent) and note.exists():
        facts = json.loads(note.read_text("utf-8"))
        return method.load(folder), facts["seconds"], facts["peak"]
    start = time.perf_counter()
    with PeakMemory() as memory:
        _guard(built.id, "fitting", lambda: method.fit(case.references))
    seconds = time.perf_counter() - start
    if isinstance(method, Persistent):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        method.save(folder)
        write_bytes(note, json.dumps({"seconds": seconds, "peak": memory.bytes}).encode())
    return method, seconds, memory.bytes


def _ask(case: Case, method: Method, built: BuiltMethod, key: RunKey, table: AnswerTable, checkpoint: Path) -> None:
    order = np.random.default_rng(key.seed).permutation(len(case.queries))[: key.limit]
    open_queries = [int(query) for query in order if int(query) not in table.matches]
    if open_queries:
        # A reference, not a query: a method that adapts to what it is shown must not see one twice.
        warm_up = case.references[0]
        for _ in range(_WARM_UP):
            _guard(built.id, "warming up", lambda: method.match(warm_up, key.k))
    saved = time.monotonic()
    try:
        for query in track(open_queries, f"{built.label} on {case.protocol}"):
            _answer(case, method, built, query, table)
            if time.monotonic() - saved > _CHECKPOINT_SECONDS:
                table.save(checkpoint)
                saved = time.monotonic()
    finally:
        if table.matches:
            table.save(checkpoint)


def _answer(case: Case, method: Method, built: BuiltMethod, query: int, table: AnswerTable) -> None:
    start = time.perf_counter()
    image = case.queries[query]
    decoded = time.perf_counter()
    with collect_stages() as seconds:
        match = _guard(built.id, f"answering {case.queries.name_of(query)}", lambda: method.match(image, table.k))
    total = time.perf_counter() - decoded
    _check(match, built.id, case, query, table.k)
    table.add(query, match, {**seconds, "decode": decoded - start, "total": total})


def _guard(method: str, doing: str, call: Callable[[], T]) -> T:
    try:
        return call()
    except VprBenchError:
        raise
    except Exception as error:
        raise VprBenchError(f"The method {method!r} failed while {doing}: {type(error).__name__}: {error}") from error


def _check(match: Match, method: str, case: Case, query: int, k: int) -> None:
    """Refuse an answer that is none; :class:`Match` has checked the rest."""
    fault = None
    if not isinstance(match, Match):
        fault = f"a {type(match).__name__} instead of a Match"
    elif len(match) > k:
        fault = f"{len(match)} references where {k} were asked for"
    elif match.indices.max() >= len(case.references):
        fault = f"reference {match.indices.max()} of a map of {len(case.references)}"
    if fault:
        raise VprBenchError(f"The method {method!r} answered {case.queries.name_of(query)} with {fault}.")
