"""A plot of exact size in pixels, as one part of a sheet of pictures."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from vpr_bench.report.ink import GREY, INK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_STYLE: Any = {
    "font.size": 9,
    "font.family": "DejaVu Sans",
    "axes.linewidth": 0.8,
    "axes.edgecolor": GREY,
    "axes.labelcolor": INK,
    "xtick.color": GREY,
    "ytick.color": GREY,
}


@dataclass(frozen=True)
class Plot:
    """A figure and what it is drawn on."""

    figure: "Figure"
    canvas: Any

    def picture(self) -> Image.Image:
        """Return it as a picture, once the ``with`` block has ended."""
        return Image.fromarray(np.asarray(self.canvas.buffer_rgba())).convert("RGB")


@contextmanager
def plot(width: int, height: int) -> Iterator[Plot]:
    """Yield an empty figure of so many pixels, and draw it when the ``with`` block ends."""
    # The object interface: no global state, no window system.
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context(_STYLE):
        figure = Figure(figsize=(width / 100, height / 100), dpi=100, layout="constrained")
        canvas: Any = FigureCanvasAgg(figure)
        yield Plot(figure, canvas)
        canvas.draw()
