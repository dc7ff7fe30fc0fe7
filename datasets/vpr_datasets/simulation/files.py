"""Which file each image of a simulation goes to, and what is written beside them."""

from pathlib import Path, PurePosixPath
from string import Formatter
from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

SUFFIXES = (".jpg", ".jpeg", ".png")


class Files(BaseModel):
    """The names of the files.

    Attributes
    ----------
    pattern
        Name of each image below the folder, with the fields ``traverse`` and ``number``; its suffix decides
        whether it is a JPEG or a PNG.
    patterns
        Patterns of traverses that are named otherwise; these need not hold ``traverse``.
    first
        Number of the first image of every traverse.
    skipped
        Numbers that no image has.
    beside
        What else the dataset has: names from :data:`vpr_datasets.simulation.beside.KINDS`.

    Examples
    --------
    >>> str(Files(first=1, pattern="{traverse}/images-{number:05d}.png").name("winter", 0))
    'winter/images-00001.png'
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    pattern: str = "{traverse}/Image{number:03d}.jpg"
    patterns: dict[str, str] = {}
    first: Annotated[int, Field(ge=0)] = 0
    skipped: tuple[int, ...] = ()
    beside: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _usable(self) -> Self:
        """Refuse patterns that would not give every image a file of its own inside the folder."""
        _check(self.pattern, {"traverse", "number"})
        for traverse, pattern in self.patterns.items():
            _check(pattern, {"traverse", "number"} if "{traverse" in pattern else {"number"})
            if any(other != traverse and text == pattern for other, text in self.patterns.items()):
                raise ValueError(f"two traverses have the pattern {pattern!r}")
        return self

    @property
    def lossless(self) -> bool:
        """Whether the files keep every pixel as it is."""
        return all(pattern.lower().endswith(".png") for pattern in (self.pattern, *self.patterns.values()))

    def number(self, index: int) -> int:
        """Return the number of image ``index`` (from 0).

        Examples
        --------
        >>> [Files(first=1, skipped=(2, 3, 5)).number(index) for index in range(4)]
        [1, 4, 6, 7]
        """
        number = self.first + index
        for gap in sorted(set(self.skipped)):
            if self.first <= gap <= number:
                number += 1
        return number

    def name(self, traverse: str, index: int) -> PurePosixPath:
        """Return the name, below the folder, of image ``index`` (from 0) of a traverse."""
        pattern = self.patterns.get(traverse, self.pattern)
        return PurePosixPath(pattern.format(traverse=traverse, number=self.number(index)))

    def path(self, folder: Path, traverse: str, index: int) -> Path:
        """Return the file of image ``index`` (from 0) of a traverse."""
        return folder / self.name(traverse, index)


def _check(pattern: str, wanted: set[str]) -> None:
    """Refuse a pattern without the wanted fields, and one that leads out of the folder."""
    try:
        fields = {name for _, name, _, _ in Formatter().parse(pattern) if name is not None}
        path = PurePosixPath(pattern.format(traverse="a", number=0))
    except (ValueError, KeyError, IndexError) as error:
        raise ValueError(f"not a pattern for file names: {pattern!r} ({error})") from error
    if fields != wanted or path.suffix.lower() not in SUFFIXES:
        raise ValueError(f"the pattern must hold {{traverse}} and {{number}} and end in .jpg or .png, got {pattern!r}")
    if path.is_absolute() or ".." in path.parts or "\\" in pattern:
        raise ValueError(f"the pattern must stay inside the folder, got {pattern!r}")
