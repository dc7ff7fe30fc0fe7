"""Measure what docs/results.md shows: ``python docs/results/measure.py [--only PART] [--output RUNS]``.

Runs are stored as by ``vpr-bench run``: a second start goes on where the first one stopped. ``runs.csv``,
``radius.csv`` and the pictures beside this file are written as results come, and the page from them.
"""

import argparse
import csv
import io
import os
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

# As the command line does: threads that spin while they wait cost more than they save.
os.environ["GOMP_SPINCOUNT"] = os.environ.get("GOMP_SPINCOUNT", "10000")
os.environ["OPENBLAS_THREAD_TIMEOUT"] = os.environ.get("OPENBLAS_THREAD_TIMEOUT", "4")

from cells import HERE, read
from page import write_page
from plan import NIGHT, PARTS, Variant, variants

from vpr_bench import load_case, run
from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say
from vpr_bench.errors import VprBenchError
from vpr_bench.files.atomic import write_bytes
from vpr_bench.method.build import build_method
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import bootstrap_difference
from vpr_bench.report.radius_curve import draw_radius_curve
from vpr_bench.report.rows import Row, score_run
from vpr_bench.report.waterfall import draw_waterfall
from vpr_bench.runner.run import RunOptions, find_run, run_key
from vpr_bench.runner.store import RunStore, StoredRun

METRICS = ("recall@1", "recall@5", "pr_auc", "pr_auc_matched")
SWEPT = ("recall@1", "pr_auc", "pr_auc_matched")
RESAMPLES = 2000
_NOT_KEPT = ("latency_", "peak_memory_", "fit_seconds", "folder", "processor", "threads", "partial")

Line = dict[str, Any]


def line_of(variant: Variant, row: Row) -> Line:
    """Return the line of a scored run: what it is of, and its numbers but for times."""
    led = {"part": variant.part, "variant": variant.name, "version": row.run.record.key.version}
    return led | {name: value for name, value in row.flat().items() if not name.startswith(_NOT_KEPT)}


def change(changed: StoredRun, usual: StoredRun) -> Line:
    """Return by how much metrics are above those of the run with default parameters, with 95 % intervals."""
    found = bootstrap_difference(_answers(changed), _answers(usual), SWEPT, RESAMPLES)
    ends = {"": "value", "_low": "low", "_high": "high"}
    return {f"{name}_change{end}": getattr(one, part) for name, one in found.items() for end, part in ends.items()}


def _answers(stored: StoredRun) -> Answers:
    return Answers.from_matches(stored.indices, stored.scores, stored.places.ground_truth(stored.protocol))


def write_lines(name: str, lines: Iterable[Line]) -> None:
    """Write lines into a table, in the order of the plan, over those of the same runs; others stay as they were."""
    order = {(variant.part, variant.name): number for number, variant in enumerate(variants())}
    merged: dict[tuple[str, ...], Line] = {}
    for line in [*read(name), *lines]:
        merged[line["part"], line["variant"], str(line["protocol"])] = line
    kept = [line for line in merged.values() if (line["part"], line["variant"]) in order]
    kept.sort(key=lambda line: (order[line["part"], line["variant"]], float(line["radius"])))
    columns = list(dict.fromkeys(column for line in kept for column in line))
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows({name: _short(value) for name, value in line.items()} for line in kept)
    write_bytes(HERE / name, text.getvalue().encode())


def _short(value: object) -> object:
    return round(value, 6) if isinstance(value, float) else value


def sweep(night: list[tuple[Variant, StoredRun]]) -> None:
    """Score runs of several numbers of components at radius 0 to 10, and draw that and where they lost places."""
    keys = ("part", "variant", "protocol", "radius", *SWEPT)
    rows, lines = [], []
    for variant, stored in night:
        for radius in range(11):
            rows.append(score_run(stored, SWEPT, stored.protocol.with_radius(radius)))
            line = line_of(variant, rows[-1])
            lines.append({key: line[key] for key in keys})
    write_lines("radius.csv", lines)
    if rows:
        draw_radius_curve(rows, SWEPT, HERE / "radius.png")
        draw_waterfall([score_run(stored) for _, stored in night], HERE / "lost.png")


def found(variant: Variant, store: RunStore, *, stored_only: bool) -> StoredRun | None:
    """Run a variant, or take it from the store; with ``stored_only``, None if it is not there."""
    case, built = load_case(variant.source, variant.pairing), build_method(variant.method, variant.parameters)
    if stored_only:
        return find_run(store, run_key(case, built, RunOptions()), "never")
    return run(case, built, store)


def measure(only: str | None, store: RunStore, *, stored_only: bool) -> int:
    """Run everything, or one part; return the exit code."""
    night: list[tuple[Variant, StoredRun]] = []
    usual: dict[str, StoredRun] = {}  # what ablations are compared with, by dataset
    errors: dict[str, int] = {}
    for variant in [one for one in variants() if only in (None, one.part)]:
        say(f"{variant.part}: {variant.name}")
        try:
            stored = found(variant, store, stored_only=stored_only)
        except VprBenchError as error:
            if str(error) not in errors:  # what is not here is missing for many
                complain(str(error))
            errors[str(error)] = error.exit_code
            continue
        if stored is None:
            continue
        line = line_of(variant, score_run(stored, METRICS, resamples=RESAMPLES))
        if variant.part == "ablations":
            line |= change(stored, usual.setdefault(variant.source, stored))
        elif variant.method == "twostage" and variant.pairing == NIGHT:
            night.append((variant, stored))
        write_lines("runs.csv", [line])
    sweep(night)
    write_page()
    return max(errors.values(), default=0)


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description="Measure what docs/results.md shows, and write it.")
    parser.add_argument("--only", choices=PARTS)
    parser.add_argument("--output", type=Path, default=Path("runs"), help="where runs are stored (default: runs)")
    parser.add_argument("--stored-only", action="store_true", help="run nothing, write what is stored")
    given = parser.parse_args()
    with progress_bars():
        sys.exit(measure(given.only, RunStore(given.output), stored_only=given.stored_only))


if __name__ == "__main__":
    main()
