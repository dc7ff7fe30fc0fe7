"""What lies in somebody's folder: folders of images, how many each has, and in which order they were taken."""

from dataclasses import dataclass
from itertools import chain, count
from pathlib import Path
from typing import Any

from vpr_bench.dataset.describe_own import slug
from vpr_bench.files.images import natural_key
from vpr_datasets.layouts.looking import folders_in, images_in


@dataclass(frozen=True)
class ImageFolder:
    """One folder of images in a folder that nobody has described.

    Attributes
    ----------
    name : str
        What the traverse may be called; no two of one folder are called the same.
    folder : Path
        The folder.
    files : list of Path
        Its images, in natural order.
    """

    name: str
    folder: Path
    files: list[Path]

    def card(self) -> dict[str, Any]:
        """Return the content of its traverse's card."""
        return {"name": self.name, "folder": self.folder.name, "images": len(self.files)}

    def __str__(self) -> str:
        """Name it, with the number of images."""
        return f"{self.name} ({len(self.files)})"


def folders_of_images(folder: Path) -> list[ImageFolder]:
    """Return the folders of images in a folder, sorted by name; what cannot be read is as good as not there.

    Folders that a card cannot name are passed by: those with a colon, a backslash or no text in their names.
    """
    found: dict[str, ImageFolder] = {}
    for inner in folders_in(folder):
        files = images_in(inner)
        if not files or not inner.name.isprintable() or set(":\\") & set(inner.name):
            continue
        plain = slug(inner.name) or "traverse"
        name = next(one for one in chain([plain], (f"{plain}_{number}" for number in count(2))) if one not in found)
        found[name] = ImageFolder(name, inner, sorted(files, key=lambda file: natural_key(file.name)))
    return list(found.values())
