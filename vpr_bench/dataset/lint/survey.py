"""One pass over the images of a traverse: each is decoded once, and only a few numbers of it are kept."""

from collections import Counter
from collections.abc import Generator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from vpr_bench.cores import available_cores
from vpr_bench.errors import DataError, blaming
from vpr_bench.progress import track
from vpr_bench.types.traverse import Traverse

DARK = 5.0
"""Mean pixel, of 255, below which nothing can be seen: a tunnel, a covered lens."""

FROZEN = 0.5
"""Two images are the same picture if their thumbnails differ by less, of 255, on average.

What is left of sensor noise and compression in a thumbnail is less; consecutive frames of the Gardens Point walks
differ by 8 at the least and 28 in the median.
"""

LASTING = 5
"""How many frames in a row show the same picture before it is worth saying."""

_THUMBNAIL = (32, 32)


@dataclass
class Survey:
    """What the images of a traverse look like.

    Attributes
    ----------
    sizes : Counter
        How many images there are of each (width, height).
    faults : dict of int to str
        Why an image cannot be decoded, by its index.
    dark, frozen : list of range
        Stretches of frames that are black, and that show one and the same picture.
    """

    sizes: Counter[tuple[int, int]] = field(default_factory=Counter)
    faults: dict[int, str] = field(default_factory=dict)
    dark: list[range] = field(default_factory=list)
    frozen: list[range] = field(default_factory=list)


@dataclass(frozen=True, eq=False)
class _Look:
    """What is kept of one image."""

    size: tuple[int, int]
    mean: float
    thumbnail: NDArray[np.int16]  # signed, so that two can be subtracted


def survey(traverse: Traverse) -> Survey:
    """Decode every image of a traverse, once; memory does not grow with the images' size."""
    result, still = Survey(), _Still()
    with closing(_looks(traverse)) as looks:
        for index, look in enumerate(track(looks, f"Decoding {traverse.name}", len(traverse))):
            picture = None
            if isinstance(look, str):
                result.faults[index] = look
            else:
                result.sizes[look.size] += 1
                if look.mean < DARK:
                    _extend(result.dark, index)
                else:  # black frames are all alike: that they are black says it all
                    picture = look.thumbnail
            still.see(index, picture)
    still.see(len(traverse), None)
    result.frozen = still.stretches
    return result


def _looks(traverse: Traverse) -> Generator[_Look | str, None, None]:
    """Look at the images in their order, on all cores: decoding runs outside the interpreter's lock."""
    with ThreadPoolExecutor(available_cores()) as pool:
        try:
            yield from pool.map(lambda index: _look(traverse, index), range(len(traverse)))
        finally:
            pool.shutdown(cancel_futures=True)  # Ctrl-C does not wait for the rest


def _look(traverse: Traverse, index: int) -> _Look | str:
    try:
        with blaming(traverse.name_of(index), DataError):
            image = traverse[index]
            small = cv2.resize(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), _THUMBNAIL, interpolation=cv2.INTER_AREA)
            return _Look((image.shape[1], image.shape[0]), float(image.mean()), small.astype(np.int16))
    except DataError as error:
        return str(error)


def _extend(stretches: list[range], index: int) -> None:
    """Add a frame to the last stretch if it follows it, else begin another one."""
    if stretches and stretches[-1].stop == index:
        stretches[-1] = range(stretches[-1].start, index + 1)
    else:
        stretches.append(range(index, index + 1))


class _Still:
    """Finds stretches of one and the same picture.

    Frames are compared with the first one of their stretch, not with the one before: a slow train moves too little
    from frame to frame to be told from a standing one, but it does get on.
    """

    def __init__(self) -> None:
        self.stretches: list[range] = []
        self._start = 0
        self._first: NDArray[np.int16] | None = None

    def see(self, index: int, picture: NDArray[np.int16] | None) -> None:
        """Look at the next frame; None if it shows nothing."""
        if picture is not None and self._first is not None and np.abs(picture - self._first).mean() < FROZEN:
            return
        if self._first is not None and index - self._start >= LASTING:
            if self.stretches and self.stretches[-1].stop == self._start:  # the same halt, under a passing cloud
                self._start = self.stretches.pop().start
            self.stretches.append(range(self._start, index))
        self._start, self._first = index, picture
