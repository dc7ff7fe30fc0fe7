"""One method on one protocol: done already, continued, or done now."""

import math
import shutil
import warnings
from dataclasses import dataclass
from typing import Literal

from vpr_bench.cores import available_cores
from vpr_bench.dataset.load import Case
from vpr_bench.errors import DamagedError, DataError, UsageError
from vpr_bench.files.disk import disk_errors
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import is_sequential
from vpr_bench.runner.record import RunKey
from vpr_bench.runner.session import work_on
from vpr_bench.runner.store import RunStore, StoredRun, StoreWarning

Overwrite = Literal["only-missing", "always", "never"]

_DEFAULT_K = 20
_MOST_THREADS = 1024  # more than machines have: a number from somebody's run.json must not start them


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
        Ask only so many queries, the first in the seeded order (by sequential methods, the first of all): a quick
        look, marked partial.
    threads : int, optional
        For numerical libraries; by default one per core.
    overwrite : {"only-missing", "always", "never"}
        ``only-missing`` reuses a complete run, continues an interrupted one and redoes a damaged one;
        ``always`` runs again from the start; ``never`` changes nothing that is on disk.
    timeout : float, optional
        Seconds that an answer may take. A method that takes longer is given up; it has failed. The first of the
        answers for warming up may take ten times as long.
    """

    seed: int = 0
    k: int | None = None
    limit: int | None = None
    threads: int | None = None
    overwrite: Overwrite = "only-missing"
    timeout: float | None = None


def run_key(case: Case, built: BuiltMethod, options: RunOptions) -> RunKey:
    """Say what identifies a run.

    Raises
    ------
    UsageError
        If ``k``, the limit, the threads or the time-out are out of range, or the method says that it is sequential
        and has no ``reset``.
    """
    size = len(case.references)
    k = min(_DEFAULT_K, size) if options.k is None else options.k
    if not 1 <= k <= size:
        raise UsageError(f"k must lie between 1 and {size}, the number of references. Got {k} instead.")
    if options.limit is not None and options.limit < 1:
        raise UsageError(f"The limit must be at least 1. Got {options.limit} instead.")
    most = max(_MOST_THREADS, available_cores())
    if options.threads is not None and not 1 <= options.threads <= most:
        raise UsageError(f"The threads must lie between 1 and {most}. Got {options.threads} instead.")
    if options.timeout is not None and not 0 < options.timeout < math.inf:
        raise UsageError(f"The time-out must be positive. Got {options.timeout} instead.")
    try:
        is_sequential(built.method)
    except TypeError as error:
        raise UsageError(f"The method {built.id!r} cannot be run: {error}.") from None
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
        threads=available_cores() if options.threads is None else options.threads,
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
        If the method raises, answers nonsense or takes too long; names the query.
    """
    options = options or RunOptions()
    key = run_key(case, built, options)
    found = find_run(store, key, options.overwrite)
    if found is not None:
        return found
    with store.claim(key) as folder:
        if options.overwrite == "always":
            shutil.rmtree(folder, ignore_errors=True)
        else:
            try:
                found = store.find(key)  # another process may just have finished it
            except DamagedError as error:
                warnings.warn(f"{error} It is put aside at {store.put_aside(key)}.", StoreWarning, stacklevel=2)
                found = None
            if found is not None:
                return found
        with disk_errors(folder):
            work_on(case, built, key, folder, options.timeout)
            return store.complete(key)


def find_run(store: RunStore, key: RunKey, overwrite: Overwrite) -> StoredRun | None:
    """Return the run that can be shown as it is, None if there is work to do.

    Raises
    ------
    DataError
        With ``never``, if the run is damaged or unfinished; with any policy, if it cannot be read.
    """
    if overwrite == "always":
        return None
    try:
        found = store.find(key)
    except DamagedError:
        if overwrite == "never":
            raise
        return None  # looked at again, and put aside, by whoever holds its lock
    if found is None and overwrite == "never" and store.folder(key).with_name(key.digest() + ".partial").exists():
        raise DataError(f"The run {store.folder(key)} is unfinished. Continue it with --overwrite only-missing.")
    return found
