"""The work of one run, in its working folder: fit, ask every query, write what was answered."""

import json
import shutil
import time
import warnings
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError, VprBenchError, blaming, one_line
from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.files.disk import DiskError
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Method, Persistent
from vpr_bench.progress import track
from vpr_bench.runner.answers import AnswerTable
from vpr_bench.runner.machine import describe_machine
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.resources import PeakMemory, limit_threads
from vpr_bench.runner.store import LABELS, MATCHES, RECORD, TIMINGS, StoreWarning
from vpr_bench.timing import collect_stages
from vpr_bench.types.match import Match

_WARM_UP = 3  # answers that are not recorded, before the first that is
_CHECKPOINT_SECONDS = 10.0
_FIT, _FITTED, _ANSWERS = "fit", "fit.json", "answers.npz"


def work_on(case: Case, built: BuiltMethod, key: RunKey, work: Path) -> None:
    """Do a run, or the rest of it, in the folder ``work``: what is complete in the end is moved away by the caller.

    Raises
    ------
    DataError
        If an image cannot be decoded.
    VprBenchError
        If the method raises or answers nonsense; names the query.
    """
    work.mkdir(exist_ok=True)
    table = _resume(work / _ANSWERS, key.k)
    resumed = bool(table.matches) or (work / _FITTED).exists()
    with limit_threads(key.threads):
        method, fit_seconds, fit_peak = _fitted(case, built, work)
    with limit_threads(key.threads), PeakMemory() as memory:  # again: fitting may have loaded further libraries
        _ask(case, method, built, key, table, work / _ANSWERS)
    write_arrays(work / MATCHES, table.match_arrays())
    write_arrays(work / TIMINGS, table.timing_arrays())
    write_arrays(work / LABELS, case.places.arrays())
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
        try:
            with blaming(f"{folder} cannot be loaded", DataError):
                facts = json.loads(note.read_text("utf-8"))
                return method.load(folder), float(facts["seconds"]), int(facts["peak"])
        except DataError as error:
            warnings.warn(f"{error} The method is fitted again.", StoreWarning, stacklevel=2)
    start = time.perf_counter()
    with PeakMemory() as memory, blaming(f"The method {built.id!r} failed while fitting"):
        method.fit(case.references)
    seconds = time.perf_counter() - start
    if isinstance(method, Persistent):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        with blaming(f"The method {built.id!r} failed while saving its map to {folder}"):
            try:
                method.save(folder)
            except OSError as error:  # NumPy's has no errno when the disk is full
                raise DiskError(
                    f"Cannot write {folder}: {one_line(error)}. Free some space, or choose another --output."
                ) from error
        write_bytes(note, json.dumps({"seconds": seconds, "peak": memory.bytes}).encode())
    return method, seconds, memory.bytes


def _ask(case: Case, method: Method, built: BuiltMethod, key: RunKey, table: AnswerTable, checkpoint: Path) -> None:
    order = np.random.default_rng(key.seed).permutation(len(case.queries))[: key.limit]
    open_queries = [int(query) for query in order if int(query) not in table.matches]
    if open_queries:
        # A reference, not a query: a method that adapts to what it is shown must not see one twice.
        warm_up = case.references[0]
        with blaming(f"The method {built.id!r} failed while warming up"):
            for _ in range(_WARM_UP):
                method.match(warm_up, key.k)
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
    doing = f"The method {built.id!r} failed while answering {case.queries.name_of(query)}"
    with collect_stages() as seconds, blaming(doing):
        match = method.match(image, table.k)
    total = time.perf_counter() - decoded
    _check(match, built.id, case, query, table.k)
    table.add(query, match, {**seconds, "decode": decoded - start, "total": total})


def _check(match: Match, method: str, case: Case, query: int, k: int) -> None:
    """Refuse an answer that is none; :class:`Match` has checked the rest."""
    fault = None
    if not isinstance(match, Match):
        fault = f"a {type(match).__name__} instead of a Match"
    elif len(match) > k:
        fault = f"{len(match)} references where {k} were asked for"
    elif match.indices.max(initial=-1) >= len(case.references):
        fault = f"reference {match.indices.max()} of a map of {len(case.references)}"
    if fault:
        raise VprBenchError(f"The method {method!r} answered {case.queries.name_of(query)} with {fault}.")
