"""Key points of an image and what they look like."""

from dataclasses import dataclass

import cv2
import numpy as np
import torch
from numpy.typing import NDArray

from vpr_baselines.photometry import grey, resized

LENGTH = 128
"""Numbers in one SIFT descriptor."""

_LAYERS, _CONTRAST, _EDGE, _SIGMA = 3, 0.04, 10, 1.6  # OpenCV's defaults, which must be said to get uint8


@dataclass(frozen=True)
class KeyPoints:
    """The key points of one image, strongest first.

    Attributes
    ----------
    positions : (n, 2) float32
        x and y in pixels of the resized image.
    descriptors : (n, 128) uint8
        SIFT, as OpenCV rounds it.
    """

    positions: NDArray[np.float32]
    descriptors: NDArray[np.uint8]


def detect(image: NDArray[np.uint8], size: int, limit: int) -> KeyPoints:
    """Find key points (Lowe, IJCV 2004).

    Parameters
    ----------
    image : (H, W, 3) uint8
        RGB.
    size : int
        Pixels of the longer side that the image is resized to.
    limit : int
        At most so many, those of highest contrast.
    """
    height, width = image.shape[:2]
    scale = size / max(height, width)
    small = resized(grey(image), max(round(width * scale), 1), max(round(height * scale), 1))
    sift = cv2.SIFT.create(limit, _LAYERS, _CONTRAST, _EDGE, _SIGMA, descriptorType=cv2.CV_8U)
    points, descriptors = sift.detectAndCompute(small, None)
    if descriptors is None:
        return KeyPoints(np.empty((0, 2), np.float32), np.empty((0, LENGTH), np.uint8))
    strongest = np.argsort([-point.response for point in points], kind="stable")[:limit]  # it keeps more where they tie
    positions = np.array([point.pt for point in points], dtype=np.float32)
    return KeyPoints(positions[strongest], np.asarray(descriptors, dtype=np.uint8)[strongest])


def root_sift(descriptors: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Turn (n, 128) uint8 SIFT into float32 RootSIFT of unit length (Arandjelović and Zisserman, CVPR 2012).

    Its products are Bhattacharyya coefficients of the histograms, in [0, 1]; rows of zeros stay zero. The values are
    rounded to bfloat16, which many processors multiply several times faster. SIFT's own rounding to whole numbers is
    the coarser one for all but its largest values.
    """
    values = descriptors.astype(np.float32)
    roots = np.sqrt(values / np.maximum(values.sum(axis=1, keepdims=True), 1))
    return np.asarray(torch.from_numpy(roots).bfloat16().float().numpy())
