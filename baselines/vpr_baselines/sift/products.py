"""Products of all query and reference descriptors, fast and rough: enough to see what cannot match."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from vpr_baselines.sift.keypoints import LENGTH

_GROUPS = 16
_IMAGES = 16  # multiplied at once: their products, 8 MiB for 500 key points, stay near the cores
_ERROR = {torch.float32: 2.0**-14, torch.bfloat16: 2.0**-9 + 2.0**-14}
"""Largest error of a product that is at most 1: that of a sum of 128 in float32, then that of rounding the result."""


class RoughProducts:
    """Reference descriptors, laid out for one large matrix product per query.

    A pair passes the ratio test if 1 - s₁ < ratio² · (1 - s₂), where s₁ and s₂ are the two highest products of a
    query descriptor with the descriptors of one reference. Here s₂ is replaced by something that is never above it,
    and rounding is allowed for, so that whatever passes the test passes here.

    Parameters
    ----------
    n_images : int
        Number of reference images.
    n_features : int
        At most so many descriptors in each.
    """

    def __init__(self, n_images: int, n_features: int) -> None:
        self._rows = -(-n_features // _GROUPS) * _GROUPS
        # Rows without a descriptor are zero, and no product is below that.
        self._stacked = torch.zeros((n_images, self._rows, LENGTH), dtype=fastest_type())

    def put(self, image: int, descriptors: NDArray[np.float32]) -> None:
        """Set the descriptors of one image: (n, 128) float32 as :func:`root_sift` makes them."""
        self._stacked[image, : len(descriptors)] = torch.from_numpy(descriptors)

    def get(self, image: int, count: int) -> NDArray[np.float32]:
        """Return the first ``count`` descriptors of one image as they were put."""
        return np.asarray(self._stacked[image, :count].float().numpy())

    def packed(self) -> NDArray[np.int16]:
        """Return all descriptors as the bits of bfloat16, which lose nothing: (n_images, rows, 128) int16."""
        return np.asarray(self._stacked.bfloat16().view(torch.int16).numpy())

    def unpack(self, packed: NDArray[np.int16]) -> None:
        """Take what :meth:`packed` gave."""
        self._stacked = torch.from_numpy(packed).view(torch.bfloat16).to(self._stacked.dtype)

    def may_pass(self, query: NDArray[np.float32], ratio: float) -> NDArray[np.bool_]:
        """Say which descriptors of a query may pass the ratio test in which reference image.

        Parameters
        ----------
        query : (m, 128) float32
            As :func:`root_sift` makes them.
        ratio : float
            Of the distances to the nearest and the second nearest.

        Returns
        -------
        (n_images, m) bool
            Few are true that do not pass; none is false that does.
        """
        if not len(query):
            return np.empty((len(self._stacked), 0), dtype=np.bool_)
        kind, error = self._stacked.dtype, _ERROR[self._stacked.dtype]
        found = np.empty((len(self._stacked), len(query)), dtype=np.bool_)
        columns = torch.from_numpy(query).to(kind).T
        room = torch.empty((_IMAGES * self._rows, len(query)), dtype=kind)
        for start in range(0, len(found), _IMAGES):
            block = self._stacked[start : start + _IMAGES].view(-1, LENGTH)
            product = torch.mm(block, columns, out=room[: len(block)]).view(-1, self._rows, len(query))
            first, second = _two_best(product)
            found[start : start + _IMAGES] = first + error > 1 - ratio**2 * (1 - second + error)
        return found


def _two_best(product: torch.Tensor) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the highest of (images, rows, m) products along the rows, and one not above the second highest.

    The rows are dealt into 16 groups, whose maxima play a knock-out: one pass over all products instead of a sort.
    The second is too low where the two best rows fell into the same group.
    """
    images, rows, columns = product.shape
    rounded = product.dtype == torch.bfloat16
    # Bit patterns of numbers that are not negative sort as the numbers do, and integers are compared faster. NumPy
    # compares as fast as torch, and starts no threads for so little work, which would wait for each other.
    values = (product.view(torch.int16) if rounded else product).numpy()
    first = values.reshape(images, rows // _GROUPS, _GROUPS, columns).max(axis=1)
    second = np.zeros_like(first)
    while first.shape[1] > 1:
        half = first.shape[1] // 2
        left, right = first[:, :half], first[:, half:]
        second = np.maximum(np.minimum(left, right), np.maximum(second[:, :half], second[:, half:]))
        first = np.maximum(left, right)
    return _numbers(first[:, 0]), _numbers(second[:, 0])


def _numbers(values: NDArray[Any]) -> NDArray[np.float32]:
    """Turn the bits of bfloat16 into float32; float32 stays."""
    if values.dtype == np.float32:
        return values
    return (values.astype(np.uint32) << np.uint32(16)).view(np.float32)


@cache
def fastest_type() -> torch.dtype:
    """Return the type in which this processor multiplies fastest; which one it is changes no answer."""
    return min((torch.float32, torch.bfloat16), key=_seconds)


def _seconds(kind: torch.dtype) -> float:
    """Measure one product in seconds of one core's work, which other processes do not add to."""
    left, right = torch.ones((1024, 128), dtype=kind), torch.ones((128, 512), dtype=kind)
    trials = []
    with one_thread():
        for _ in range(5):
            start = time.thread_time()
            torch.mm(left, right)
            trials.append(time.thread_time() - start)
    return min(trials)


@contextmanager
def one_thread() -> Iterator[None]:
    """Keep torch to one thread inside the ``with`` block.

    Blocks of products are done in less than a millisecond, and two threads wait for each other after every one:
    seven times longer in all, where the cores have other work too.
    """
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(threads)
