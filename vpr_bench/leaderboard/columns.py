"""The columns of ``results.csv``: how each part of a row is written as text, and read back exactly.

Reading is strict: what this program would not have written is refused.
"""

import base64
import binascii
import hashlib
import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import UsageError
from vpr_bench.leaderboard.entry import METRICS, PERCENTILES, PHASES, STAGES, Entry, moment
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.report.foreign import guarded, unguarded
from vpr_bench.types.protocol import Protocol

SCHEMA = 1
SCHEMA_COLUMN, DIGEST_COLUMN = "schema", "digest"


@dataclass(frozen=True)
class _Codec:
    """How one kind of value is written and read; reading raises ValueError."""

    write: Callable[[Any], str]
    read: Callable[[str], Any]


def _whole(text: str) -> int:
    if not re.fullmatch("0|[1-9][0-9]{0,40}", text):
        raise ValueError("it is not a whole number of at least 0")
    return int(text)


def _number(text: str) -> float:
    value = float(text)
    if not 0 <= value < math.inf:
        raise ValueError("it is not a number of at least 0")
    return value


def _share(text: str) -> float:
    value = _number(text) if text else math.nan
    if value > 1:
        raise ValueError("it does not lie between 0 and 1")
    return value


def _flag(text: str) -> bool:
    if text not in ("true", "false"):
        raise ValueError("it is neither true nor false")
    return text == "true"


def _digits(count: int) -> _Codec:
    def read(text: str) -> str:
        if not re.fullmatch(f"[0-9a-f]{{{count}}}", text):
            raise ValueError(f"it is not {count} hexadecimal digits")
        return text

    return _Codec(str, read)


def _time(text: str) -> str:
    moment(text)
    return text


def _maybe(codec: _Codec) -> _Codec:
    """Leave the cell empty where there is nothing to say."""
    return _Codec(
        lambda value: "" if value is None else codec.write(value), lambda text: codec.read(text) if text else None
    )


_TEXT = _Codec(guarded, unguarded)
_WHOLE = _Codec(str, _whole)
_NUMBER = _Codec(lambda value: repr(float(value)), _number)
_SHARE = _Codec(lambda value: "" if math.isnan(value) else repr(float(value)), _share)
_FLAG = _Codec(lambda value: "true" if value else "false", _flag)

_WHAT: dict[str, _Codec] = {
    "method": _TEXT,
    "protocol": _Codec(str, Protocol.parse),
    "partial": _FLAG,
    "n_references": _WHOLE,
    "n_queries": _WHOLE,
    "n_available": _WHOLE,
    "n_counted": _WHOLE,
}
_HOW: dict[str, _Codec] = {
    "elsewhere": _maybe(_SHARE),
    "fit_seconds": _NUMBER,
    "machine": _digits(8),
    "machine_about": _TEXT,
    "sequential": _FLAG,
    "future": _WHOLE,
    "weights": _maybe(_TEXT),
    "version": _TEXT,
    "seed": _WHOLE,
    "k": _WHOLE,
    "threads": _WHOLE,
    "dataset_digest": _TEXT,
    "run": _digits(12),
    "package": _TEXT,
    "commit": _maybe(_TEXT),
    "changed": _maybe(_FLAG),
    "created": _Codec(str, _time),
}
_METRICS = {name: (name, f"{name}_low", f"{name}_high") for name in METRICS}
_LATENCY = [f"latency_{stage}_p{percentile}" for stage in STAGES for percentile in PERCENTILES]
_MEMORY = {phase: f"peak_memory_{phase}" for phase in PHASES}

COLUMNS: dict[str, _Codec] = {
    **_WHAT,
    **{column: _SHARE for columns in _METRICS.values() for column in columns},
    **dict.fromkeys(_LATENCY, _maybe(_NUMBER)),
    **dict.fromkeys(_MEMORY.values(), _maybe(_WHOLE)),
    **_HOW,
    "right": _TEXT,
}
"""All that is said about a row, in order; the schema stands before it and the digest after it."""

HEADER = [SCHEMA_COLUMN, *COLUMNS, DIGEST_COLUMN]


