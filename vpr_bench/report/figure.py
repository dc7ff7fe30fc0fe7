"""Diagrams that come out the same each time: how they are begun and how they are written."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from vpr_bench.errors import UsageError
from vpr_bench.files.atomic import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("png", "svg")


def check_format(file: Path) -> None:
    """Refuse a file name of a kind that is not drawn.

    Raises
    ------
    UsageError
        If it ends in neither .png nor .svg.
    """
    if file.suffix.lower()[1:] not in FORMATS:
        raise UsageError(f"A picture's name must end in .png or .svg. Got {str(file)!r} instead.")


@contextmanager
def diagram(width: float, height: float, *files: Path) -> Iterator["Figure"]:
    """Yield an empty figure of so many inches, and write it if the ``with`` block ends well.

    Parameters
    ----------
    width, height : float
        In inches, at 150 dots each.
    *files : Path
        Each ends in .png or .svg.

    Raises
    ------
    DataError
        If they cannot be written.
    """
    # The object interface: no global state, no window system.
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context({"svg.hashsalt": "vpr-bench", "font.size": 10}):
        figure = Figure(figsize=(width, height), layout="constrained")
        FigureCanvasAgg(figure)
        yield figure
        for file in files:
            kind = file.suffix.lower()[1:]
            with replacing(file) as temporary:
                figure.savefig(temporary, format=kind, dpi=150, metadata={"Date": None} if kind == "svg" else None)
