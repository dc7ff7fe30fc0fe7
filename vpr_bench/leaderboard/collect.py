"""From a stored run to its row."""

from vpr_bench.errors import DataError, blaming
from vpr_bench.files.atomic import read_arrays
from vpr_bench.leaderboard.columns import check_row
from vpr_bench.leaderboard.entry import METRICS, PERCENTILES, PHASES, STAGES, Cell, Entry
from vpr_bench.metrics.bootstrap import bootstrap
from vpr_bench.metrics.latency import latency
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.store import LABELS, StoredRun
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol

RESAMPLES = 2000
_PACKAGE = "vpr-bench"


def collect(run: StoredRun, protocol: Protocol | None = None) -> Entry:
    """Compute all that a leaderboard says about a run; the method is not asked again.

    Parameters
    ----------
    run : StoredRun
        A complete run; of some of the queries, if it is partial.
    protocol : Protocol, optional
        Instead of the one that the run was asked for: another radius, unit or policy, but the same images.

    Raises
    ------
    UsageError
        If the run's places do not say what is right in this protocol.
    DataError
        If it is damaged.
    """
    with blaming(f"{run.folder} is damaged", DataError):
        entry = _row(run, protocol or run.protocol)
        check_row(entry)
    return entry


def cell_of(run: StoredRun, protocol: Protocol | None = None) -> Cell:
    """Return the cell that a run's row is for; the protocol is as in :func:`collect`."""
    return run.record.label, str(protocol or run.protocol), run.record.machine.fingerprint


def _row(run: StoredRun, protocol: Protocol) -> Entry:
    record, key, provenance = run.record, run.record.key, run.record.provenance
    answers = answers_of(run, protocol)
    right = answers.correct[answers.expected]
    return Entry(
        method=record.label,
        protocol=protocol,
        partial=record.partial,
        n_references=record.n_references,
        n_queries=record.n_queries,
        n_available=_available(run),
        n_counted=len(right),
        metrics=bootstrap(answers, METRICS, RESAMPLES),
        latency=_latency(run),
        elsewhere=provenance.elsewhere,
        fit_seconds=record.fit_seconds,
        peak_memory={phase: size for phase, size in record.peak_memory.items() if phase in PHASES},
        machine=record.machine.fingerprint,
        machine_about=str(record.machine),
        sequential=record.order == "sequential",
        future=record.future,
        weights=key.weights,
        version=key.version,
        seed=key.seed,
        k=key.k,
        threads=key.threads,
        dataset_digest=key.dataset_digest,
        run=key.digest(),
        package=record.machine.libraries.get(_PACKAGE, ""),
        commit=provenance.source.commit if provenance.source else None,
        changed=provenance.source.changed if provenance.source else None,
        created=record.created,
        right=right,
    )


def _latency(run: StoredRun) -> dict[str, float]:
    found = latency(run.seconds)
    names = [f"latency_{stage}_p{percentile}" for stage in STAGES for percentile in PERCENTILES]
    return {name: found[name] for name in names if name in found}


def _available(run: StoredRun) -> int:
    """Return how many queries there were to ask."""
    places = Places.from_arrays(read_arrays(run.folder / LABELS))
    if places.queries is not None:
        return len(places.queries)
    return places.given.n_queries if places.given is not None else run.record.n_queries
