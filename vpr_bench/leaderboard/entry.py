"""One row of ``results.csv``: a method on a protocol, measured on a machine."""

from dataclasses import dataclass
from datetime import UTC, datetime

import numpy as np
from numpy.typing import NDArray

from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.types.protocol import Protocol

METRICS = (
    "recall@1",
    "recall@5",
    "recall@10",
    "pr_auc",
    "pr_auc_matched",
    "average_precision",
    "recall@100p",
    "roc_auc",
    "accuracy",
)
"""The metrics of a row, in the order of its columns."""

STAGES = ("decode", "encode", "match", "rerank", "sequence", "total")
PERCENTILES = (50, 95)
PHASES = ("fit", "match")
"""When peak memory was measured."""

Cell = tuple[str, str, str]
"""Method, protocol id and machine: of one cell there is one row."""

Precedence = tuple[bool, int, datetime, str]
"""Of two rows of one cell the one with the larger one stays."""


@dataclass(frozen=True, eq=False)
class Entry:
    """A method on a protocol, measured on a machine.

    Attributes
    ----------
    method : str
        Its label: the id with the parameters that differ from their defaults.
    protocol : Protocol
        What the metrics were computed on.
    partial : bool
        Only some of the queries were asked: never ranked, and no number is shown.
    n_references : int
        Size of the map.
    n_queries : int
        How many queries were asked.
    n_available : int
        How many there are to ask; more than ``n_queries`` if partial.
    n_counted : int
        How many of those asked are in the denominator of recall.
    metrics : dict
        By id, those of ``METRICS``: the value with its 95 % bootstrap interval over queries; NaN where undefined.
    latency : dict
        Milliseconds per query, ``latency_<stage>_p50|p95``, for those of ``STAGES`` that were measured.
    elsewhere : float or None
        Share of the machine's processor time that other processes took meanwhile; None where it was not noted.
    fit_seconds : float
        Wall time of fitting.
    peak_memory : dict
        Largest resident memory in bytes, by phase.
    machine : str
        Fingerprint, eight hexadecimal digits: latencies may be compared where it is the same.
    machine_about : str
        The machine in a few words.
    sequential : bool
        It uses the queries before the one that is asked.
    future : int
        How many frames after the query it was shown before it answered.
    weights : str or None
        Name and digest.
    version : str
        Of the method.
    seed, k, threads : int
        As in the run's key.
    dataset_digest : str
        Of the images.
    run : str
        The run's 12 hexadecimal digits.
    package : str
        Version of vpr-bench.
    commit : str or None
        Which state of its source; None where it was not noted.
    changed : bool or None
        Whether files differed from that commit; None where that is not known.
    created : str
        UTC time at which the run was complete, ISO 8601.
    right : (n_counted,) bool
        Per query of recall's denominator, in ascending order: its best match is right.
    """

    method: str
    protocol: Protocol
    partial: bool
    n_references: int
    n_queries: int
    n_available: int
    n_counted: int
    metrics: dict[str, Interval]
    latency: dict[str, float]
    elsewhere: float | None
    fit_seconds: float
    peak_memory: dict[str, int]
    machine: str
    machine_about: str
    sequential: bool
    future: int
    weights: str | None
    version: str
    seed: int
    k: int
    threads: int
    dataset_digest: str
    run: str
    package: str
    commit: str | None
    changed: bool | None
    created: str
    right: NDArray[np.bool_]

    @property
    def cell(self) -> Cell:
        """What there is one row of: method, protocol id and machine."""
        return self.method, str(self.protocol), self.machine

    @property
    def precedence(self) -> Precedence:
        """Of two rows of a cell the one with the larger one stays; see :func:`precedence`."""
        return precedence(self.partial, self.k, self.created, self.run)


def precedence(partial: bool, k: int, created: str, run: str) -> Precedence:
    """Order the rows of a cell: complete ones come after partial ones, then those that kept more answers, then newer.

    Parameters are as in :class:`Entry`.

    Raises
    ------
    ValueError
        If ``created`` is no time.
    """
    return not partial, k, moment(created), run


def moment(created: str) -> datetime:
    """Read an ISO 8601 time; one without a time zone is UTC.

    Raises
    ------
    ValueError
        If it is not one.
    """
    when = datetime.fromisoformat(created)
    return when if when.tzinfo else when.replace(tzinfo=UTC)
