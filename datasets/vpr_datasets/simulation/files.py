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
    first
        Number of the first image of every traverse.
    beside
        What else the dataset has: names from :data:`vpr_datasets.simulation.beside.WRITERS`.

    Examples
    --------
    >>> str(Files(first=1, pattern="{traverse}/images-{number:05d}.png").name("winter", 0))
    'winter/images-00001.png'
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    pattern: str = "{traverse}/Image{number:03d}.jpg"
    first: Annotated[int, Field(ge=0)] = 0
    beside: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _usable(self) -> Self:
        """Refuse a pattern that would not give every image a file of its own inside the folder."""
        try:
            fields = {name for _, name, _, _ in Formatter().parse(self.pattern) if name is not None}
            path = self.name("a", 0)
        except (ValueError, KeyError, IndexError) as error:
            raise ValueError(f"not a pattern for file names: {self.pattern!r} ({error})") from error
        if fields != {"traverse", "number"} or path.suffix.lower() not in SUFFIXES:
            raise ValueError(
                f"the pattern must hold {{traverse}} and {{number}} and end in .jpg or .png, got {self.pattern!r}"
            )
        if path.is_absolute() or ".." in path.parts or "\\" in self.pattern:
            raise ValueError(f"the pattern must stay inside the folder, got {self.pattern!r}")
        return self

    @property
    def lossless(self) -> bool:
        """Whether the files keep every pixel as it is."""
        return self.pattern.lower().endswith(".png")

    def name(self, traverse: str, index: int) -> PurePosixPath:
        """Return the name, below the folder, of image ``index`` (from 0) of a traverse."""
        return PurePosixPath(self.pattern.format(traverse=traverse, number=self.first + index))

    def path(self, folder: Path, traverse: str, index: int) -> Path:
        """Return the file of image ``index`` (from 0) of a traverse."""
        return folder / self.name(traverse, index)