def as_values(entry: Entry) -> dict[str, Any]:
    """Return a row with one value per column; an undefined metric is NaN, what was not measured or noted is None."""
    values = {name: getattr(entry, name) for name in _WHAT}
    for name, columns in _METRICS.items():
        interval = entry.metrics[name]
        values |= zip(columns, (interval.value, interval.low, interval.high), strict=True)
    values |= {name: entry.latency.get(name) for name in _LATENCY}
    values |= {column: entry.peak_memory.get(phase) for phase, column in _MEMORY.items()}
    return values | {name: getattr(entry, name) for name in _HOW} | {"right": pack(entry.right)}


def write_row(entry: Entry) -> list[str]:
    """Return the cells of a row in the order of ``HEADER``."""
    cells = [str(SCHEMA), *(COLUMNS[name].write(value) for name, value in as_values(entry).items())]
    return [*cells, digest_of(cells)]


def read_row(cells: Mapping[str, str]) -> Entry:
    """Make a row of its cells by column; those of the schema and the digest are not looked at.

    Raises
    ------
    ValueError
        If a cell holds nonsense, or two contradict each other; names the column.
    """
    values = {name: _read_cell(name, cells[name]) for name in COLUMNS}
    entry = Entry(
        **{name: values[name] for name in (*_WHAT, *_HOW)},
        metrics={name: _interval(name, *(values[column] for column in columns)) for name, columns in _METRICS.items()},
        latency={name: values[name] for name in _LATENCY if values[name] is not None},
        peak_memory={phase: values[column] for phase, column in _MEMORY.items() if values[column] is not None},
        right=unpack(values["right"], values["n_counted"]),
    )
    _check(entry)
    return entry


def check_row(entry: Entry) -> None:
    """Refuse what could be written and not be read back.

    Raises
    ------
    ValueError
        As :func:`read_row`.
    """
    read_row(dict(zip(HEADER, write_row(entry), strict=True)))


def digest_of(cells: list[str]) -> str:
    """Return the first 12 hexadecimal digits of the SHA-256 over all cells of a row but the last."""
    return hashlib.sha256(json.dumps(cells).encode()).hexdigest()[:12]


def pack(right: NDArray[np.bool_]) -> str:
    """Write (n,) bool as base64 (the URL-safe kind, without padding), eight to a byte.

    Examples
    --------
    >>> pack(np.array([True, False, True, True, False]))
    'sA'
    >>> unpack("sA", 5).tolist()
    [True, False, True, True, False]
    """
    return base64.urlsafe_b64encode(np.packbits(right).tobytes()).decode().rstrip("=")


def unpack(text: str, count: int) -> NDArray[np.bool_]:
    """Read ``count`` truth values that :func:`pack` wrote.

    Raises
    ------
    ValueError
        If the text is not what it writes.
    """
    try:
        packed = np.frombuffer(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)), np.uint8)
    except (binascii.Error, ValueError):
        packed = np.zeros(0, np.uint8)
    right = np.unpackbits(packed)[:count].astype(bool)
    if len(right) != count or pack(right) != text:
        raise ValueError(f"right does not hold {count} truth values")
    return right


def _read_cell(name: str, text: str) -> Any:
    codec = COLUMNS[name]
    try:
        value = codec.read(text)
    except (ValueError, UsageError) as error:
        raise ValueError(f"{name} is {text[:80]!r}: {error}") from None
    if codec.write(value) != text:
        raise ValueError(f"{name} is {text[:80]!r}, which would be written {codec.write(value)[:80]!r}")
    return value


def _interval(name: str, value: float, low: float, high: float) -> Interval:
    if math.isnan(low) != math.isnan(high) or low > high:
        raise ValueError(f"the bounds of {name} are no interval")
    return Interval(value, low, high)


def _check(entry: Entry) -> None:
    if not entry.n_counted <= entry.n_queries <= entry.n_available:
        raise ValueError("n_counted, n_queries and n_available must not fall in that order")
    found = float(entry.right.mean()) if entry.n_counted else math.nan
    stated = entry.metrics["recall@1"].value
    if stated != found and not (math.isnan(stated) and math.isnan(found)):
        raise ValueError(f"recall@1 is {stated!r}, and right gives {found!r}")
