"""One plug-in before all its checks."""

import time
import traceback
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Generic, TypeVar

from vpr_bench.check.outcome import Failed, Outcome, Skipped
from vpr_bench.check.suite import Suite
from vpr_bench.errors import UsageError, closest, error_in_words

S = TypeVar("S")


class Examination(Generic[S]):
    """Runs checks on one plug-in, each at most once.

    Parameters
    ----------
    suite : Suite
        The checks there are.
    subject : object
        What they are given.
    only : iterable of str, optional
        Ids of the checks that are asked for; by default all.

    Attributes
    ----------
    checks : list of Check
        Those that are asked for.

    Raises
    ------
    UsageError
        If there is no such check.
    """

    def __init__(self, suite: Suite[S], subject: S, only: Iterable[str] | None = None) -> None:
        self.suite = suite
        self.subject = subject
        self.checks = suite.chosen(only)
        self._raw: dict[str, Outcome] = {}

    def outcome(self, name: str) -> Outcome:
        """Say what a check came to, in the light of what the plug-in declares and of the checks that it builds on.

        Raises
        ------
        UsageError
            If there is no such check, or the plug-in declares that one fails which does not exist.
        """
        found = self._run(name)
        declared = self._known("expected_failures").get(name)
        excused = self._known("excused_failures").get(name)
        if declared is not None and found.result == "fail":
            return Outcome(name, "expected failure", declared, found.seconds, found.error)
        if declared is not None and found.result == "pass":
            reason = f"it passes, but is declared to fail ({declared}): take it out of expected_failures"
            return Outcome(name, "fail", reason, found.seconds)
        if excused is not None and found.result == "fail":
            return Outcome(name, "expected failure", excused, found.seconds, found.error)
        if found.result == "fail":
            reported = {check.id for check in self.checks}
            for foundation in self.suite.foundations(name):
                if foundation in reported and self._run(foundation).result == "fail":
                    return Outcome(name, "skip", f"it builds on {foundation}, which fails", found.seconds)
        return found

    def _known(self, declaration: str) -> Mapping[str, str]:
        """Return what the plug-in declares, if there are such checks."""
        declared: Mapping[str, str] = getattr(self.subject, declaration, {})
        known = [check.id for check in self.suite]
        for name in declared:
            if name not in known:
                raise UsageError(f"There is no check {name!r}, which expected_failures names. {closest(name, known)}")
        return declared

    def _run(self, name: str) -> Outcome:
        """Return what a check comes to by itself."""
        if name not in self._raw:
            check, start, error = self.suite[name], time.perf_counter(), None
            try:
                check.function(self.subject)
            except Exception as raised:
                error = raised
            except SystemExit as raised:  # a plug-in that exits must not pass for a good end
                error = Failed("it exits the process")
                error.__cause__ = raised
            seconds = time.perf_counter() - start
            if error is None:
                self._raw[name] = Outcome(name, "pass", "", seconds)
            elif isinstance(error, Skipped):
                self._raw[name] = Outcome(name, "skip", str(error), seconds)
            else:
                reason = str(error) if isinstance(error, Failed) else in_words(error)
                self._raw[name] = Outcome(name, "fail", reason, seconds, error)
        return self._raw[name]


def in_words(error: BaseException) -> str:
    """Say what was raised, and in which line of whose file."""
    raised = traceback.extract_tb(error.__traceback__)
    where = f" ({Path(raised[-1].filename).name}, line {raised[-1].lineno})" if raised else ""
    return error_in_words(error) + where
