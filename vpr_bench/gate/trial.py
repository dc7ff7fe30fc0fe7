"""One method on one protocol, run and held against the baseline."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vpr_bench.dataset.load import Case, load_case
from vpr_bench.dataset.request import own_folder
from vpr_bench.errors import DataError, UsageError
from vpr_bench.gate.baseline import Baseline, being_updated, read_baseline, write_baseline
from vpr_bench.gate.cell import Cell, cell_id, other_images
from vpr_bench.gate.gathering import with_names
from vpr_bench.gate.judging import judge_run
from vpr_bench.gate.matching import asked_for
from vpr_bench.gate.rerun import Sources, options_of
from vpr_bench.gate.rules import Overrides
from vpr_bench.gate.update import updated
from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.method.build import build_method
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore, StoredRun

_ARGUMENTS: dict[str, tuple[Any, str]] = {
    "method": (str, "the name of a method"),
    "dataset": (str, "the name of a dataset, or a folder"),
    "protocol": (str | None, "a text such as 'day_left-night_right'"),
    "parameters": (Mapping, "{name: value}, such as {'cell': 32}"),
    "seed": (int | None, "a whole number"),
    "k": (int | None, "a whole number"),
}
"""What the type of each is, and how that is said."""


@dataclass(frozen=True)
class Trial:
    """What is run.

    Attributes
    ----------
    method, dataset, protocol : str
        As on the command line; without a protocol, the dataset's first.
    parameters : mapping
        Of the method.
    seed, k : int or None
        None for those of the baseline.
    """

    method: str
    dataset: str
    protocol: str | None
    parameters: Mapping[str, Any]
    seed: int | None
    k: int | None

    def __post_init__(self) -> None:
        """Refuse what is of another type: a test may pass anything.

        Raises
        ------
        UsageError
            Names the argument.
        """
        for name, (kinds, told) in _ARGUMENTS.items():
            value = getattr(self, name)
            if not isinstance(value, kinds) or isinstance(value, bool):
                raise UsageError(f"{name} is {told}. Got {value!r:.200} instead.")

    def judge(self, baseline: Path, runs: Path, overrides: Overrides) -> Verdict:
        """Run, or take the stored run, and judge it by the baseline.

        Parameters
        ----------
        baseline : Path
            The file.
        runs : Path
            Folder that holds the runs.
        overrides : Overrides
            Instead of the file's rules.

        Raises
        ------
        VprBenchError
            If the baseline does not hold it, or it cannot be run.
        """
        old, case = read_baseline(baseline), self._case()
        cell = old.cells.get(self._id(case))
        if cell is None:
            raise DataError(
                f"{baseline} holds no {self._id(case)!r}. Record it: run this test once with --vpr-update, and commit "
                "the file."
            )
        rules, found = overrides.apply(old.rules_of(cell)), self._run(case, cell, runs)
        verdict = judge_run(cell, found, rules)
        sources = Sources(folders={case.protocol.dataset: self.dataset} if own_folder(self.dataset) else {})
        return with_names(Judgement([verdict]), [found], sources, lambda told: None).verdicts[0]

    def record(self, baseline: Path, runs: Path) -> None:
        """Run, or take the stored run, and record it in the baseline; parameters and errors as of :meth:`judge`."""
        case = self._case()
        old, name = read_baseline(baseline) if baseline.exists() else Baseline(), self._id(case)
        found = asked_for(self._run(case, old.cells.get(name), runs), case.protocol)
        with being_updated(baseline) as old:
            if name in old.cells:
                self._check(old.cells[name], case)
            write_baseline(updated(old, [found], only=[name], named=True).baseline, baseline)

    def _case(self) -> Case:
        return load_case(self.dataset, self.protocol)

    def _id(self, case: Case) -> str:
        return cell_id(build_method(self.method, self.parameters, self.seed).label, str(case.protocol))

    def _run(self, case: Case, cell: Cell | None, runs: Path) -> StoredRun:
        """Run it as its cell was recorded, if there is one."""
        if cell is None:
            options = RunOptions(seed=self.seed or 0, k=self.k)
        else:
            self._check(cell, case)
            options = options_of(cell)
        return run(case, build_method(self.method, self.parameters, options.seed), RunStore(runs), options)

    def _check(self, cell: Cell, case: Case) -> None:
        """Refuse what is not the same thing as the cell."""
        if case.digest != cell.dataset:
            raise other_images(cell, case.digest, f"in {case.folder}")
        for name, asked, recorded in (("seed", self.seed, cell.seed), ("k", self.k, cell.k)):
            if asked not in (None, recorded):
                raise UsageError(f"The baseline's {cell.id!r} has {name} {recorded}. Got {asked} instead.")
