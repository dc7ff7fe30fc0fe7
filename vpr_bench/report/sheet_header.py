"""The head of a contact sheet: the protocol, the counts, and what the colours mean."""

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageDraw

from vpr_bench.dataset.load import Case
from vpr_bench.report.ink import BLUE, GREY, INK, PAPER, RED, cut, font
from vpr_bench.report.sheet_band import COLOURS
from vpr_bench.report.sheet_columns import Column, Kind
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.protocol import UNMEASURED, Protocol

_SIMULATED = "SIMULATED IMAGES"
_MEANINGS: dict[Kind, str] = {
    "match": "true match: the nearest first, the farthest last",
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
    if case.protocol.edition == "simulated":
        face = font(15, bold=True)
        badge = round(face.getlength(_SIMULATED)) + 24
        pen.rounded_rectangle((width - badge, 0, width - 1, 29), 6, RED)
        pen.text((width - badge + 12, 6), _SIMULATED, PAPER, face)
        room -= badge + 20
    pen.text((0, 0), cut(str(case.protocol), room, font(24, bold=True)), INK, font(24, bold=True))
    pen.text((0, 40), cut(_counts(case), width, font(15)), INK, font(15))
    without = int(np.sum(~case.ground_truth.has_match))
    pen.text((0, 63), cut(_matches(case.ground_truth), width, font(15)), RED if without else INK, font(15))
    _draw_legend(pen, {one.kind for column in columns for one in column.shown})
    return header


def _counts(case: Case) -> str:
    protocol = case.protocol
    return (
        f"{len(case.queries):,} queries of {protocol.queries}, looked up in "
        f"{len(case.references):,} references of {protocol.references}: {_place(protocol)}"
    )


def _place(protocol: Protocol) -> str:
    """Say in words what counts as the same place."""
    if protocol.unit == "nearest":
        return f"the {protocol.radius:.0f} nearest are its place"
    if protocol.unit in UNMEASURED:
        return "those of the same id are its place" if protocol.unit == "pair" else "the dataset lists what is its place"
    return f"those at most {protocol.radius:g} {'frames' if protocol.unit == 'f' else 'metres'} away are its place"


def _matches(truth: GroundTruth) -> str:
    """Say how many queries have no match, and how many matches the others have."""
    per_query = np.diff(truth.offsets)
    without = int(np.sum(per_query == 0))
    if without == len(per_query):
        said = "No query has a match"
    else:
        share = f"{without:,} queries ({without / len(per_query):.1%}) have no match" if without else ""
        some = per_query[per_query > 0]
        spread = f"{some.min():,}" if some.min() == some.max() else f"{some.min():,} to {some.max():,}"
        each = "match" if some.max() == 1 else "matches"
        said = f"{share}; the others have" if without else "Every query has a match:"
        said = f"{said} {spread} {each} each"
        if some.min() != some.max():
            said += f", {some.mean():.1f} on average"
    return said if truth.soft is None else f"{said}; {len(truth.soft.references):,} pairs are soft"


def _draw_legend(pen: ImageDraw.ImageDraw, kinds: set[Kind]) -> None:
    meanings = [(BLUE, "query"), *((COLOURS[kind], text) for kind, text in _MEANINGS.items() if kind in kinds)]
    left = 0
    for colour, text in meanings:
        pen.rectangle((left, 94, left + 13, 107), outline=colour, width=3)
        pen.text((left + 21, 93), text, GREY, font(13))
        left += round(font(13).getlength(text)) + 49
