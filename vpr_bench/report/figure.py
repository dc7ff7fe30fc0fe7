"""Pictures: where they may be written, and diagrams that come out the same each time."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from vpr_bench.errors import UsageError
from vpr_bench.files.atomic import replacing
from vpr_bench.files.disk import DiskError, disk_errors

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("png", "svg")


def check_picture(file: Path, formats: Sequence[str] = FORMATS) -> None:
    """Refuse a picture that could not be written, before anything is computed for it.

    Parameters
    ----------
    file : Path
        Where it is to be written.
    formats : sequence of str
        What it can be, by the ending of its name.

    Raises
    ------
    UsageError
        If its name ends otherwise.
    DataError
        If its folder is not there, or a folder is in its place.
    """
    if file.suffix.lower()[1:] not in formats:
        endings = " or ".join(f".{kind}" for kind in formats)
        raise UsageError(f"A picture's name must end in {endings}. Got {str(file)!r} instead.")
    with disk_errors(file):
        if not file.parent.is_dir():
            raise DiskError(f"Cannot write {file}: there is no folder {file.parent}. Make it first.")
        if file.is_dir():
            raise DiskError(f"Cannot write {file}: it is a folder. Choose another name.")


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
