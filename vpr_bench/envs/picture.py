"""A picture of one query beside its answer and the truth."""

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from vpr_bench.dataset.load import Case
from vpr_bench.envs.exchange import Exchange, Verdict, spans
from vpr_bench.report.ink import BLUE, GREEN, GREY, INK, PAPER, RED, cut, font
from vpr_bench.report.panel import Panel, draw_panel, panel_size

_COLOURS: dict[Verdict, str] = {"right": GREEN, "wrong": RED, "no answer": RED, "not counted": GREY}
_WIDTH, _LEAST, _MOST = 320, 120, 400
"""Of a picture, and between what its height lies; pixels."""

_GAP, _HEAD = 16, 58
_SIMULATED = "SIMULATED"


def draw(case: Case, shape: tuple[int, int, int], waiting: int | None, one: Exchange | None) -> NDArray[np.uint8]:
    """Draw the last answer or, before there is one, the query that waits for it.

    Parameters
    ----------
    case : Case
        Images and places.
    shape : (height, width, 3)
        Of the observations; it decides the size of the picture, which never changes.
    waiting : int, optional
        The query that waits for an answer, shown without its name where ``one`` is None.
    one : Exchange, optional
        The query that was answered.

    Returns
    -------
    (H, W, 3) uint8
        RGB.
    """
    height = min(_MOST, max(_LEAST, 2 * round(_WIDTH * shape[0] / shape[1] / 2)))  # even, as video encoders want it
    if one is None:
        shown = None if waiting is None else case.queries[waiting]
        panels = [
            Panel("Query", BLUE, shown, ""),
            Panel("Answer", GREY, None, "not answered yet"),
            Panel("Truth", GREY, None, ""),
        ]
    else:
        panels = [_query(case, one), _answer(case, one), _truth(case, one)]
    box = (_WIDTH, height)
    width, tall = panel_size(box)
    canvas = Image.new("RGB", (3 * width + 4 * _GAP, _HEAD + tall + _GAP), PAPER)
    pen = ImageDraw.Draw(canvas)
    _draw_head(pen, case, one, canvas.width)
    for number, panel in enumerate(panels):
        draw_panel(canvas, panel, (_GAP + number * (width + _GAP), _HEAD), box)
    return np.array(canvas)


def _query(case: Case, one: Exchange) -> Panel:
    return Panel("Query", BLUE, case.queries[one.query], "", (f"query {one.query}", case.queries.name_of(one.query)))


def _answer(case: Case, one: Exchange) -> Panel:
    title, colour = "No answer" if one.verdict == "no answer" else f"Answer: {one.verdict}", _COLOURS[one.verdict]
    if one.answer < 0:
        return Panel(title, colour, None, "nothing answered")
    lines = (f"reference {one.answer} · score {one.score:.4g}", case.references.name_of(one.answer))
    return Panel(title, colour, case.references[one.answer], "", lines)


def _truth(case: Case, one: Exchange) -> Panel:
    if not len(one.truth):
        return Panel("Truth", GREY, None, "no true match")
    best = case.places.nearest_of(one.query, one.truth)
    more = f" · {spans(one.truth)} are right" if len(one.truth) > 1 else ""
    return Panel("Truth", GREEN, case.references[best], "", (f"reference {best}{more}", case.references.name_of(best)))


def _draw_head(pen: ImageDraw.ImageDraw, case: Case, one: Exchange | None, width: int) -> None:
    room = width - 2 * _GAP
    if case.protocol.simulated:
        face = font(13, bold=True)
        badge = round(face.getlength(_SIMULATED)) + 16
        pen.rounded_rectangle((width - _GAP - badge, 10, width - _GAP - 1, 31), 5, RED)
        pen.text((width - _GAP - badge // 2, 21), _SIMULATED, PAPER, face, "mm")
        room -= badge + _GAP
    pen.text((_GAP, 10), cut(str(case.protocol), room, font(17, bold=True)), INK, font(17, bold=True))
    said = f"{len(case.queries)} queries, none answered yet"
    if one is not None:
        said = f"{one.asked} of {len(case.queries)} queries answered, {one.earned} right ({one.earned / one.asked:.0%})"
    pen.text((_GAP, 34), said, GREY, font(13))
