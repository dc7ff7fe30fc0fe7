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

from vpr_datasets.simulation.frame import render_frame
from vpr_datasets.simulation.render import render
from vpr_datasets.simulation.spec import SimulationSpec, TraverseSpec

SIMULATION_VERSION = 1

__all__ = ["SIMULATION_VERSION", "SimulationSpec", "TraverseSpec", "render", "render_frame"]
