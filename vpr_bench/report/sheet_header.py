"""The head of a contact sheet: the protocol, the counts, and what the colours mean."""

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageDraw

from vpr_bench.dataset.load import Case
from vpr_bench.report.ink import BLUE, GREY, INK, PAPER, RED, cut, font
from vpr_bench.report.sheet_band import COLOURS
from vpr_bench.report.sheet_columns import Column, Kind, Shown
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import Protocol

_SIMULATED = "SIMULATED IMAGES"
_MEANINGS: dict[Kind, str] = {
    "match": "true match, {order}",
    "soft": "soft match: neither right nor wrong",
    "miss": "no true match: the nearest reference, for comparison",
}


def draw_header(case: Case, columns: Sequence[Column], width: int) -> Image.Image:
    """Draw it, ``width`` pixels wide.

    Parameters
    ----------
    case : Case
        What is shown.
    columns : sequence of Column
        Only the colours that appear among these are explained.
    width : int
        In pixels.
    """
    header = Image.new("RGB", (width, 112), PAPER)
    pen = ImageDraw.Draw(header)
    room = width
    if case.protocol.simulated:
        face = font(15, bold=True)
        badge = round(face.getlength(_SIMULATED)) + 24
        pen.rounded_rectangle((width - badge, 0, width - 1, 29), 6, RED)
        pen.text((width - badge + 12, 6), _SIMULATED, PAPER, face)
        room -= badge + 20
    pen.text((0, 0), cut(str(case.protocol), room, font(24, bold=True)), INK, font(24, bold=True))
    pen.text((0, 40), cut(_counts(case), width, font(15)), INK, font(15))
    without = int(np.sum(~case.ground_truth.has_match))
    pen.text((0, 63), cut(_matches(case.ground_truth), width, font(15)), RED if without else INK, font(15))
    _draw_legend(pen, [one for column in columns for one in column.shown])
    return header


def _counts(case: Case) -> str:
    queries, references = (cut(name, 320, font(15)) for name in (case.protocol.queries, case.protocol.references))
    return (
        f"{_number(len(case.queries), 'query', 'queries')} ({queries}), looked up in "
        f"{_number(len(case.references), 'reference')} ({references}): {_place(case.protocol)}"
    )


def _place(protocol: Protocol) -> str:
    """Say in words what counts as the same place."""
    if protocol.unit == "nearest":
        return f"the {protocol.radius:.0f} nearest are its place"
    if protocol.unit == "pair":
        return "those of the same id are its place"
    if protocol.unit == "given":
        return "the dataset lists what is its place"
    radius = _number(protocol.radius, "frame" if protocol.unit == "f" else "metre")
    return f"those at most {radius} away are its place"


def _number(count: float, one: str, many: str = "") -> str:
    written = f"{count:,.0f}" if float(count).is_integer() else f"{count:g}"
    return f"{written} {one if count == 1 else many or one + 's'}"


def _matches(truth: GroundTruth) -> str:
    """Say how many queries have no match, and how many matches the others have."""
    per_query = np.diff(truth.offsets)
    without = int(np.sum(per_query == 0))
    if without == len(per_query):
        said = "No query has a match"
    else:
        share = f"{_number(without, 'query', 'queries')} ({without / len(per_query):.1%}) without a match"
        some = per_query[per_query > 0]
        spread = f"{some.min():,}" if some.min() == some.max() else f"{some.min():,} to {some.max():,}"
        each = "match" if some.max() == 1 else "matches"
        said = f"{share}; the others have" if without else "Every query has a match:"
        said = f"{said} {spread} {each} each"
        if some.min() != some.max():
            said += f", {some.mean():.1f} on average"
    return said if truth.soft is None else f"{said}; {len(truth.soft.references):,} pairs are soft"


def _draw_legend(pen: ImageDraw.ImageDraw, shown: Sequence[Shown]) -> None:
    kinds = {one.kind for one in shown}
    measured = any(one.distance is not None for one in shown)
    order = "the nearest first, the farthest last" if measured else "the middle one first, the outermost last"
    left = 0
    meanings = [(COLOURS[kind], text.format(order=order)) for kind, text in _MEANINGS.items() if kind in kinds]
    for colour, words in [(BLUE, "query"), *meanings]:
        pen.rectangle((left, 94, left + 13, 107), outline=colour, width=3)
        pen.text((left + 21, 93), words, GREY, font(13))
        left += round(font(13).getlength(words)) + 49
