"""Which stored run belongs to which cell of a baseline.

A run belongs to a cell if the method has the same label and parameters, and was run on the same images in the same
roles, with the same seed and ``k``, on all queries. The radius does not matter: one run serves every radius. Of several
such runs, one of the method's present version is taken if they differ in version, and of these the newest.
"""

from collections.abc import Iterable
from dataclasses import replace

from vpr_bench.errors import VprBenchError, blaming
from vpr_bench.gate.cell import Cell, cell_id
from vpr_bench.gate.recording import changed_parameters
from vpr_bench.method.build import find_method
from vpr_bench.method.trust import registered_only
from vpr_bench.method.version import version_of
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol


def choose(cell: Cell, runs: Iterable[StoredRun]) -> StoredRun | None:
    """Return the run that belongs to a cell, None if none does."""
    mine = [run for run in runs if belongs(run, cell)]
    if len({run.record.key.version for run in mine}) > 1:
        present = _present_version(cell.method)
        mine = [run for run in mine if run.record.key.version == present] or mine
    return max(mine, key=_age, default=None)


def belongs(run: StoredRun, cell: Cell) -> bool:
    """Tell whether a run is one of a cell."""
    return _similar(run, cell) and not _differences(run, cell)


def near_misses(cell: Cell, runs: Iterable[StoredRun]) -> list[str]:
    """Say why runs of the same method on the same images do not belong to a cell."""
    near = [run for run in runs if _similar(run, cell)]
    return [f"{run.folder} is no run of it: {', '.join(_differences(run, cell))}" for run in near]


def without_cell(cells: Iterable[Cell], runs: Iterable[StoredRun], *, named: bool = False) -> list[StoredRun]:
    """Return the newest run of each method and protocol that no cell is about; partial ones are left out.

    Parameters
    ----------
    cells : iterable of Cell
        Those of the baseline.
    runs : iterable of StoredRun
        Those of today.
    named : bool
        Somebody named the protocols of these runs, radius included: a cell of another radius is not about them. By
        default it is, as the radius that a run happened to be asked for says nothing.
    """
    cells = list(cells)
    ids = {cell.id for cell in cells}
    found: dict[tuple[str, str], StoredRun] = {}
    for run in sorted(runs, key=_age):
        protocol, label = run.record.protocol, run.record.label
        known = cell_id(label, protocol) in ids if named else any(_similar(run, cell) for cell in cells)
        if not run.record.partial and not known:
            found[protocol, label] = run
    return [run for _, run in sorted(found.items())]


def asked_for(run: StoredRun, protocol: Protocol) -> StoredRun:
    """Return a run as if it had been asked for this protocol: another radius or policy, but the same images."""
    return replace(run, record=run.record.model_copy(update={"protocol": str(protocol)}))


def _similar(run: StoredRun, cell: Cell) -> bool:
    key, protocol = run.record.key, cell.asked
    return (run.record.label, key.source, key.pairing) == (cell.label, protocol.source, protocol.pairing)


def _differences(run: StoredRun, cell: Cell) -> list[str]:
    key = run.record.key
    differences = ["only some queries were asked (--limit)"] if run.record.partial else []
    if changed_parameters(run.record) != cell.parameters:
        differences.append("its parameters are others")
    differences += [
        f"its {name} is {found}, the baseline's {expected}"
        for name, found, expected in (("seed", key.seed, cell.seed), ("k", key.k, cell.k))
        if found != expected
    ]
    return differences


def _present_version(method: str) -> str | None:
    """Return a method's version as it is installed here, None if it is not."""
    try:
        with registered_only(), blaming("no version"):
            entry, _ = find_method(method)
            return version_of(entry, entry.load())
    except VprBenchError:
        return None


def _age(run: StoredRun) -> tuple[str, str]:
    return run.record.created, str(run.folder)
