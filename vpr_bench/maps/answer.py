"""What a map answers: places for one photo, best first."""

import time
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import VprBenchError, blaming
from vpr_bench.method.faults import fault_in
from vpr_bench.method.interfaces import Foresighted, Method, frames_ahead
from vpr_bench.timing import collect_stages
from vpr_bench.types.match import Match

Place = float | tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Photo:
    """An image that is looked up.

    Attributes
    ----------
    name : str
        What to call it.
    image : (H, W, 3) uint8
        RGB.
    seconds : float
        That decoding it took.
    """

    name: str
    image: NDArray[np.uint8]
    seconds: float = 0.0


@dataclass(frozen=True)
class Location:
    """One place where a photo may have been taken.

    Attributes
    ----------
    rank : int
        From 1.
    reference : int
        Its index in the map.
    file : str
        Of the reference image, relative to the folder of its dataset or images.
    place : float or tuple of float, optional
        Its place label, where there is one.
    score : float
        Higher is better; what it means is the method's business.
    """

    rank: int
    reference: int
    file: str
    place: Place | None
    score: float


@dataclass(frozen=True, eq=False)
class Answer:
    """What a map answers for one photo.

    Attributes
    ----------
    photo : Photo
        The photo.
    locations : tuple of Location
        Best first.
    seconds : dict
        Per stage: ``decode``, the method's own, and ``total`` without decode.
    """

    photo: Photo
    locations: tuple[Location, ...]
    seconds: dict[str, float]


def ask_each(
    method: Method, photos: Iterable[Photo], k: int, n_references: int, called: str
) -> Iterator[tuple[Photo, Match, dict[str, float]]]:
    """Ask a fitted method about photos, one after the other, in the order in which they come.

    A sequence method takes them for one sequence; one that looks ahead is shown frames before it answers.

    Yields
    ------
    photo, match, seconds
        As for :class:`Answer`.

    Raises
    ------
    VprBenchError
        If the method fails, or answers nonsense; names the photo.
    """
    ahead, waiting, unseen = frames_ahead(method), deque[Photo](), list[Photo]()
    for photo in photos:
        waiting.append(photo)
        unseen.append(photo)
        if len(waiting) > ahead:
            yield _asked(method, waiting.popleft(), unseen, k, n_references, called)
            unseen.clear()
    while waiting:
        yield _asked(method, waiting.popleft(), unseen, k, n_references, called)
        unseen.clear()


def _asked(
    method: Method, photo: Photo, unseen: list[Photo], k: int, n_references: int, called: str
) -> tuple[Photo, Match, dict[str, float]]:
    """Ask about one photo, after a method that looks ahead was shown what it has not seen."""
    start = time.perf_counter()
    with blaming(f"The method {called!r} failed while answering {photo.name}"), collect_stages() as seconds:
        if frames_ahead(method) and isinstance(method, Foresighted):
            for one in unseen:
                method.foresee(one.image)
        match = method.match(photo.image, k)
    total = time.perf_counter() - start
    fault = fault_in(match, n_references, k)
    if fault:
        raise VprBenchError(f"The method {called!r} answered {photo.name} with {fault}.")
    return photo, match, {"decode": photo.seconds, **seconds, "total": total}
