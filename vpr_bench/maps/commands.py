"""The command that makes a map again, from whatever its ``map.json`` still tells."""

import json
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vpr_bench.errors import one_line


def fit_again(content: Mapping[str, Any] | None, folder: Path, defaults: Mapping[str, Any] | None = None) -> str:
    """Return a sentence that says how to make a map again.

    Parameters
    ----------
    content : mapping, optional
        Of a ``map.json`` of any version, as far as it can be read; it may hold anything.
    folder : Path
        Where the map is.
    defaults : mapping, optional
        The method's parameters by default, which need not be said.

    Examples
    --------
    >>> fit_again(None, Path("a.map"))
    'Fit it again with: vpr-bench fit --method … --dataset … -o a.map --overwrite'
    >>> part = {"dataset": "gardens", "edition": "real", "traverse": "day_left"}
    >>> fit_again({"method": {"id": "hog", "parameters": {"cell": 8}}, "parts": [part]}, Path("a.map"), {"cell": 4})
    ... # doctest: +ELLIPSIS
    'Fit it again with: vpr-bench fit --method hog --param cell=8 --dataset gardens --references day_left ...'
    """
    method = _mapping(None if content is None else content.get("method"))
    parts = content.get("parts") if content is not None else None
    first = _mapping(parts[0] if isinstance(parts, list | tuple) and parts else None)
    words = ["--method", _word(method.get("id"))]
    for name, value in _mapping(method.get("parameters")).items() if defaults is not None else ():
        if defaults is not None and value != defaults.get(name):
            words += ["--param", _word(f"{name}={value if isinstance(value, str) else json.dumps(value)}")]
    words += [*source_words(first), "-o", _word(str(folder)), "--overwrite"]
    return f"Fit it again with: vpr-bench fit {' '.join(words)}"


def source_words(part: Mapping[str, Any]) -> list[str]:
    """Return the options that name the references of a part."""
    if part.get("dataset") is None and part.get("folder") is not None:
        return ["--images", _word(part.get("folder"))]
    words = ["--dataset", _word(part.get("folder") or part.get("dataset"))]
    if isinstance(part.get("traverse"), str):
        words += ["--references", _word(part["traverse"])]
    if part.get("edition") not in (None, "real"):
        words += ["--edition", _word(part["edition"])]
    return words


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, Mapping) else {}


def _word(value: Any) -> str:
    """Quote a word for a shell; what is no text is left open. It may be somebody else's."""
    return shlex.quote(f"{one_line(value):.300}") if isinstance(value, str) and value else "…"
