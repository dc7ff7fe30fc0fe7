"""A sheet of panels: a title, and rows of pictures of one size."""

from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw

from vpr_bench.files.atomic import replacing
from vpr_bench.report.ink import GREY, INK, PAPER, RED, cut, font
from vpr_bench.report.panel import Panel, draw_panel, panel_size

_WIDTH, _LEAST, _MOST = 264, 100, 330
"""Of a picture, and between what its height lies; pixels."""

_MARGIN, _GAP, _HEAD = 24, 16, 66


def draw_panel_sheet(file: Path, title: str, said: str, rows: Sequence[Sequence[Panel]], *, warning: str = "") -> Path:
    """Draw panels side by side, and rows of them below each other; the same panels give the same bytes.

    Parameters
    ----------
    file : Path
        Where to write, as PNG.
    title, said : str
        At the head; the second one smaller.
    rows : sequence of sequences of Panel
        At least one; the first picture decides their height.
    warning : str
        Before ``said``, in red.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    shape = next((panel.pixels.shape for row in rows for panel in row if panel.pixels is not None), (3, 4))
    box = (_WIDTH, min(_MOST, max(_LEAST, round(_WIDTH * shape[0] / shape[1]))))
    width, height = panel_size(box)
    across = max(len(row) for row in rows)
    inner = max(across * (width + _GAP) - _GAP, 2 * width)
    sheet = Image.new("RGB", (inner + 2 * _MARGIN, 2 * _MARGIN + _HEAD + len(rows) * (height + _GAP) - _GAP), PAPER)
    pen = ImageDraw.Draw(sheet)
    pen.text((_MARGIN, _MARGIN), cut(title, inner, font(20, bold=True)), INK, font(20, bold=True))
    left = _MARGIN
    if warning:
        pen.text((left, _MARGIN + 32), warning, RED, font(14, bold=True))
        left += round(font(14, bold=True).getlength(warning)) + 10
    pen.text((left, _MARGIN + 32), cut(said, inner + _MARGIN - left, font(14)), GREY, font(14))
    for number, row in enumerate(rows):
        for column, panel in enumerate(row):
            corner = (_MARGIN + column * (width + _GAP), _MARGIN + _HEAD + number * (height + _GAP))
            draw_panel(sheet, panel, corner, box)
    with replacing(file) as temporary:
        sheet.save(temporary, format="PNG")
    return file
