"""A value per query, as text of 20 to the line, so that a line-by-line comparison shows which queries moved."""

from collections.abc import Sequence

PER_LINE = 20


def to_lines(values: Sequence[str]) -> list[str]:
    """Write values, each line with the number of its first query in front.

    Examples
    --------
    >>> to_lines([str(value) for value in range(100, 122)])[1]
    '20: 120 121'
    """
    starts = range(0, len(values), PER_LINE)
    return [f"{start}: {' '.join(values[start : start + PER_LINE])}" for start in starts]


def from_lines(lines: Sequence[str], n: int) -> list[str]:
    """Read what :func:`to_lines` wrote.

    Raises
    ------
    ValueError
        If it is anything else, or not ``n`` values.
    """
    values = [value for line in lines for value in line.partition(": ")[2].split(" ")]
    if len(values) != n:
        raise ValueError(f"there are {len(values)} values for {n} queries")
    if not all(values) or to_lines(values) != list(lines):
        raise ValueError(f"each line must be its first query, a colon, and {PER_LINE} values")
    return values
