"""A list of checks for plug-ins of one kind."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from vpr_bench.errors import UsageError, closest

S = TypeVar("S")


@dataclass(frozen=True)
class Check(Generic[S]):
    """One check.

    Attributes
    ----------
    id : str
        Never changes.
    summary : str
        What must hold, in one line.
    function : callable
        Raises :class:`~vpr_bench.check.outcome.Failed` or :class:`~vpr_bench.check.outcome.Skipped`; whatever else it
        raises is a failure too.
    builds_on : tuple of str
        Checks without which this one says nothing: where one of them fails, the fault is reported there alone.
    """

    id: str
    summary: str
    function: Callable[[S], None]
    builds_on: tuple[str, ...] = ()


class Suite(Generic[S]):
    """All checks of one kind, in the order in which they are run.

    Parameters
    ----------
    groups : sequences of Check
        One after the other.

    Raises
    ------
    ValueError
        If two checks have the same id, or one builds on a later one.
    """

    def __init__(self, *groups: Sequence[Check[S]]) -> None:
        self._checks: dict[str, Check[S]] = {}
        for check in (check for group in groups for check in group):
            if check.id in self._checks or not self._checks.keys() >= set(check.builds_on):
                raise ValueError(f"the check {check.id!r} is there already, or builds on one that is not there yet")
            self._checks[check.id] = check

    def __iter__(self) -> Iterator[Check[S]]:
        return iter(self._checks.values())

    def __getitem__(self, name: str) -> Check[S]:
        """Find a check by its id.

        Raises
        ------
        UsageError
            If there is none; the closest one is suggested.
        """
        if name not in self._checks:
            raise UsageError(f"There is no check {name!r}. {closest(name, self._checks)}")
        return self._checks[name]

    def foundations(self, name: str) -> list[str]:
        """Return the checks that one builds on, and those that these build on, in their order."""
        found: set[str] = set()
        waiting = list(self[name].builds_on)
        while waiting:
            one = waiting.pop()
            found.add(one)
            waiting += self[one].builds_on
        return [one for one in self._checks if one in found]

    def chosen(self, only: Iterable[str] | None = None) -> list[Check[S]]:
        """Return the named checks in their usual order, all if none is named.

        Raises
        ------
        UsageError
            If one of them does not exist.
        """
        names = {self[name].id for name in only or ()}
        return [check for check in self if not names or check.id in names]


def check(name: str, *builds_on: str) -> Callable[[Callable[[S], None]], Check[S]]:
    """Make a check of the function below; its docstring begins with "Check that" and says what must hold."""

    def make(function: Callable[[S], None]) -> Check[S]:
        summary = (function.__doc__ or "").strip().partition("\n")[0].removeprefix("Check that ").rstrip(".")
        return Check(name, summary, function, builds_on)

    return make
