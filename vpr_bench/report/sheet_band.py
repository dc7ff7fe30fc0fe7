"""Queries side by side, the references of each below it."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

from PIL import Image, ImageDraw

from vpr_bench.dataset.load import Case
from vpr_bench.report.ink import AMBER, BLUE, GREEN, GREY, INK, PALE, PAPER, cut, fitted, font
from vpr_bench.report.sheet_columns import Column, Kind, Shown
from vpr_bench.types.traverse import Traverse

GAP = 12
"""Pixels between two queries."""

COLOURS: dict[Kind, str] = {"match": GREEN, "soft": AMBER, "miss": GREY, "none": GREY}
_TAGS: dict[Kind, str] = {"match": "", "soft": "soft", "miss": "no match", "none": ""}
_PAD, _FRAME, _LINE, _LEAST = 8, 3, 17, 40
_CAPTION = 2 * _LINE + 5 + _PAD  # two lines, the space above and below them


@dataclass(frozen=True)
class _Cell:
    """A picture, or a space for one, with what stands on it and below it."""

    picture: Image.Image | None
    colour: str
    tag: str
    lines: tuple[str, str]


def draw_band(case: Case, columns: Sequence[Column], first: int, width: int) -> Image.Image:
    """Draw queries side by side, each on a card of its own.

    Parameters
    ----------
    case : Case
        Only the images that are shown are decoded.
    columns : sequence of Column
        At least one.
    first : int
        Number of the first one; the others count on from there.
    width : int
        Of each card, in pixels.
    """
    inner = width - 2 * _PAD
    cells = [_cells(case, column, number, inner) for number, column in enumerate(columns, first)]
    notes = [_note(column) for column in columns]
    rows = zip_longest(*cells)
    heights = [max([_LEAST, *(one.picture.height for one in row if one and one.picture)]) for row in rows]
    tops = [_PAD + sum(heights[:row]) + row * _CAPTION for row in range(len(heights) + 1)]
    height = max(tops[len(column)] + (_LINE if note else 0) for column, note in zip(cells, notes, strict=True))
    band = Image.new("RGB", (len(columns) * (width + GAP) - GAP, height + _PAD // 2), PAPER)
    pen = ImageDraw.Draw(band)
    for number, (column, note) in enumerate(zip(cells, notes, strict=True)):
        left = number * (width + GAP)
        pen.rounded_rectangle((left, 0, left + width - 1, band.height - 1), 8, PALE)
        for cell, top, space in zip(column, tops, heights, strict=False):
            _draw_cell(band, cell, (left + _PAD, top), (inner, space))
        if note:
            _write(pen, note, (left + width // 2, tops[len(column)] - 2), inner, GREY)
    return band


def _cells(case: Case, column: Column, number: int, width: int) -> list[_Cell]:
    query = _Cell(
        _picture(case.queries, column.query, width),
        BLUE,
        str(number),
        (f"query {column.query}", _name(case.queries, column.query)),
    )
    return [query, *(_reference(case, shown, width) for shown in column.shown)]


def _reference(case: Case, shown: Shown, width: int) -> _Cell:
    colour, tag = COLOURS[shown.kind], _TAGS[shown.kind]
    if shown.kind == "none":
        return _Cell(None, colour, "no match", ("", ""))
    away = "" if shown.distance is None else f" · {_length(case, shown.distance)}"
    lines = (f"ref {shown.reference}{away}", _name(case.references, shown.reference))
    return _Cell(_picture(case.references, shown.reference, width), colour, tag, lines)


def _length(case: Case, distance: float) -> str:
    places = case.places.references
    if places is not None and places.ndim > 1 and places.shape[1] > 1:
        return f"{distance:.1f} m" if distance < 1000 else f"{distance / 1000:.1f} km"
    unit = {"f": " frame" if distance == 1 else " frames", "m": " m"}.get(case.protocol.unit, " away")
    return f"{distance:.6g}{unit}"


def _picture(traverse: Traverse, index: int, width: int) -> Image.Image:
    return fitted(traverse[index], (width - 2 * _FRAME, round(1.25 * width)))


def _name(traverse: Traverse, index: int) -> str:
    """Return a file's name; with its folder where several traverses were joined."""
    source = traverse.sources[index]
    if not isinstance(source, Path):
        return traverse.name_of(index)
    return f"{source.parent.name}/{source.name}" if len(traverse.split()) > 1 else source.name


def _note(column: Column) -> str:
    """Say how many more there are than are shown."""
    more = [f"{column.more:,} more"] * (column.more > 0) + [f"{column.more_soft:,} more soft"] * (column.more_soft > 0)
    return f"… and {', '.join(more)}" if more else ""


def _draw_cell(band: Image.Image, cell: _Cell, corner: tuple[int, int], space: tuple[int, int]) -> None:
    pen = ImageDraw.Draw(band)
    (left, top), (width, height) = corner, space
    if cell.picture is None:
        empty = min(height, round(0.6 * width))
        pen.rounded_rectangle((left, top + height - empty, left + width - 1, top + height - 1), 6, PAPER, cell.colour)
        pen.text((left + width // 2, top + height - empty // 2), cell.tag, GREY, font(13, bold=True), "mm")
        return
    x, y = left + (width - cell.picture.width) // 2, top + height - cell.picture.height  # on its lines, not above
    around = (x - _FRAME, y - _FRAME, x + cell.picture.width + _FRAME - 1, y + cell.picture.height + _FRAME - 1)
    pen.rectangle(around, cell.colour)
    band.paste(cell.picture, (x, y))
    if cell.tag:
        face = font(13, bold=True)
        length = round(face.getlength(cell.tag))
        pen.rectangle((around[0], around[1], around[0] + length + 11, around[1] + 20), cell.colour)
        pen.text((around[0] + 6, around[1] + 3), cell.tag, INK if cell.colour == AMBER else PAPER, face)
    below = top + height + 5
    for line, colour in zip(cell.lines, (INK, GREY), strict=True):
        _write(pen, line, (left + width // 2, below), width, colour)
        below += _LINE


def _write(pen: ImageDraw.ImageDraw, text: str, spot: tuple[int, int], width: int, colour: str) -> None:
    face = font(12)
    pen.text(spot, cut(text, width, face), colour, face, "ma")
