"""The simulated edition: a walk rendered by the project itself.

It is written by hand, in NumPy and integer drawing of OpenCV, rather than with a 3D library, because the
same specification must give the same pixels on every machine. Rasterisers that run on a graphics card
differ between drivers, and software ones (Mesa's, for one) between the SIMD widths of processors. Here:

- what is random comes from raw words of a bit generator whose stream NumPy promises to keep;
- arithmetic is on integers, or on float32 and float64 element by element with ``+ - * /``, square root, comparison and
  rounding down, which IEEE 754 defines to the last bit. There are no sines, powers or logarithms, no sums
  or products of matrices, whose order differs between machines, and nothing that a compiler may fuse;
- OpenCV only fills integer shapes without anti-aliasing, enlarges 8-bit images by its bit-exact methods,
  sums integers, and encodes the files.

:data:`SIMULATION_VERSION` is raised whenever the pixels of an existing specification change.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vpr_datasets.simulation.frame import render_frame as render_frame
    from vpr_datasets.simulation.rendering import render as render
    from vpr_datasets.simulation.spec import SimulationSpec as SimulationSpec
    from vpr_datasets.simulation.spec import TraverseSpec as TraverseSpec

SIMULATION_VERSION = 1

__all__ = ["SIMULATION_VERSION", "SimulationSpec", "TraverseSpec", "render", "render_frame"]

_MODULES = {"SimulationSpec": "spec", "TraverseSpec": "spec", "render": "rendering", "render_frame": "frame"}


def __getattr__(name: str) -> Any:
    """Import public names when they are used: whether an edition has been rendered is known without OpenCV."""
    if name in _MODULES:
        return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
