"""From a stored run to a cell of a baseline."""

import re
from collections.abc import Iterable
from typing import Any

from vpr_bench.errors import UsageError
from vpr_bench.gate.answered import Answered
from vpr_bench.gate.cell import Cell, CellMachine, Columns, written_metrics
from vpr_bench.gate.lines import to_lines
from vpr_bench.metrics.answers import NEVER, without_soft
from vpr_bench.metrics.definitions import METRICS, compute
from vpr_bench.metrics.latency import latency
from vpr_bench.report.rows import answers_of
from vpr_bench.runner.record import RunRecord
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol

_KEPT = re.compile(r"latency_(.+_p(?:50|95))")


def record_cell(run: StoredRun, protocol: Protocol | None = None, metrics: Iterable[str] = ()) -> Cell:
    """Record what a run answered.

    Parameters
    ----------
    run : StoredRun
        Of all queries.
    protocol : Protocol, optional
        Instead of the one that the run was asked for: another radius or policy, but the same images.
    metrics : iterable of str
        Metrics besides the usual ones.

    Raises
    ------
    UsageError
        If the run is partial, or cannot be scored on this protocol.
    DataError
        If it is damaged.
    """
    record, protocol = run.record, protocol or run.protocol
    if record.partial:
        raise UsageError(f"{run.folder} asked only some of the queries (--limit): a baseline needs all of them.")
    answers = answers_of(run, protocol)
    best, _ = without_soft(run.indices, run.scores, run.places.ground_truth(protocol))
    usual = [name for name, metric in METRICS.items() if metric.function is not None]
    source = record.provenance.source
    return Cell(
        label=record.label,
        protocol=str(protocol),
        method=record.key.method,
        parameters=changed_parameters(record),
        version=record.key.version,
        weights=record.key.weights,
        dataset=record.key.dataset_digest,
        seed=record.key.seed,
        k=record.key.k,
        threads=record.key.threads,
        n_queries=record.n_queries,
        n_references=record.n_references,
        depth=None if answers.depth == NEVER else answers.depth,
        metrics=written_metrics(compute(dict.fromkeys([*usual, *metrics]), answers)),
        answers=_columns(Answered.of(best[:, 0], answers)),
        latency=times(run),
        machine=_machine(record),
        package=record.machine.libraries.get("vpr-bench", "unknown"),
        commit=str(source) if source else None,
        created=record.created,
    ).sealed()


def changed_parameters(record: RunRecord) -> dict[str, Any]:
    """Return the parameters that are not the default ones, written as for ``--param``.

    They are those that the run's label names, and a seed that is not the run's own.

    Parameters
    ----------
    record : RunRecord
        Its label tells defaults apart; the method is not needed.
    """
    return _changed(record.key.parameters, record.label, record.key.seed)


def _changed(parameters: dict[str, Any], label: str, seed: int) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, value in parameters.items():
        if isinstance(value, dict) and {"method", "parameters"} <= value.keys():
            inside = _changed(value["parameters"], label, seed)
            found |= {name: value["method"]} | {f"{name}.{inner}": one for inner, one in inside.items()}
        elif re.search(rf"(?:\(|, ){re.escape(name)}=", label) or (name == "seed" and value != seed):
            found[name] = value
    return found


def times(run: StoredRun) -> dict[str, float]:
    """Return the median and the 95th percentile of each stage, in milliseconds, to four digits."""
    found = ((_KEPT.fullmatch(name), value) for name, value in latency(run.seconds).items())
    return {name[1]: float(f"{value:.4g}") for name, value in found if name}


def _machine(record: RunRecord) -> CellMachine:
    elsewhere = record.provenance.elsewhere
    return CellMachine(
        name=str(record.machine),
        fingerprint=record.machine.fingerprint,
        elsewhere=None if elsewhere is None else min(1.0, max(0.0, round(elsewhere, 3))),
    )


def _columns(answered: Answered) -> Columns:
    return Columns(**{name: to_lines(texts) for name, texts in answered.texts().items()})
