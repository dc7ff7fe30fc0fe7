"""Stored runs by what people call them: a folder, or the first digits of a hash."""

import re
from collections.abc import Sequence
from pathlib import Path

from vpr_bench.errors import DataError, UsageError
from vpr_bench.runner.store import RECORD, RunStore, StoredRun


def select_runs(names: Sequence[str] | None, root: Path) -> list[StoredRun]:
    """Return the named runs in their order, or all complete ones, oldest first.

    Parameters
    ----------
    names : sequence of str, optional
        Each a run's folder, or the beginning of a run's hash under ``root``.
    root : Path
        Folder that holds the runs.

    Raises
    ------
    UsageError
        If a name means no run, or several.
    DataError
        If there are no runs at all, or a named one is damaged.
    """
    if names:
        return [select_run(name, root) for name in names]
    runs = RunStore(root).runs()
    if not runs:
        raise DataError(f"There are no runs under {root}. Make one with `vpr-bench run`, or give --runs.")
    return runs


def select_run(name: str, root: Path) -> StoredRun:
    """Return one run by its folder or the beginning of its hash; parameters and errors as :func:`select_runs`."""
    folder = Path(name).parent if Path(name).name == RECORD else Path(name)
    if (folder / RECORD).exists():
        return StoredRun.open(folder)
    if not re.fullmatch("[0-9a-f]+", name):
        raise UsageError(
            f"{name!r} is neither a run's folder nor the beginning of a run's hash. `vpr-bench show` lists them."
        )
    found = sorted(root.glob(f"*/*/*/{name}*/{RECORD}"))
    found = [record for record in found if "." not in record.parent.name]
    if len(found) != 1:
        problem = f"{len(found)} runs begin with" if found else "no run begins with"
        raise UsageError(f"Under {root} {problem} {name!r}. `vpr-bench show` lists them.")
    return StoredRun.open(found[0].parent)
