"""A comparison as JSON or CSV for programs: every number, every query that flipped."""

import csv
import io
import json
from collections.abc import Callable, Iterator
from typing import Any

from vpr_bench.compare.caveats import caveats, time_caveats
from vpr_bench.compare.flipped import FlippedQuery
from vpr_bench.compare.paired import PairedComparison
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.metrics.undefined import or_none
from vpr_bench.report.foreign import guarded_cells
from vpr_bench.runner.store import StoredRun

FileOf = Callable[[int], str | None]
"""The file name of a query, None where the images are not here."""

_COLUMNS = (
    *("protocol", "run_a", "run_b", "part", "name", "a", "b", "b_minus_a", "b_over_a", "low", "high", "p_value"),
    *("a_reference", "b_reference", "true_reference", "file"),
)


def to_json(comparison: PairedComparison, file_of: FileOf) -> str:
    """Write everything as one JSON object; undefined numbers are null."""
    return json.dumps(as_dict(comparison, file_of), indent=2, ensure_ascii=False)


def to_csv(comparison: PairedComparison, file_of: FileOf) -> str:
    """Write one line per metric, McNemar's test, stage and flipped query; what a line does not have is empty.

    The values ``a`` and ``b`` of a flipped query, ``lost`` or ``gained``, are the scores of the two answers. A text
    that a spreadsheet would take for a formula has a ``'`` before it.
    """
    same = {"protocol": str(comparison.protocol), **dict(zip(("run_a", "run_b"), comparison.folders, strict=True))}
    text = io.StringIO()
    writer = csv.DictWriter(text, _COLUMNS, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(guarded_cells({**same, **line}) for line in _csv_lines(comparison, file_of))
    return text.getvalue().rstrip("\n")


def as_dict(comparison: PairedComparison, file_of: FileOf) -> dict[str, Any]:
    """Return everything JSON-able.

    Parameters
    ----------
    comparison : PairedComparison
        Of two runs.
    file_of : callable
        The file name of a query, None where it is not known.
    """
    test, speed = comparison.mcnemar, comparison.speed
    return {
        "protocol": str(comparison.protocol),
        "a": _run(comparison.first),
        "b": _run(comparison.second),
        "n_queries": comparison.n_queries,
        "n_counted": comparison.n_counted,
        "resamples": comparison.resamples,
        "seed": comparison.seed,
        "metrics": {
            one.metric: {
                "a": or_none(one.first),
                "b": or_none(one.second),
                "b_minus_a": or_none(one.difference.value),
                **_bounds(one.difference),
                "p_value": or_none(one.p_value),
                "significant": one.significant,
            }
            for one in comparison.metrics
        },
        "right_answers": {
            "both": comparison.both,
            "only_a": test.only_first,
            "only_b": test.only_second,
            "neither": comparison.neither,
            "mcnemar_p_value": test.p_value,
        },
        "latency": {
            "refused": speed.refused or None,
            "stages": {
                one.stage: {
                    "a_ms": or_none(one.first_ms),
                    "b_ms": or_none(one.second_ms),
                    "b_over_a": or_none(one.ratio.value),
                    **_bounds(one.ratio),
                    "p_value": or_none(one.p_value),
                    "significant": one.significant,
                }
                for one in speed.stages
            },
        },
        "lost": [_flip(one, file_of) for one in comparison.lost],
        "gained": [_flip(one, file_of) for one in comparison.gained],
        "notes": [*caveats(comparison), *time_caveats(comparison)],
    }


def _run(run: StoredRun) -> dict[str, Any]:
    record = run.record
    return {
        "method": record.label,
        "run": run.folder.name,
        "folder": str(run.folder),
        "partial": record.partial,
        "machine": str(record.machine),
        "created": record.created,
    }


def _flip(one: FlippedQuery, file_of: FileOf) -> dict[str, Any]:
    return {
        "query": one.query,
        "file": file_of(one.query),
        "a_reference": one.first.reference,
        "a_score": one.first.score,
        "b_reference": one.second.reference,
        "b_score": one.second.score,
        "true_reference": one.truth,
    }


def _csv_lines(comparison: PairedComparison, file_of: FileOf) -> Iterator[dict[str, Any]]:
    content = as_dict(comparison, file_of)
    for name, numbers in content["metrics"].items():
        yield {"part": "metric", "name": name, **_only_columns(numbers)}
    right = content["right_answers"]
    yield {
        "part": "mcnemar",
        "name": "only one right",
        "a": right["only_a"],
        "b": right["only_b"],
        "p_value": right["mcnemar_p_value"],
    }
    for name, numbers in content["latency"]["stages"].items():
        yield {
            "part": "latency_ms",
            "name": name,
            "a": numbers["a_ms"],
            "b": numbers["b_ms"],
            **_only_columns(numbers),
        }
    for part in ("lost", "gained"):
        for flip in content[part]:
            yield {
                "part": part,
                "name": flip["query"],
                "a": flip["a_score"],
                "b": flip["b_score"],
                **_only_columns(flip),
            }


def _only_columns(numbers: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in numbers.items() if name in _COLUMNS}


def _bounds(interval: Interval) -> dict[str, float | None]:
    return {"low": or_none(interval.low), "high": or_none(interval.high)}
