"""The suite as tests of pytest, one for each method and check."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from vpr_bench.check.examination import Examination
from vpr_bench.check.method import METHOD_CHECKS, MethodLike, Subject
from vpr_bench.check.outcome import Failed

if TYPE_CHECKING:
    import pytest


@dataclass(frozen=True, eq=False)
class CheckOfMethod:
    """One check on one method; call it.

    Attributes
    ----------
    examination : Examination
        Of the method.
    id : str
        The check.
    """

    examination: Examination[Subject]
    id: str

    def __call__(self) -> None:
        """Run the check.

        Raises
        ------
        Failed
            If it fails, or passes although the method declares that it fails. Other outcomes are pytest's own: skip
            and xfail.
        """
        import pytest

        found = self.examination.outcome(self.id)
        if found.result == "skip":
            pytest.skip(found.reason)
        if found.result == "expected failure":
            pytest.xfail(found.reason)
        if found.result == "fail":
            raise Failed(f"{self.id}: {found.reason}") from found.error


def parametrize_with_checks(
    methods: Iterable[MethodLike], only: Iterable[str] | None = None
) -> "Callable[[Callable[[CheckOfMethod], None]], pytest.MarkDecorator]":
    """Make one test for each method and check of the function below, which calls its argument ``check``.

    What a method declares in ``expected_failures`` is a strict xfail: it fails if the check passes.

    Parameters
    ----------
    methods : iterable
        Each a name as on the command line, a class, a function that makes a new method each time, or a pair of one of
        the first two with its parameters.
    only : iterable of str, optional
        Ids of checks; by default all.

    Examples
    --------
    ::

        @parametrize_with_checks(["hog", MyMethod, ("twostage", {"n_components": 1})])
        def test_my_methods(check):
            check()
    """
    import pytest

    wanted = None if only is None else list(only)
    examinations = [Examination(METHOD_CHECKS, Subject.of(method), wanted) for method in methods]
    tests = [
        pytest.param(CheckOfMethod(examination, check.id), id=f"{examination.subject.id}-{check.id}")
        for examination in examinations
        for check in examination.checks
    ]
    return pytest.mark.parametrize("check", tests)
