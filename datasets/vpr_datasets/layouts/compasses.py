"""Where the cameras looked, where that is known."""

import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import DatasetWarning


def joint_compass(degrees: NDArray[np.float64], folder: Path) -> NDArray[np.float64] | None:
    """Return the compass of a recording.

    Parameters
    ----------
    degrees : (n,) float64
        Clockwise from north, of any turn; NaN where it is not known.
    folder : Path
        What to call the recording.

    Returns
    -------
    (n,) float64 or None
        In [0, 360); None unless it is known of all images. If it is known of some, that is warned of.
    """
    known = np.isfinite(degrees)
    if known.all():
        turned = degrees % 360
        return np.where(turned < 360, turned, 0.0)  # a tiny negative angle is rounded up to a whole turn
    if known.any():
        warnings.warn(
            f"{np.sum(~known)} of the {len(known)} images in {folder} have no compass: it is left out for all of them.",
            DatasetWarning,
            stacklevel=3,
        )
    return None
