"""A picture of the clusters of a sequence: where it is cut, and what each cluster looks like."""

from pathlib import Path

from PIL import Image, ImageDraw

from vpr_bench.files.atomic import replacing
from vpr_bench.report.cluster_plot import draw_cluster_plot
from vpr_bench.report.cluster_table import ClusterReport, cell
from vpr_bench.report.ink import GREY, INK, PALE, PAPER, cut, fitted, font, stacked
from vpr_bench.types.traverse import Traverse

WIDTH, MARGIN, GAP = 1600, 36, 24
"""Of the sheet, in pixels."""

MOST = 72
"""Clusters that are shown by an image; of more, some are left out evenly."""

_ACROSS, _PAD, _LINE, _SPACE = 9, 6, 16, 10


def draw_cluster_sheet(report: ClusterReport, references: Traverse, file: Path) -> Path:
    """Draw the clusters, each with the image that is nearest to its centre.

    Only the images that are shown are decoded.

    Parameters
    ----------
    report : ClusterReport
        What is drawn.
    references : Traverse
        The images.
    file : Path
        Where to write, as PNG.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If an image cannot be decoded, or the file cannot be written.
    """
    inner = WIDTH - 2 * MARGIN
    parts = [
        _header(report, inner),
        draw_cluster_plot(report.found, inner),
        _thumbnails(report, references, inner),
    ]
    with replacing(file) as temporary:
        stacked(parts, WIDTH, MARGIN, GAP).save(temporary, format="PNG")
    return file


def _header(report: ClusterReport, width: int) -> Image.Image:
    header = Image.new("RGB", (width, 62), PAPER)
    pen = ImageDraw.Draw(header)
    title = f"{report.references}  {report.method}"
    pen.text((0, 0), cut(title, width, font(24, bold=True)), INK, font(24, bold=True))
    total = report.summary
    facts = [
        f"{total['n_references']:,} references in {total['n_clusters']:,} clusters",
        f"of {total['min_size']} to {total['max_size']} (median {total['median_size']:g})",
        "stretches of the sequence" if total["contiguous"] else "not all of them stretches of the sequence",
    ]
    measured = {"mean_cohesion": "mean cohesion", "silhouette": "silhouette"}
    facts += [f"{name} {cell(total[key])}" for key, name in measured.items() if total[key] is not None]
    pen.text((0, 40), cut(" · ".join(facts), width, font(15)), INK, font(15))
    return header


def _thumbnails(report: ClusterReport, references: Traverse, width: int) -> Image.Image:
    """Draw the image nearest to each cluster's centre, and what the cluster is."""
    lines = report.lines
    some = [lines[number * len(lines) // min(len(lines), MOST)] for number in range(min(len(lines), MOST))]
    across = min(_ACROSS, max(len(some), 5))
    side = (width + _SPACE) // across - _SPACE
    box = (side - 2 * _PAD, side)
    pictures = [fitted(references[line["central"]], box) for line in some]
    tall = max(picture.height for picture in pictures)
    height = tall + 2 * _LINE + 3 * _PAD
    rows = -(-len(some) // across)
    more = len(lines) - len(some)
    sheet = Image.new("RGB", (width, rows * (height + _SPACE) + (_LINE + _PAD if more else 0)), PAPER)
    pen = ImageDraw.Draw(sheet)
    for place, (line, picture) in enumerate(zip(some, pictures, strict=True)):
        left, top = place % across * (side + _SPACE), place // across * (height + _SPACE)
        pen.rounded_rectangle((left, top, left + side - 1, top + height - 1), 6, PALE)
        sheet.paste(picture, (left + (side - picture.width) // 2, top + _PAD + (tall - picture.height) // 2))
        below = top + _PAD + tall + _PAD
        for text, colour, bold in ((_what(line), INK, True), (_where(line), GREY, False)):
            pen.text((left + side // 2, below), cut(text, box[0], font(12, bold)), colour, font(12, bold), "ma")
            below += _LINE
    if more:
        pen.text((0, rows * (height + _SPACE)), f"… and {more:,} clusters more, left out evenly", GREY, font(13))
    return sheet


def _what(line: dict[str, object]) -> str:
    return f"{line['cluster']} · {line['size']} {'image' if line['size'] == 1 else 'images'}"


def _where(line: dict[str, object]) -> str:
    """Say which references a cluster has, and how alike they are."""
    first, last = line["start"], int(str(line["stop"])) - 1
    span = f"{first}" if first == last else f"{first}–{last}"
    return f"{span}{'' if line['contiguous'] else ', parts'} · {cell(line['cohesion'])}"  # type: ignore[arg-type]
