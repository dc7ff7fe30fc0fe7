"""Which matched key points move together from one image to the other."""

from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

Geometry = Literal["homography", "fundamental"]

_NEEDED = {"homography": 4, "fundamental": 8}
_PIXELS = {"homography": 5.0, "fundamental": 2.0}  # from the predicted point or line, at the size of detection
_TRIALS, _CONFIDENCE = 2000, 0.999


def consistent(query: NDArray[np.float32], reference: NDArray[np.float32], geometry: Geometry) -> NDArray[np.bool_]:
    """Find the pairs that one homography or fundamental matrix explains, by OpenCV's USAC with MAGSAC++.

    OpenCV draws its samples from the same seed every time, so equal pairs give equal answers.

    Parameters
    ----------
    query, reference : (n, 2) float32
        Positions of matched key points in pixels.
    geometry : {"homography", "fundamental"}
        A plane or a pure rotation, or any rigid scene.

    Returns
    -------
    (n,) bool
        None is true where there are too few pairs to tell.
    """
    none = np.zeros(len(query), dtype=np.bool_)
    if len(query) < _NEEDED[geometry]:
        return none
    try:
        if geometry == "homography":
            _, mask = cv2.findHomography(
                query, reference, cv2.USAC_MAGSAC, _PIXELS[geometry], maxIters=_TRIALS, confidence=_CONFIDENCE
            )
        else:
            _, mask = cv2.findFundamentalMat(
                query, reference, cv2.USAC_MAGSAC, _PIXELS[geometry], confidence=_CONFIDENCE, maxIters=_TRIALS
            )
    except cv2.error:  # an assertion inside OpenCV fails where no sample makes a model
        return none
    return none if mask is None else np.asarray(mask).ravel() > 0
