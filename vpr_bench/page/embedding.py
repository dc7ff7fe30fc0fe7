"""Data inside HTML, written so that nothing in it can end the element that holds it."""

import json
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

_ESCAPED = {ord(mark): f"\\u{ord(mark):04x}" for mark in "<>&\u2028\u2029"}


def as_json(value: Any) -> Markup:
    r"""Write a value as JSON for a ``<script type="application/json">``; NaN becomes null.

    Examples
    --------
    >>> print(as_json({"name": "</script>", "value": float("nan")}))
    {"name":"\u003c/script\u003e","value":null}
    """
    text = json.dumps(_finite(value), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return Markup(text.translate(_ESCAPED))  # noqa: S704 - what HTML could take for its own is gone


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {str(name): _finite(part) for name, part in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_finite(part) for part in value]
    return value


def breakable(text: str) -> Markup:
    """Write text that lines may be broken in where its parts end.

    Examples
    --------
    >>> print(breakable("sad(width=64)<b>"))
    sad(<wbr>width=<wbr>64)&lt;b&gt;
    """
    return Markup("<wbr>").join(re.split(r"(?<=[(,=/])", text))
