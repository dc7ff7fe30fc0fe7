"""How numbers are written."""

import math

UNDEFINED = "–"


def share(value: float) -> str:
    """Write a value with three decimals.

    Examples
    --------
    >>> share(0.9054), share(float("nan")), share(-0.0001)
    ('0.905', '–', '0.000')
    """
    return UNDEFINED if math.isnan(value) else f"{value:z.3f}"


def short_share(value: float) -> str:
    """Write a value with three decimals in as few marks as can be.

    Examples
    --------
    >>> short_share(0.9054), short_share(1.0), short_share(-0.05)
    ('.905', '1.00', '-.050')
    """
    text = share(value)
    return text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text.removesuffix("0")


def bounds(low: float, high: float) -> str:
    """Write an interval; nothing if it is undefined.

    Examples
    --------
    >>> bounds(0.861, 0.95), bounds(float("nan"), float("nan"))
    ('.86–.95', '')
    """
    return "" if math.isnan(low) or math.isnan(high) else f"{_short(low)}–{_short(high)}"


def fine_bounds(low: float, high: float) -> str:
    """Write an interval as finely as the value in it; nothing if it is undefined.

    Examples
    --------
    >>> fine_bounds(0.8611, 1.0), fine_bounds(float("nan"), float("nan"))
    ('.861–1.00', '')
    """
    return "" if math.isnan(low) or math.isnan(high) else f"{short_share(low)}–{short_share(high)}"


def milliseconds(value: float) -> str:
    """Write a time with three digits that count; of less than a nanosecond nothing is left.

    Examples
    --------
    >>> milliseconds(0.0412), milliseconds(7.268), milliseconds(9.996), milliseconds(1021.4)
    ('0.0412', '7.27', '10.0', '1,021')
    """
    if math.isnan(value):
        return UNDEFINED
    exponent = int(f"{value:.2e}".partition("e")[2])  # of the rounded value
    return f"{value:,.{min(max(2 - exponent, 0), 6)}f}"


def _short(value: float) -> str:
    return f"{value:z.2f}".removeprefix("0").replace("-0.", "-.")
