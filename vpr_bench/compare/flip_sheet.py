"""A picture of the queries that only one of two runs answers right."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from vpr_bench.compare.flipped import Best, FlippedQuery
from vpr_bench.compare.paired import PairedComparison
from vpr_bench.compare.tables import label_of, names_of
from vpr_bench.report.ink import BLUE, GREEN, GREY, INK, RED
from vpr_bench.report.panel import Panel
from vpr_bench.report.panel_sheet import draw_panel_sheet
from vpr_bench.report.pictures import RunPictures

MOST = 12
"""Queries that are drawn each way; of more, some that are spread over the whole traverse."""

_NOT_HERE = "image not here"


def draw_flips(comparison: PairedComparison, pictures: RunPictures, file: Path) -> Path:
    """Draw each query beside A's answer, B's answer and its true place; first those that only A answers right.

    Parameters
    ----------
    comparison : PairedComparison
        In which at least one query flipped.
    pictures : RunPictures
        Of either run; what is not here leaves a space.
    file : Path
        Where to write, as PNG.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    flipped = [*_some(comparison.lost), *_some(comparison.gained)]
    rows = [_row(one, pictures) for one in flipped]
    said = (
        f"{comparison.protocol}: right answers only by A {len(comparison.lost):,}, only by B {len(comparison.gained):,}"
    )
    if len(flipped) < len(comparison.lost) + len(comparison.gained):
        said += f"; up to {MOST} of each are shown"
    return draw_panel_sheet(file, _title(comparison), said, rows, warning="SIMULATED" if comparison.simulated else "")


def _title(comparison: PairedComparison) -> str:
    labels = [label_of(run) for run in (comparison.first, comparison.second)]
    if labels[0] == labels[1]:
        labels = [f"{label} ({name})" for label, name in zip(labels, names_of(comparison), strict=True)]
    return f"A  {labels[0]}   ·   B  {labels[1]}"


def _some(flipped: Sequence[FlippedQuery]) -> list[FlippedQuery]:
    """Return at most ``MOST`` of them, evenly spread: neighbours look alike."""
    chosen = np.linspace(0, len(flipped) - 1, min(MOST, len(flipped))).round().astype(int)
    return [flipped[index] for index in chosen]


def _row(one: FlippedQuery, pictures: RunPictures) -> list[Panel]:
    name = pictures.query_name(one.query) if pictures.case else ""
    title = f"Query {one.query}: only {'B' if one.gained else 'A'} is right"
    return [
        Panel(title, BLUE, pictures.query_image(one.query), _NOT_HERE, (name, "")),
        _answer("A", one.first, pictures, right=not one.gained),
        _answer("B", one.second, pictures, right=one.gained),
        _reference("True place", INK, one.truth, "nearest true reference", pictures),
    ]


def _answer(who: str, best: Best, pictures: RunPictures, *, right: bool) -> Panel:
    if best.reference is None:
        return Panel(f"{who}: no answer", GREY, None, "nothing answered")
    title, colour = (f"{who}: right", GREEN) if right else (f"{who}: wrong", RED)
    return _reference(title, colour, best.reference, f"score {best.score:.4g}", pictures)


def _reference(title: str, colour: str, reference: int, said: str, pictures: RunPictures) -> Panel:
    name = pictures.reference_name(reference) if pictures.case else ""
    return Panel(
        title, colour, pictures.reference_image(reference), _NOT_HERE, (f"reference {reference} · {said}", name)
    )
