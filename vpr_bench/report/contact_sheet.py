"""A contact sheet: queries with the references that are their place, for a person to see whether that is right."""

from pathlib import Path

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError
from vpr_bench.files.atomic import replacing
from vpr_bench.report.ink import stacked
from vpr_bench.report.route_map import draw_plots
from vpr_bench.report.sheet_band import GAP, draw_band
from vpr_bench.report.sheet_columns import choose_columns
from vpr_bench.report.sheet_header import draw_header

WIDTH, MARGIN = 1600, 36
"""Of the sheet, in pixels."""

PER_BAND, WIDEST = 8, 296
"""How many queries stand side by side, and how wide one is at most where there are fewer."""


def draw_contact_sheet(case: Case, file: Path, count: int = 8, seed: int = 0) -> Path:
    """Draw some queries with their true matches, and where they are.

    Only the images that are shown are decoded. The same case gives the same bytes.

    Parameters
    ----------
    case : Case
        What to look at.
    file : Path
        Where to write, as PNG.
    count : int
        How many queries. One of them has no match, if there is such a one.
    seed : int
        Another one shows other queries.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If there is nothing to see, an image cannot be decoded, or the file cannot be written.
    """
    if not len(case.queries) or not len(case.references):
        raise DataError(f"{case.protocol} has no images to look at.")
    columns = choose_columns(case, count, seed)
    inner = WIDTH - 2 * MARGIN
    width = min((inner + GAP) // min(PER_BAND, len(columns)) - GAP, WIDEST)
    parts = [draw_header(case, columns, inner)]
    for first in range(0, len(columns), PER_BAND):
        parts += [draw_band(case, columns[first : first + PER_BAND], first + 1, width)]
    parts.append(draw_plots(case, columns, inner))
    with replacing(file) as temporary:
        stacked(parts, WIDTH, MARGIN, 2 * GAP).save(temporary, format="PNG")
    return file
