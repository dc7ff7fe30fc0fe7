"""The gate as a fixture of pytest: ``vpr_gate("hog", "gardens:simulated")`` in a test.

Installing vpr-bench brings it. It is imported whenever pytest starts, so that what computes is imported by the first
test that uses it.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from vpr_bench.gate.verdict import Verdict

_OPTIONS = {
    "baseline": ("baseline.json", "FILE", "the file that answers are compared with"),
    "runs": ("runs", "FOLDER", "the folder that holds the runs"),
}


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--vpr-baseline``, ``--vpr-runs`` and ``--vpr-update``, and the ini values of the first two."""
    group = parser.getgroup("vpr-bench")
    for name, (default, metavar, told) in _OPTIONS.items():
        group.addoption(f"--vpr-{name}", metavar=metavar, help=f"{told}; default: the ini value, else {default}")
        parser.addini(f"vpr_{name}", f"{told}, from the folder of the ini file on", default=default)
    group.addoption("--vpr-update", action="store_true", help="record answers in the baseline instead of comparing")


@pytest.fixture(scope="session")
def vpr_gate(pytestconfig: pytest.Config) -> "Gate":
    """Compare a method's answers with the baseline; call it as :class:`Gate` says."""
    return Gate(
        _path(pytestconfig, "baseline"), _path(pytestconfig, "runs"), update=pytestconfig.getoption("--vpr-update")
    )


class Gate:
    """Runs methods, or takes their stored runs, and fails the test where they answer worse than the baseline.

    Parameters
    ----------
    baseline : Path
        The file.
    runs : Path
        Folder that holds the runs.
    update : bool
        Record answers in the file instead of comparing them.
    """

    def __init__(self, baseline: Path, runs: Path, *, update: bool) -> None:
        self._baseline = baseline
        self._runs = runs
        self._update = update

    def __call__(
        self,
        method: str,
        dataset: str,
        *,
        protocol: str | None = None,
        parameters: Mapping[str, Any] | None = None,
        seed: int | None = None,
        k: int | None = None,
        tolerance: Mapping[str, float] | None = None,
        significance: float | None = None,
        exact: bool | None = None,
        latency_ratio: float | None = None,
    ) -> "Verdict":
        """Judge a method on a protocol.

        Parameters
        ----------
        method, dataset, protocol, parameters
            As ``--method``, ``--dataset``, ``--protocol`` and ``--param`` of ``vpr-bench run``.
        seed, k : int, optional
            As recorded; for the first recording 0, and 20 answers or the whole map.
        tolerance, significance, exact, latency_ratio
            Instead of the rules of the baseline, as :class:`vpr_bench.gate.Overrides`.

        Returns
        -------
        Verdict
            What was found; it passed.
        """
        __tracebackhide__ = True
        from vpr_bench.errors import VprBenchError
        from vpr_bench.gate.rules import Overrides
        from vpr_bench.gate.trial import Trial
        from vpr_bench.gate.words import failure

        overrides = Overrides({} if tolerance is None else tolerance, significance, exact, latency_ratio)
        try:
            trial = Trial(method, dataset, protocol, {} if parameters is None else parameters, seed, k)
            if self._update:
                trial.record(self._baseline, self._runs)
            verdict = trial.judge(self._baseline, self._runs, overrides)
        except VprBenchError as error:
            raise pytest.fail.Exception(str(error), pytrace=False) from None
        if verdict.exit_code:
            pytest.fail(failure(verdict), pytrace=False)
        return verdict


def _path(config: pytest.Config, name: str) -> Path:
    """Return what the command line says, from the current folder on, else the ini value, from its file's folder on."""
    given = config.getoption(f"--vpr-{name}")
    if given is not None:
        return Path(config.invocation_params.dir, given)
    return Path(config.rootpath, config.getini(f"vpr_{name}"))
