"""Products of all query and reference descriptors, fast and rough: enough to see what cannot match."""

import time
from functools import cache

import numpy as np
import torch
from numpy.typing import NDArray

_GROUPS = 16
_IMAGES = 8  # multiplied at once: their products, 4 MiB for 500 key points, stay near the cores
_ROUNDING = 2.0**-7  # relative error of a product of bfloat16 vectors rounded to bfloat16, 1.5 · 2⁻⁸, and to spare


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
        self._stacked = torch.zeros((n_images, self._rows, 128), dtype=fastest_type())

    def put(self, image: int, descriptors: NDArray[np.float32]) -> None:
        """Set the descriptors of one image: (n, 128) float32, not negative, of unit length or zero."""
        self._stacked[image, : len(descriptors)] = torch.from_numpy(descriptors)

    def may_pass(self, query: NDArray[np.float32], ratio: float) -> NDArray[np.bool_]:
        """Say which descriptors of a query may pass the ratio test in which reference image.

        Parameters
        ----------
        query : (m, 128) float32
            Not negative, of unit length.
        ratio : float
            Of the distances to the nearest and the second nearest.

        Returns
        -------
        (n_images, m) bool
            Few are true that do not pass; none is false that does.
        """
        found = np.empty((len(self._stacked), len(query)), dtype=np.bool_)
        with torch.inference_mode():
            turned = torch.from_numpy(query).to(self._stacked.dtype).T
            room = torch.empty((_IMAGES * self._rows, len(query)), dtype=self._stacked.dtype)
            for start in range(0, len(found), _IMAGES):
                block = self._stacked[start : start + _IMAGES].reshape(-1, 128)
                product = torch.mm(block, turned, out=room[: len(block)]).view(-1, self._rows, len(query))
                first, second = _two_best(product)
                passes = first * (1 + _ROUNDING) > 1 - ratio**2 * (1 - second * (1 - _ROUNDING))
                found[start : start + _IMAGES] = passes.numpy()
        return found


def _two_best(product: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Return the highest of (images, rows, m) products along the rows, and one not above the second highest.

    The rows are dealt into 16 groups, and the two best groups' maxima are taken: one pass over all products instead
    of a sort. The second is too low where the two best rows fell into the same group.
    """
    images, rows, columns = product.shape
    # Bit patterns of numbers that are not negative sort as the numbers do, and integers are compared faster.
    sortable = product.view(torch.int16) if product.dtype == torch.bfloat16 else product
    groups = sortable.view(images, rows // _GROUPS, _GROUPS, columns).amax(dim=1).view(product.dtype).float()
    first, where = groups.max(dim=1)
    return first, groups.scatter_(1, where.unsqueeze(1), 0).amax(dim=1)


@cache
def fastest_type() -> torch.dtype:
    """Return the type in which this processor multiplies fastest; which one it is changes no answer."""
    seconds = {}
    for kind in (torch.float32, torch.bfloat16):
        left, right = torch.ones((1024, 128), dtype=kind), torch.ones((128, 512), dtype=kind)
        trials = []
        for _ in range(4):
            start = time.perf_counter()
            torch.mm(left, right)
            trials.append(time.perf_counter() - start)
        seconds[kind] = min(trials)
    return min(seconds, key=lambda kind: seconds[kind])
