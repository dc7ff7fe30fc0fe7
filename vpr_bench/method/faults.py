"""What is wrong with what a method answered; :class:`~vpr_bench.types.match.Match` itself refuses the rest."""

from typing import Any

from vpr_bench.method.interfaces import Method, Selective
from vpr_bench.types.match import Match


def fault_in(answer: Any, n_references: int, k: int) -> str:
    """Say why this is no answer to a request for ``k`` of so many references; empty if it is one.

    Examples
    --------
    >>> fault_in(Match([7], [0.5]), n_references=5, k=1), fault_in(Match([4], [0.5]), n_references=5, k=1)
    ('reference 7 of a map of 5', '')
    """
    if not isinstance(answer, Match):
        return f"a {type(answer).__name__} instead of a Match"
    if len(answer) > k:
        return f"{_counted(len(answer))} where {k} were asked for"
    if answer.indices.max(initial=-1) >= n_references:
        return f"reference {answer.indices.max()} of a map of {n_references}"
    return ""


def shortfall_in(answer: Match, method: Method, n_references: int, k: int) -> str:
    """Say that an answer is shorter than it should be; empty if it is not, or the method declares why it may be."""
    wanted = min(k, n_references)
    if len(answer) >= wanted or why_fewer(method):
        return ""
    return (
        f"{_counted(len(answer))} where {wanted} were asked for. If it is meant to, its class has to say why: "
        "may_answer_fewer = '…'"
    )


def why_fewer(method: Method) -> str:
    """Return why a method may answer with fewer references than it was asked for; empty if it should not."""
    return str(method.may_answer_fewer) if isinstance(method, Selective) else ""


def _counted(references: int) -> str:
    return f"{references or 'no'} reference{'s' if references != 1 else ''}"
