"""What a check can come to."""

from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from vpr_bench.errors import one_line

Result = Literal["pass", "fail", "skip", "expected failure"]
"""``skip``: there was nothing to check, or no sense in it; ``expected failure``: as the plug-in itself declares."""


class Failed(AssertionError):  # noqa: N818 - it is no error of the check's
    """Raised by a check: this is wrong, in one or two lines."""


class Skipped(Exception):  # noqa: N818 - it is no error
    """Raised by a check: it does not apply, and why."""


@dataclass(frozen=True)
class Outcome:
    r"""What one check came to.

    Attributes
    ----------
    check : str
        Its id.
    result : {"pass", "fail", "skip", "expected failure"}
        What it came to.
    reason : str
        Why, in one or two lines fit to print; empty if it passed.
    seconds : float
        How long it took.
    error : Exception, optional
        What was raised, for those who want to see where.

    Examples
    --------
    >>> Outcome("map-of-one", "fail", "answered\n2 references").reason
    'answered 2 references'
    """

    check: str
    result: Result
    reason: str = ""
    seconds: float = 0.0
    error: BaseException | None = field(default=None, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Take out of foreign messages what would move a terminal's cursor or change its colours."""
        object.__setattr__(self, "reason", one_line(self.reason))

    def as_dict(self) -> dict[str, Any]:
        """Return it as JSON takes it."""
        facts = asdict(self)
        del facts["error"]
        return {**facts, "seconds": round(self.seconds, 3)}
