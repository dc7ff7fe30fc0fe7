"""Printing what a map answers."""

import json
from collections.abc import Sequence
from typing import Any, Literal

from vpr_bench.cli.console import show, write
from vpr_bench.errors import one_line
from vpr_bench.maps.answer import Answer
from vpr_bench.maps.map import Map

_STAGES = ("decode", "encode", "match", "rerank", "total")


def print_answers(asked: Map, answers: Sequence[Answer], loaded: float, form: Literal["table", "json", "csv"]) -> None:
    """Print answers on stdout.

    Parameters
    ----------
    asked : Map
        What was asked.
    answers : sequence of Answer
        One per photo.
    loaded : float
        Seconds until the map was ready.
    form : {"table", "json", "csv"}
        A row per place in the first and the last.
    """
    if form == "json":
        content = {
            "map": str(asked.folder),
            "method": asked.record.method.label,
            "n_references": len(asked),
            "load_ms": _ms(loaded),
            "photos": [_as_json(answer) for answer in answers],
        }
        write(json.dumps(content, indent=2, ensure_ascii=False))
    elif form == "csv":
        _write_csv(answers)
    elif answers:
        _show_table(answers, loaded)


def _as_json(answer: Answer) -> dict[str, Any]:
    return {
        "photo": answer.photo.name,
        "places": [
            {"rank": one.rank, "reference": one.reference, "file": one.file, "place": one.place, "score": one.score}
            for one in answer.locations
        ],
        "milliseconds": {stage: _ms(seconds) for stage, seconds in answer.seconds.items()},
    }


def _write_csv(answers: Sequence[Answer]) -> None:
    import csv
    import io

    from vpr_bench.report.places import place_text

    stages = _stages(answers)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["photo", "rank", "reference", "file", "place", "score", *(f"{stage}_ms" for stage in stages)])
    for answer in answers:
        times = [_ms(answer.seconds[stage]) if stage in answer.seconds else "" for stage in stages]
        for one in answer.locations:
            place = place_text(one.place)
            writer.writerow([answer.photo.name, one.rank, one.reference, one.file, place, one.score, *times])
        if not answer.locations:
            writer.writerow([answer.photo.name, *[""] * 5, *times])
    write(text.getvalue().rstrip("\n"))


def _show_table(answers: Sequence[Answer], loaded: float) -> None:
    from rich.table import Table
    from rich.text import Text

    from vpr_bench.report.places import place_text

    stages = _stages(answers)
    table = Table(box=None, pad_edge=False, header_style="bold", caption_justify="left")
    for column in ("photo", "rank", "reference", "file", "place", "score", *(f"{stage} ms" for stage in stages)):
        table.add_column(column, overflow="fold", justify="left" if column in ("photo", "file") else "right")
    for answer in answers:
        head = [one_line(answer.photo.name), *[""] * 5, *(_written(answer, stage) for stage in stages)]
        for number, one in enumerate(answer.locations):
            row = [str(one.rank), str(one.reference), one_line(one.file), place_text(one.place), f"{one.score:.4g}"]
            table.add_row(*map(Text, [head[0], *row, *head[6:]] if number == 0 else ["", *row]))
        if not answer.locations:
            table.add_row(*map(Text, [head[0], "", "", "nothing answered", *head[4:]]))
    table.caption = f"The map was ready after {loaded:.2f} s."
    show(table)


def _stages(answers: Sequence[Answer]) -> list[str]:
    found = {stage for answer in answers for stage in answer.seconds}
    return sorted(found, key=lambda stage: (_STAGES.index(stage) if stage in _STAGES else len(_STAGES) - 1.5, stage))


def _written(answer: Answer, stage: str) -> str:
    return f"{1000 * answer.seconds[stage]:.1f}" if stage in answer.seconds else ""


def _ms(seconds: float) -> float:
    return round(1000 * seconds, 3)
