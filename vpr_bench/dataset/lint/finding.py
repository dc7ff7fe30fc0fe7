"""One thing that is wrong, or odd, about the images of a dataset or their ground truth."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Literal

from vpr_bench.errors import one_line

Severity = Literal["error", "warning", "note"]
"""An error makes numbers wrong, a warning may; a note is worth knowing."""

SEVERITIES: tuple[Severity, ...] = ("error", "warning", "note")
"""The worst first."""


@dataclass(frozen=True)
class Finding:
    r"""What one check found.

    Attributes
    ----------
    check : str
        Its id, which never changes: ``does-not-decode``.
    severity : {"error", "warning", "note"}
        How bad it is.
    where : str
        The traverse, image, folder or protocol.
    message : str
        What is wrong, in one line; names of files are made fit to print.

    Examples
    --------
    >>> Finding("dark", "warning", "winter", "0 of 3 frames\nare dark").as_dict()
    {'check': 'dark', 'severity': 'warning', 'where': 'winter', 'message': '0 of 3 frames are dark'}
    """

    check: str
    severity: Severity
    where: str
    message: str

    def __post_init__(self) -> None:
        """Take out of foreign names what would move a terminal's cursor or change its colours."""
        object.__setattr__(self, "where", one_line(self.where))
        object.__setattr__(self, "message", one_line(self.message))

    def as_dict(self) -> dict[str, str]:
        """Return it as JSON takes it."""
        return asdict(self)


def listed(names: Sequence[str], most: int = 3) -> str:
    """Name the first few, and say how many more there are.

    Examples
    --------
    >>> listed(["a", "b", "c", "d", "e"]), listed(["a", "b"])
    ('a, b, c and 2 more', 'a, b')
    """
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")


def counted(number: int, noun: str) -> str:
    """Say how many there are of something.

    Examples
    --------
    >>> counted(1, "image"), counted(1200, "image"), counted(2, "query")
    ('1 image', '1,200 images', '2 queries')
    """
    plural = f"{noun[:-1]}ies" if noun.endswith("y") else f"{noun}s"
    return f"{number:,} {noun if number == 1 else plural}"


def share(number: int, total: int, noun: str) -> str:
    """Say how many of all there are.

    Examples
    --------
    >>> share(1, 1200, "query")
    '1 of 1,200 queries'
    """
    return f"{number:,} of {counted(total, noun)}"
