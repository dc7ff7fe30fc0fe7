"""The baseline file: rules, and one cell for each method and protocol."""

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from vpr_bench.errors import DamagedError, DataError, UsageError, first_fault, one_line
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.lock import held
from vpr_bench.files.migrations import migrated
from vpr_bench.gate.cell import Cell, check_cell
from vpr_bench.gate.content import RESTORE, read_content
from vpr_bench.gate.migrations import SCHEMA_VERSION, STEPS
from vpr_bench.gate.rules import ALLOWED, FRESH, Rules


class Baseline(BaseModel):
    """What answers are compared with.

    Attributes
    ----------
    rules : Rules
        For every cell, as far as a cell has none of its own.
    cells : dict
        By their ids, in the order of these.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    schema_version: int = SCHEMA_VERSION
    rules: Rules = FRESH
    cells: dict[str, Cell] = {}

    def rules_of(self, cell: Cell) -> Rules:
        """Return the rules of a cell."""
        return cell.rules.over(self.rules)

    def with_cells(self, cells: Iterable[Cell]) -> "Baseline":
        """Return the same with other cells."""
        return self.model_copy(update={"cells": {cell.id: cell for cell in sorted(cells, key=lambda one: one.id)}})

    def text(self) -> str:
        """Return the file's content; equal baselines have equal ones."""
        content = self.model_dump(mode="json")
        content["rules"] = self.rules.model_dump(mode="json", exclude_none=True)
        for cell_id, cell in self.cells.items():
            own = cell.rules.model_dump(mode="json", exclude_defaults=True, exclude_none=True)
            content["cells"][cell_id].pop("rules")
            content["cells"][cell_id] |= {"rules": own} if own else {}
        return json.dumps(content, indent=1, sort_keys=True, allow_nan=False) + "\n"


def read_baseline(path: Path) -> Baseline:
    """Read a baseline and check every cell.

    Raises
    ------
    DamagedError
        If it is damaged, or something in it does not follow from the rest; names the cell.
    DataError
        If there is none, or it is of a schema that this version does not know.
    """
    if not path.exists():
        raise DataError(f"There is no baseline {path}. Record one with `vpr-bench gate --baseline {path} --update`.")
    content = read_content(path)
    found = content.get("schema_version")
    if type(found) is not int:
        raise DamagedError(f"{path} is no baseline: it has no schema_version.")
    if not 1 <= found <= SCHEMA_VERSION:
        raise DataError(
            f"{path} has schema version {found:.6g}; this vpr-bench reads 1 to {SCHEMA_VERSION}. Update vpr-bench."
        )
    try:
        baseline = Baseline.model_validate(migrated(content, STEPS, SCHEMA_VERSION))
        baseline.rules.check()
    except ValidationError as error:
        advice = ALLOWED if "rules" in error.errors()[0]["loc"] else RESTORE
        raise DamagedError(f"{path} is damaged: {one_line(first_fault(error)):.300}. {advice}") from None
    except UsageError as error:
        raise DamagedError(f"{path}, rules: {error}") from None
    for key, cell in baseline.cells.items():
        where = f"{path}: the cell {one_line(key):.200}"
        if fault := check_cell(cell, key):
            raise DamagedError(f"{where}: {one_line(fault):.300}. {RESTORE}")
        try:
            cell.rules.check()
        except UsageError as error:
            raise DamagedError(f"{where}, rules: {error}") from None
    return baseline


def write_baseline(baseline: Baseline, path: Path) -> bool:
    """Write a baseline; return False, and leave the file alone, if it says the same already.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    text = baseline.text().encode()
    with disk_errors(path):
        if path.is_file() and path.read_bytes() == text:
            return False
        path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, text)
    return True


@contextmanager
def being_updated(path: Path) -> Iterator[Baseline]:
    """Yield the baseline that is there, or a fresh one, while no other process may update it.

    Raises
    ------
    DamagedError
        If it is damaged.
    DataError
        If it is of a schema that this version does not know, or nothing can be written beside it.
    """
    with held(path.with_name(f".{path.name}.lock"), f"Waiting for another process that updates {path}"):
        yield read_baseline(path) if path.exists() else Baseline()
