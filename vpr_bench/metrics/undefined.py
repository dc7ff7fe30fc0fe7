"""Numbers that may be undefined, as JSON has them."""

import math


def or_none(value: float | None) -> float | None:
    """Return a number, None for NaN.

    Examples
    --------
    >>> or_none(0.5), or_none(float("nan"))
    (0.5, None)
    """
    return None if value is None or math.isnan(value) else value
