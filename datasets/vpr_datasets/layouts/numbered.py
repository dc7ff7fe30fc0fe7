"""Folders of numbered frames, where the same number is the same place."""

import re
from importlib.resources import files
from pathlib import Path

import numpy as np

from vpr_bench.dataset.brightness import brightness
from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.files.images import image_files
from vpr_bench.types.traverse import Traverse


def load(
    folder: Path,
    card: TraverseCard,
    pattern: str,
    first: int = 0,
    step: int = 1,
    frames: str | None = None,
    darkest: float | None = None,
) -> Recording:
    """Find the frames of one traverse.

    Parameters
    ----------
    folder : Path
        The traverse's folder.
    card : TraverseCard
        Says how many images there must be.
    pattern : str
        File name with ``{index}``, for example ``Image{index:03d}.jpg``.
    first, step : int
        Number of the first frame, and what is added from one to the next.
    frames : str, optional
        Name of a list in ``vpr_datasets/frames``: only these frames are used, whatever else there is, and a label
        is a position in the list. By default it is the frame's number.
    darkest : float, optional
        Frames whose mean pixel is below it, of 255, are left out, as are tunnels. It is the one option that has the
        images decoded, once. ``card.images`` then counts the images before.

    Returns
    -------
    Recording
        In the order of the numbers.

    Raises
    ------
    DataError
        If the folder is missing or empty, an image is missing or is one too many, or the pattern or list is none.
    """
    if not re.fullmatch(r"[^{}/\\]*\{index(:0[1-9]d)?\}[^{}/\\]*", pattern) or step < 1:
        raise DataError(
            f"The pattern must be a file name with {{index}} or {{index:05d}}. Got {pattern!r:.60} instead."
        )
    found = {file.name for file in image_files(folder)}
    if frames is not None:
        numbers = listed_frames(frames)
        labels = np.arange(len(numbers), dtype=np.float64)
    else:
        count = len(found) if card.images is None else card.images
        numbers = list(range(first, first + count * step, step))
        labels = np.array(numbers, dtype=np.float64)
    expected = [pattern.format(index=number) for number in numbers]
    if not expected:
        raise DataError(f"{folder} holds no images. Restore them, or fetch the dataset again.")
    missing = sorted(set(expected) - found)
    surplus = [] if frames else sorted(found.difference(expected))
    if missing or surplus:
        faults = [*_counted(missing, "missing"), *_counted(surplus, "not of them")]
        raise DataError(
            f"{folder} must hold the {len(expected)} images {expected[0]} to {expected[-1]}: "
            f"found {len(found)}, {'; '.join(faults)}. Restore them, or fetch the dataset again."
        )
    recording = Recording(Traverse(card.name, [folder / name for name in expected]), labels)
    return recording if darkest is None else _lit(recording, darkest)


def listed_frames(name: str) -> list[int]:
    """Read a list of frame numbers, written as one range ``first-last`` per line.

    Raises
    ------
    DataError
        If there is no such list.
    """
    if not re.fullmatch("[a-z0-9_]+[.]txt", name) or not files("vpr_datasets.frames").joinpath(name).is_file():
        raise DataError(f"There is no list of frames {name!r:.60} in vpr_datasets/frames.")
    lines = files("vpr_datasets.frames").joinpath(name).read_text("utf-8").split()
    ranges = [line.split("-") for line in lines]
    return [number for first, last in ranges for number in range(int(first), int(last) + 1)]


def _lit(recording: Recording, darkest: float) -> Recording:
    lit = np.flatnonzero(brightness(recording.traverse) >= darkest)
    if len(lit) == 0:
        raise DataError(f"All {len(recording)} images of {recording.traverse.name} are darker than {darkest:g} of 255.")
    return recording.subset(lit)


def _counted(names: list[str], what: str) -> list[str]:
    """Say what the first of some files is, and how many more of its kind there are; nothing where there is none."""
    if len(names) > 1:
        return [f"{names[0]} and {len(names) - 1} more are {what}"]
    return [f"{name} is {what}" for name in names]


LAYOUT = Layout(about="folders of numbered frames; the same number is the same place", load=load)
