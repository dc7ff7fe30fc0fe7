"""Random numbers that are the same on every machine and with every version of NumPy.

NumPy promises a stable stream only for the raw output of its bit generators, and its ``uniform`` may be
fused into a multiply-add by some compilers. Everything here is made from raw 64-bit words.
"""

from collections.abc import Sequence
from typing import TypeVar
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

T = TypeVar("T")


class Dice:
    """A stream of random numbers named by a key, so that one consumer never shifts another's numbers.

    Parameters
    ----------
    *key
        Non-negative integers and words, for example ``Dice(spec.seed, "building", 3)``.

    Examples
    --------
    >>> Dice(1, "tree").below(100) == Dice(1, "tree").below(100)
    True
    """

    def __init__(self, *key: int | str) -> None:
        entropy = [crc32(part.encode()) if isinstance(part, str) else part for part in key]
        self._bits = np.random.PCG64(np.random.SeedSequence(entropy))

    def branch(self) -> "Dice":
        """Return a new stream: however much is drawn from it, this one goes on as if it had been one number."""
        return Dice(self.below(1 << 30), "branch")

    def below(self, stop: int) -> int:
        """Return an integer in ``range(stop)``."""
        return (int(self._bits.random_raw()) >> 11) % stop

    def between(self, low: float, high: float) -> float:
        """Return a number in ``[low, high)``."""
        return low + (high - low) * ((int(self._bits.random_raw()) >> 11) * 2.0**-53)

    def chance(self, probability: float) -> bool:
        """Return True with the given probability."""
        return self.between(0.0, 1.0) < probability

    def pick(self, items: Sequence[T]) -> T:
        """Return one of the items."""
        return items[self.below(len(items))]

    def shuffled(self, items: Sequence[T]) -> list[T]:
        """Return the items in a random order."""
        rest = list(items)
        return [rest.pop(self.below(len(rest))) for _ in range(len(rest))]

    def bytes(self, *shape: int) -> NDArray[np.uint8]:
        """Return an array of uniform uint8."""
        count = 1
        for length in shape:
            count *= length
        words = np.asarray(self._bits.random_raw((count + 7) // 8), dtype="<u8")
        return words.view(np.uint8)[:count].reshape(shape)
