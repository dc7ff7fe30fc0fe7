"""What the gate found: one verdict per cell."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from vpr_bench.errors import VprBenchError, one_line
from vpr_bench.gate.latency_change import LatencyChange
from vpr_bench.gate.metric_change import MetricChange

Outcome = Literal["pass", "fail", "missing", "new", "error"]
"""``new`` runs have no cell, and ``missing`` cells no run; an ``error`` could not be judged."""

_CODES: dict[Outcome, int] = {"pass": 0, "fail": 1, "missing": 1, "new": 0, "error": 3}


@dataclass(frozen=True)
class Changed:
    """A query whose best answer is another reference; -1 stands for no answer."""

    query: int
    before: int
    after: int


@dataclass(frozen=True)
class Verdict:
    """What became of one cell, or of a run without one.

    Attributes
    ----------
    label, protocol : str
        Which.
    outcome : {"pass", "fail", "missing", "new", "error"}
        What it came to.
    reasons : sequence of str
        Why, a sentence each, unless it passed.
    notes : sequence of str
        What else is not as it was, and what became better.
    metrics : sequence of MetricChange
        Those that are judged.
    lost, gained : sequence of int
        Queries that were answered right and are not now, and the other way round.
    changed : sequence of Changed
        All queries whose best answer is another one, flipped or not.
    latency : LatencyChange or None
        Of the median query.
    run : Path or None
        The folder of the run that was judged.
    seconds : float
        That the run took: fitting, and answering.
    code : int or None
        The exit code that an error deserves, if it is not 3.
    names : mapping
        File names of queries, as far as they are known.
    """

    label: str
    protocol: str
    outcome: Outcome
    reasons: Sequence[str] = ()
    notes: Sequence[str] = ()
    metrics: Sequence[MetricChange] = ()
    lost: Sequence[int] = ()
    gained: Sequence[int] = ()
    changed: Sequence[Changed] = ()
    latency: LatencyChange | None = None
    run: Path | None = None
    seconds: float = 0.0
    code: int | None = None
    names: Mapping[int, str] = field(default_factory=dict)

    @property
    def exit_code(self) -> int:
        """What a command that found this ends with."""
        return _CODES[self.outcome] if self.code is None else self.code

    @property
    def improved(self) -> bool:
        """Whether a metric is better, and none fails."""
        return self.outcome == "pass" and any(change.difference > 0 for change in self.metrics)

    def name_of(self, query: int) -> str:
        """Return a query's file name, else its number."""
        return self.names.get(query, f"query {query}")

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able, NaN as None."""
        return {
            "method": self.label,
            "protocol": self.protocol,
            "verdict": self.outcome,
            "reasons": list(self.reasons),
            "notes": list(self.notes),
            "improved": self.improved,
            "metrics": {change.metric: change.as_dict() for change in self.metrics},
            "lost": [self._query(query) for query in self.lost],
            "gained": [self._query(query) for query in self.gained],
            "changed": [
                {**self._query(one.query), "before": _or_none(one.before), "after": _or_none(one.after)}
                for one in self.changed
            ],
            "latency": None if self.latency is None else self.latency.as_dict(),
            "run": None if self.run is None else str(self.run),
            "seconds": self.seconds if math.isfinite(self.seconds) else None,
        }

    def _query(self, query: int) -> dict[str, Any]:
        return {"query": query, "name": self.names.get(query)}


@dataclass(frozen=True)
class Judgement:
    """All verdicts of one call.

    Attributes
    ----------
    verdicts : sequence of Verdict
        In the order of the baseline, what has no cell last.
    left_out : int
        Cells that the caller did not ask about.
    skipped : sequence of Path
        Folders of the runs that were asked only some of the queries, which are judged by nothing.
    recording : bool
        A baseline is being recorded: what is new is good as it is.
    """

    verdicts: Sequence[Verdict]
    left_out: int = 0
    skipped: Sequence[Path] = ()
    recording: bool = False

    @property
    def exit_code(self) -> int:
        """0 if all is well, 3 where something could not be judged for its data, else 1; also if nothing was judged."""
        return max((one.exit_code for one in self.verdicts), default=0) or int(self.idle)

    @property
    def idle(self) -> bool:
        """Whether no cell was judged, so that nothing could fail, although that was the purpose."""
        return not self.recording and self.count("new") == len(self.verdicts)

    def count(self, outcome: Outcome) -> int:
        """Return how many came to this."""
        return sum(one.outcome == outcome for one in self.verdicts)

    def summary(self) -> str:
        """Say in one line how many came to what.

        Examples
        --------
        >>> Judgement([Verdict("hog", "a/b-c@1f", "pass"), Verdict("sad", "a/b-c@1f", "missing")]).summary()
        '1 passed, 1 missing'
        """
        words: dict[Outcome, str] = {
            "pass": "passed",
            "fail": "failed",
            "missing": "missing",
            "error": "not judged",
            "new": "new",
        }
        told = [f"{self.count(outcome)} {word}" for outcome, word in words.items() if self.count(outcome)]
        told += [f"{self.left_out} not asked about"] if self.left_out else []
        told += [f"{len(self.skipped)} partial skipped"] if self.skipped else []
        return ", ".join([*told, "nothing was judged"] if self.idle else told) or "nothing to record"

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able."""
        return {
            "passed": self.exit_code == 0,
            "summary": self.summary(),
            "left_out": self.left_out,
            "skipped": [str(folder) for folder in self.skipped],
            "cells": [one.as_dict() for one in self.verdicts],
        }


def error(label: str, protocol: str, fault: VprBenchError, run: Path | None = None) -> Verdict:
    """Return the verdict on what could not be judged; ``run`` is the folder of its run, if it has one."""
    return Verdict(label, protocol, "error", reasons=[one_line(fault)], run=run, code=fault.exit_code)


def missing(label: str, protocol: str, near: Sequence[str] = ()) -> Verdict:
    """Return the verdict on a cell without a run; ``near`` says which ones nearly belong to it."""
    return Verdict(label, protocol, "missing", reasons=["there is no run of it: --run makes one", *near])


def new(label: str, protocol: str, metrics: Sequence[MetricChange], run: Path, seconds: float) -> Verdict:
    """Return the verdict on a run without a cell: its metrics, and nothing to compare them with."""
    told = "the baseline does not hold it: --update records it"
    return Verdict(label, protocol, "new", reasons=[told], metrics=metrics, run=run, seconds=seconds)


def _or_none(reference: int) -> int | None:
    return None if reference < 0 else reference
