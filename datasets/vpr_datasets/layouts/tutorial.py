"""Folders as the VPR tutorial has them: images sorted by name, and matrices in ``GT.npz`` that compare two folders."""

from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.files.images import image_files
from vpr_bench.files.npz import array_names, array_shape, read_numbers
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.bayer import Bayer
from vpr_datasets.layouts.faults import check_count
from vpr_datasets.layouts.fix_of_image import fixes_of
from vpr_datasets.layouts.inside import inside
from vpr_datasets.layouts.listing import ImageFolder, folders_of_images
from vpr_datasets.layouts.roles import pairings

FILE, HARD, SOFT = "GT.npz", "GThard", "GTsoft"


def load(
    folder: Path,
    card: TraverseCard,
    bayer: str | None = None,
    gps: str | None = None,
    zone: str = "",
    flip_latitude: bool = False,
    stride: int | None = None,
    first_frame: int | None = None,
) -> Recording:
    """Find the images of one traverse.

    Parameters
    ----------
    folder : Path
        The traverse's folder.
    card : TraverseCard
        Says how many images there must be, if it is known.
    bayer : {"RGGB", "BGGR", "GRBG", "GBRG"}, optional
        The images are mosaics of this pattern, and are made into colour images when they are decoded.
    gps : str, optional
        Name of a text file in the folder with one position per line (see :mod:`vpr_datasets.layouts.gps_text`). Where
        there is one, the labels are positions in metres, else there are none.
    zone, flip_latitude
        UTM zone of the positions, and whether their latitudes lack the sign.
    stride, first_frame : int, optional
        Which line is which image's, where there are more lines than images (see
        :func:`~vpr_datasets.layouts.fix_of_image.fixes_of`).

    Returns
    -------
    Recording
        In the order of the names, which is the one in which the matrices count.

    Raises
    ------
    DataError
        If the folder is missing, there are more or fewer images than the card says, or the positions are no positions
        or not one per image.
    """
    files = image_files(folder)
    check_count(folder, card, len(files))
    traverse = Traverse(card.name, files, None if bayer is None else Bayer(bayer))
    places = None if gps is None else inside(folder, gps)
    if places is None or not places.exists():
        return Recording(traverse)
    return Recording(traverse, fixes_of(files, places, zone, flip_latitude, stride, first_frame))


def given(folder: Path, references: Recording, queries: Recording, file: str = FILE) -> GroundTruth:
    """Read which references show the place of each query.

    Parameters
    ----------
    folder : Path
        The dataset's folder.
    references, queries : Recording
        The two traverses.
    file : str
        Name of the file with the matrices: rows are references (the tutorial's database), columns are queries.
        ``GThard`` holds what must be found; what is only in ``GTsoft``, if it is there, is neither right nor wrong.

    Returns
    -------
    GroundTruth
        With soft matches if there is a ``GTsoft``.

    Raises
    ------
    DataError
        If the file is missing or damaged, or a matrix is not of 0 and 1, or not one row per reference and one column
        per query.
    """
    path = inside(folder, file)
    hard = _matches(path, HARD, references, queries)
    if SOFT not in array_names(path):
        return hard
    return hard.with_soft(_matches(path, SOFT, references, queries))


def _matches(path: Path, name: str, references: Recording, queries: Recording) -> GroundTruth:
    shape, expected = array_shape(path, name), (len(references), len(queries))
    if shape != expected:
        turned = (
            " It fits the other way round: swap references and queries in the card." if shape == expected[::-1] else ""
        )
        raise DataError(
            f"{name} in {path} is {_times(shape)}; it must have a row for each of the {expected[0]} images of "
            f"{references.traverse.name} and a column for each of the {expected[1]} of {queries.traverse.name}.{turned}"
        )
    rows, columns = np.nonzero(_truth(read_numbers(path, name), f"{name} in {path}"))
    return GroundTruth.from_pairs(columns, rows, len(queries), len(references))


def _truth(matrix: NDArray[Any], called: str) -> NDArray[np.bool_]:
    if matrix.dtype != np.bool_:
        odd = (matrix != 0) & (matrix != 1)
        if odd.any():
            raise DataError(f"{called} holds {matrix[odd][0]}; it must hold 0 and 1 only. Get the file again.")
    return matrix.astype(np.bool_)


def recognise(folder: Path) -> Recognised | None:
    """Look for the matrices, and for two folders of as many images as they have rows and columns."""
    found = {one.name: one for one in folders_of_images(folder)}
    if not (folder / FILE).is_file() or len(found) < 2 or HARD not in array_names(folder / FILE):
        return None
    fitting = _fitting(folder / FILE, found)
    references, queries = fitting[0]
    pair = {"references": references, "queries": queries}
    others = ", ".join(f"{one}-{other}" for one, other in fitting[1:4])
    return Recognised(
        found=f"VPR tutorial folders: references {found[references]}, queries {found[queries]}, matches in {FILE}"
        + (f"; {references} is taken for the references by its name, but {others} would fit too" if others else ""),
        unit="given",
        traverses=[one.card() for one in found.values()],
        protocols=[{**pair, "unit": "given"}],
        given=[pair],
    )


def _fitting(file: Path, found: dict[str, ImageFolder]) -> list[tuple[str, str]]:
    """Return which folders may be the references and the queries, the most natural pair first."""
    shape = array_shape(file, HARD)
    pairs = dict.fromkeys([*pairings(list(found)), *permutations(found, 2)])
    fitting = [pair for pair in pairs if tuple(len(found[name].files) for name in pair) == shape]
    if not fitting:
        raise DataError(
            f"{HARD} in {file} is {_times(shape)}, and no two folders beside it have as many images: "
            f"{', '.join(str(one) for one in found.values()):.200}. Restore what is missing."
        )
    return fitting


def _times(shape: tuple[int, ...]) -> str:
    return " × ".join(str(size) for size in shape) or "a single value"


LAYOUT = Layout(
    about="VPR tutorial: two folders of images, and GT.npz with the matrices GThard and GTsoft",
    load=load,
    given=given,
    recognise=recognise,
    rank=80,
)
