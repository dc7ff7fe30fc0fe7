"""Folders as VPR-Bench has them: ``ref``, ``query``, and a file that lists the references of each query."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.load import DatasetWarning
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.files.images import listed
from vpr_bench.files.restricted_pickle import read_object_array
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.faults import check_count
from vpr_datasets.layouts.inside import inside
from vpr_datasets.layouts.listing import folders_of_images

FILES = ("ground_truth_new.npy", "ground_truth.npy")
"""Names of the list; the first is the one that VPR-Bench reads."""

_MOST = 10_000_000
"""Pairs: what a small file can hold by sharing lists is not limited otherwise."""


def load(folder: Path, card: TraverseCard) -> Recording:
    """Find the images of one traverse; there are no labels.

    Parameters
    ----------
    folder : Path
        Holds ``0000000.jpg`` and so on, or images of other names.
    card : TraverseCard
        Says how many images there must be, if it is known.

    Returns
    -------
    Recording
        In the order of the numbers; of names that are not all numbers, in natural order.

    Raises
    ------
    DataError
        If the folder is missing, or an image is: the list counts images, and would speak of others.
    """
    files = listed(folder)
    if all(file.stem.isascii() and file.stem.isdigit() for file in files):
        for number, file in enumerate(files):
            if int(file.stem) != number:
                missing = str(number).zfill(len(file.stem)) + file.suffix
                raise DataError(
                    f"{folder}: {missing} is missing, {file.name} is in its place. The ground truth counts images "
                    "from 0: restore it, or fetch the dataset again."
                )
    check_count(folder, card, len(files))
    return Recording(Traverse(card.name, files))


def given(folder: Path, references: Recording, queries: Recording, file: str = FILES[0]) -> GroundTruth:
    """Read which references VPR-Bench accepts for each query.

    Parameters
    ----------
    folder : Path
        The dataset's folder.
    references, queries : Recording
        The two traverses.
    file : str
        Name of the list: an array of rows ``[query, [references]]``. Row ``i`` is about query ``i``, whatever number
        stands in it. An empty list, or ``[-1]``, means that the query's place is not on the map.

    Returns
    -------
    GroundTruth
        Without references that do not exist; a :class:`DatasetWarning` names them.

    Raises
    ------
    DataError
        If the file is missing, damaged or unsafe, has not one row per query, or names no reference that exists.
    """
    path = inside(folder, file)
    table = read_object_array(path)
    if table.ndim == 0 or len(table) != len(queries):
        raise DataError(
            f"{path} lists {len(table) if table.ndim else 'no'} queries, and {queries.traverse.name} has "
            f"{len(queries)} images: there must be one row for each. Restore what is missing."
        )
    rows: list[list[int]] = []
    total = 0
    for number, row in enumerate(table):
        try:
            _, listed_references = row
            rows.append(_numbers(listed_references))
        except (TypeError, ValueError, OverflowError) as error:
            raise DataError(
                f"{path}, row {number} is not [query, [references]]: {error}. Get the file again."
            ) from None
        total += len(rows[-1])
        if total > _MOST:
            raise DataError(f"{path} is refused: it lists more than {_MOST:,} pairs. Check that it is the right file.")
    _warn_of_numbers(path, table)
    return _existing(path, rows, len(references))


def _numbers(value: Any) -> list[int]:
    """Return what one query's references are, written as a list, a tuple, an array or a single number."""
    if isinstance(value, np.ndarray):
        if value.ndim > 1:
            raise ValueError(f"an array of {value.shape} in place of a list")
        value = value.tolist()
    return [_whole(one) for one in (value if isinstance(value, list | tuple) else [value])]


def _whole(value: Any) -> int:
    # Never written out: a value may be a list of lists of lists that no memory can hold as text.
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | float | np.integer | np.floating):
        raise ValueError(f"{type(value).__name__} in place of a number")  # noqa: TRY004 - damaged, not misused
    if value != int(value):
        raise ValueError(f"{value} in place of a whole number")
    return int(value)


def _warn_of_numbers(path: Path, table: NDArray[Any]) -> None:
    for number, (named, _) in enumerate(table):
        try:
            stated = _numbers(named)
        except (TypeError, ValueError, OverflowError):
            stated = []
        if stated != [number]:
            what = f"says that it is about query {stated[0]}" if stated else "does not say which query it is about"
            warnings.warn(
                f"{path}: row {number} {what}. As in VPR-Bench the position of a row is used, not the number in it.",
                DatasetWarning,
                stacklevel=3,
            )
            return


def _existing(path: Path, rows: list[list[int]], n_references: int) -> GroundTruth:
    queries, columns, beyond = [], [], []
    for query, row in enumerate(rows):
        kept = [one for one in row if 0 <= one < n_references]
        columns += kept
        queries += [query] * len(kept)
        if len(kept) < len(row) and row != [-1]:
            beyond += [one for one in row if not 0 <= one < n_references]
    if beyond and not columns:
        raise DataError(f"{path} names none of the {n_references} references. Check that it belongs to these images.")
    if beyond:
        distinct = sorted(set(beyond))
        more = f" and {len(distinct) - 3} more" if len(distinct) > 3 else ""
        some = f"{'references' if len(distinct) > 1 else 'reference'} {', '.join(map(str, distinct[:3]))}{more}"
        warnings.warn(
            f"{path}: {some} {'do' if len(distinct) > 1 else 'does'} not exist, as there are {n_references}; "
            f"{len(beyond)} of {len(beyond) + len(columns)} pairs are left out.",
            DatasetWarning,
            stacklevel=3,
        )
    return GroundTruth.from_pairs(queries, columns, len(rows), n_references)


def recognise(folder: Path) -> Recognised | None:
    """Look for the two folders and the list, without reading it."""
    file = next((name for name in FILES if (folder / name).is_file()), None)
    found = {one.folder.name: one for one in folders_of_images(folder) if one.folder.name in ("ref", "query")}
    if file is None or len(found) < 2:
        return None
    references, queries = found["ref"], found["query"]
    pair = {"references": references.name, "queries": queries.name}
    return Recognised(
        found=f"VPR-Bench folders: {len(references.files)} references, {len(queries.files)} queries, and {file}, "
        "which lists the references of each query",
        unit="given",
        traverses=[references.card(), queries.card()],
        protocols=[{**pair, "unit": "given"}],
        given=[{**pair, "options": {} if file == FILES[0] else {"file": file}}],
    )


LAYOUT = Layout(
    about="VPR-Bench: folders ref and query, and an .npy file that lists the references of each query",
    load=load,
    given=given,
    recognise=recognise,
    rank=90,
)
