"""The work of one run, in its working folder: fit, ask every query, write what was answered."""

import json
import shutil
import time
import warnings
from pathlib import Path

from vpr_bench.checkpoint import checkpoints
from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import write_arrays, write_bytes
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Method, Persistent, frames_ahead, is_sequential
from vpr_bench.method.saving import save_fitted
from vpr_bench.progress import track
from vpr_bench.runner.answers import AnswerTable
from vpr_bench.runner.asking import Questioner, query_order
from vpr_bench.runner.machine import describe_machine
from vpr_bench.runner.provenance import begin, utc_now
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.resources import Elsewhere, PeakMemory, limit_threads
from vpr_bench.runner.store import LABELS, MATCHES, RECORD, SHORTLISTS, TIMINGS, StoreWarning

_CHECKPOINT_SECONDS = 10.0
_FITTING, _FIT, _FITTED, _ANSWERS = "fitting", "fit", "fit.json", "answers.npz"


def work_on(case: Case, built: BuiltMethod, key: RunKey, work: Path, timeout: float | None = None) -> None:
    """Do a run, or the rest of it, in the folder ``work``: what is complete in the end is moved away by the caller.

    A sequential method that was interrupted is asked from the first query again: what it knew of the ones before
    is gone. What it had learnt of the map is not, nor the steps of a fit that it keeps by :func:`kept`.

    Raises
    ------
    DataError
        If an image cannot be decoded.
    VprBenchError
        If the method raises, answers nonsense or takes longer than ``timeout`` seconds; names the query.
    """
    work.mkdir(exist_ok=True)
    provenance = begin(built.method, built.origin)
    sequential = is_sequential(built.method)
    table = AnswerTable(key.k) if sequential else _resume(work / _ANSWERS, key.k)
    resumed = bool(table.matches) or (work / _FITTED).exists() or (work / _FITTING).exists()
    with limit_threads(key.threads):
        method, fit_seconds, fit_peak = _fitted(case, built, work)
    # Limited again: fitting may have loaded further libraries.
    with limit_threads(key.threads), PeakMemory() as memory, Elsewhere() as elsewhere:
        order = query_order(len(case.queries), key, sequential=sequential)
        open_queries = [query for query in order if query not in table.matches]
        if open_queries:
            _ask(Questioner(case, built, method, table, timeout), key, open_queries, work / _ANSWERS)
    contents = {MATCHES: table.match_arrays(), TIMINGS: table.timing_arrays(), LABELS: case.places.arrays()}
    if shortlists := table.shortlist_arrays():
        contents[SHORTLISTS] = shortlists
    for name, arrays in contents.items():
        write_arrays(work / name, arrays)
    record = RunRecord(
        key=key,
        protocol=str(case.protocol),
        label=built.label,
        n_references=len(case.references),
        n_queries=len(table.matches),
        partial=key.limit is not None,
        resumed=resumed,
        order="sequential" if sequential else "shuffled",
        future=frames_ahead(method),
        timeout=timeout,
        fit_seconds=fit_seconds,
        peak_memory={"fit": fit_peak, "match": memory.bytes},
        machine=describe_machine(key.threads),
        # Of a run that was continued, what went on during the other processes is not known.
        provenance=provenance.model_copy(update={"elsewhere": None if resumed else round(elsewhere.share, 4)}),
        created=utc_now(),
        files={name: sha256_of_file(work / name) for name in contents},
    )
    write_bytes(work / RECORD, record.model_dump_json(indent=2).encode())
    (work / _ANSWERS).unlink(missing_ok=True)
    (work / _FITTED).unlink(missing_ok=True)
    for folder in (_FIT, _FITTING):
        shutil.rmtree(work / folder, ignore_errors=True)


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
    failing = f"The method {built.id!r} failed while fitting"
    with PeakMemory() as memory, checkpoints(work / _FITTING), blaming(failing):
        method.fit(case.references)
    seconds = time.perf_counter() - start
    if save_fitted(method, folder, built.id):
        write_bytes(note, json.dumps({"seconds": seconds, "peak": memory.bytes}).encode())
        shutil.rmtree(work / _FITTING, ignore_errors=True)
    return method, seconds, memory.bytes


def _ask(questioner: Questioner, key: RunKey, open_queries: list[int], checkpoint: Path) -> None:
    case, built, table = questioner.case, questioner.built, questioner.table
    saved = time.monotonic()
    with questioner.ready(key.threads):
        try:
            for query in track(open_queries, f"{built.label} on {case.protocol}"):
                questioner.ask(query)
                if time.monotonic() - saved > _CHECKPOINT_SECONDS:
                    table.save(checkpoint)
                    saved = time.monotonic()
        finally:
            if table.matches:
                table.save(checkpoint)
