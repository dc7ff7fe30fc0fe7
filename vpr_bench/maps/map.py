"""A map on disk: opened in no time, read when it is first asked."""

import contextlib
import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, UsageError, blaming
from vpr_bench.garbage import no_collections
from vpr_bench.maps.answer import Answer, Location, Photo, ask_each
from vpr_bench.maps.record import STATE, MapRecord, read_map_record
from vpr_bench.maps.state import check_state
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Method, Persistent, is_sequential
from vpr_bench.types.image import decode_image
from vpr_bench.types.match import Match

_PICTURE = np.full((48, 64, 3), 127, dtype=np.uint8)
"""For warming up: any picture would do."""


@dataclass(frozen=True, eq=False)
class Map:
    """A map of places that can be asked where a photo was taken.

    Attributes
    ----------
    folder : Path
        Holds ``map.json`` and ``state``.
    record : MapRecord
        What it is: method, references, digests.
    called : str, optional
        Where the method is, if it is not installed.
    parameters : mapping
        Instead of the map's own.
    """

    folder: Path
    record: MapRecord
    called: str | None = None
    parameters: Mapping[str, str] = field(default_factory=dict)

    def __len__(self) -> int:
        """Return the number of references."""
        return self.record.n_references

    @cached_property
    def built(self) -> BuiltMethod:
        """The method as it was before it was fitted.

        Raises
        ------
        UsageError, DataError
            As :func:`~vpr_bench.maps.rebuild.rebuild` does.
        """
        from vpr_bench.maps.rebuild import rebuild

        return rebuild(self.record, self.folder, self.called, self.parameters)

    @cached_property
    def method(self) -> Method:
        """The fitted method, read from disk and warm.

        Raises
        ------
        UsageError
            If it is unknown, or not installed and not named by the user.
        DataError
            If it is another version than the map's, or cannot read the map.
        """
        with no_collections():
            return self._loaded()

    def _loaded(self) -> Method:
        built = self.built
        assert isinstance(built.method, Persistent)  # noqa: S101 - rebuild() has checked it
        with blaming(f"{self.folder} cannot be read", DataError):
            method: Method = built.method.load(self.folder / STATE)
        # Networks are loaded by the first picture. If it fails, so will a photo, which has a name.
        with contextlib.suppress(Exception):
            method.match(_PICTURE, 1)
        if is_sequential(method):
            method.reset()  # type: ignore[attr-defined]
        return method

    def locate(self, image: NDArray[np.uint8] | Path | str, k: int = 5) -> Answer:
        """Say where an image was taken.

        Parameters
        ----------
        image : (H, W, 3) uint8, Path or str
            RGB, or a file.
        k : int
            How many places at most.

        Raises
        ------
        UsageError
            If ``k`` is not between 1 and the number of references, or the method looks at frames to come.
        DataError
            If the file is not an image, or the map cannot be read.
        VprBenchError
            If the method fails.

        Examples
        --------
        >>> from vpr_bench import load_map
        >>> load_map("gardens.map").locate("photo.jpg").locations[0]  # doctest: +SKIP
        Location(rank=1, reference=57, file='day_left/Image057.jpg', place=57.0, score=0.83)
        """
        photo = Photo("the image", image) if isinstance(image, np.ndarray) else read_photo(Path(image))
        return next(self.locate_each([photo], k))

    def locate_each(self, photos: Iterable[Photo], k: int = 5) -> Iterator[Answer]:
        """Say where photos were taken, one after the other; a sequence method takes them for one sequence.

        Raises
        ------
        UsageError, DataError, VprBenchError
            As :meth:`locate`.
        """
        self.check_k(k)
        for photo, match, seconds in ask_each(self.method, photos, k, len(self), self.record.method.id):
            yield Answer(photo, self._locations(match), seconds)

    def check_k(self, k: int) -> None:
        """Refuse to be asked for more places than there are, or none.

        Raises
        ------
        UsageError
            If ``k`` is not between 1 and the number of references.
        """
        if not 1 <= k <= len(self):
            raise UsageError(f"k must lie between 1 and {len(self)}, the number of references. Got {k} instead.")

    def _locations(self, match: Match) -> tuple[Location, ...]:
        found = []
        for rank, (reference, score) in enumerate(zip(match.indices.tolist(), match.scores.tolist(), strict=True), 1):
            part, index = self.record.locate(reference)
            place = None if part.places is None else part.places[index]
            found.append(Location(rank, reference, part.names[index], place, score))
        return tuple(found)


def load_map(
    path: Path | str,
    *,
    method: str | None = None,
    parameters: Mapping[str, str] | None = None,
    verify: bool = False,
) -> Map:
    """Open a map; what its method has learnt is read when it is first asked.

    Parameters
    ----------
    path : Path or str
        Of its folder.
    method : str, optional
        Where its method is, if it is not installed: ``my_file.py:MyMethod``.
    parameters : mapping, optional
        Instead of those that it was fitted with, for what only matters to answers.
    verify : bool
        Read every byte of it, and not only what is small or was touched.

    Raises
    ------
    DamagedError
        If it is not as it was written.
    DataError
        If there is none, or it was written by a version that this one does not understand.
    """
    folder = Path(path)
    record = read_map_record(folder)
    check_state(folder / STATE, record.files, verify=verify)
    return Map(folder, record, method, dict(parameters or {}))


def read_photo(file: Path) -> Photo:
    """Decode an image file, and note how long it took.

    Raises
    ------
    DataError
        If it is missing or is not an image.
    """
    start = time.perf_counter()
    image = decode_image(file)
    return Photo(str(file), image, time.perf_counter() - start)
