"""Stored runs that cannot be read, and whose they are."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.gate.cell import Cell
from vpr_bench.gate.matching import belongs
from vpr_bench.gate.verdict import Verdict, error
from vpr_bench.runner.record import read_record
from vpr_bench.runner.store import RECORD, StoredRun

_NAMELESS = "a stored run"


@dataclass(frozen=True)
class DamagedRun:
    """A run that is damaged, or of another schema.

    Attributes
    ----------
    folder : Path
        Where it lies.
    fault : DataError
        What is wrong.
    run : StoredRun or None
        It, where its record can be read; nothing else of it is to be trusted.
    """

    folder: Path
    fault: DataError
    run: StoredRun | None

    @classmethod
    def at(cls, folder: Path) -> "DamagedRun | None":
        """Look what is wrong with the run in a folder; None if nothing is."""
        try:
            StoredRun.open(folder)
        except DataError as fault:
            return cls(folder, fault, _recorded(folder))
        return None

    def cell(self, lacking: Sequence[Cell]) -> Cell | None:
        """Return the cell that this is the run of: by its record or, if that cannot be read, by its folder.

        Parameters
        ----------
        lacking : sequence of Cell
            Those that have no other run.
        """
        run = self.run
        if run is not None:
            return next((cell for cell in lacking if belongs(run, cell)), None)
        mine = [cell for cell in lacking if self._is_below(cell)]
        return mine[0] if len(mine) == 1 else None

    def verdict(self, label: str = "", protocol: str = "") -> Verdict:
        """Say that it is damaged; without a label, by what its record says of itself."""
        if not label and self.run is not None:
            label, protocol = self.run.record.label, self.run.record.protocol
        what = "is damaged" if isinstance(self.fault, DamagedError) else "cannot be read"
        told = DataError(f"its run {what}: {self.fault}" if label else str(self.fault))
        return error(label or _NAMELESS, protocol, told, self.folder)

    def _is_below(self, cell: Cell) -> bool:
        """Tell whether a store would put the runs of a cell beside this one."""
        names = (cell.asked.source, cell.asked.pairing, cell.method)
        return all(_letters(name) == _letters(part) for name, part in zip(names, self.folder.parts[-4:-1], strict=True))


def _recorded(folder: Path) -> StoredRun | None:
    try:
        return StoredRun(folder, read_record(folder / RECORD))
    except DataError:
        return None


def _letters(name: str) -> str:
    """Return what a file system leaves of any name."""
    return re.sub("[^A-Za-z0-9]", "", name)
