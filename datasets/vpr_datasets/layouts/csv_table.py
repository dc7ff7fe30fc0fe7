"""Folders with a table of their images, ``.csv``: which images there are, and where each was taken."""

from pathlib import Path

import numpy as np

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.layout import Layout, Recognised
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError, closest
from vpr_bench.types.image import SUFFIXES
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.compasses import joint_compass
from vpr_datasets.layouts.faults import check_count, placed, refuse
from vpr_datasets.layouts.metres import PositionError, zone_of
from vpr_datasets.layouts.positioned import Found, positioned
from vpr_datasets.layouts.table import Row, Table, is_table, read_table
from vpr_datasets.layouts.texts import quoted

_ADVICE = "Correct the table, or restore the images."


def load(
    folder: Path, card: TraverseCard, file: str | None = None, traverse: str | None = None, zone: str | None = None
) -> Recording:
    """Find the images of one traverse, and where each was taken.

    Parameters
    ----------
    folder : Path
        Holds the table; paths in it start here.
    card : TraverseCard
        May say how many images there must be.
    file : str, optional
        The table; by default the only one in the folder.
    traverse : str, optional
        As the table calls it; by default all images of the table are one traverse.
    zone : str, optional
        UTM zone in which positions in degrees are written, for example ``33U``.

    Returns
    -------
    Recording
        In the order of the table. Labels are (n, 2) metres.

    Raises
    ------
    DataError
        If the table or a line of it is wrong, or an image is missing or lies elsewhere.
    """
    source = _table_file(folder, file)
    table = read_table(source)
    rows = [row for row in table.rows if traverse in (None, row.traverse)]
    if not rows:
        hint = closest(str(traverse), {row.traverse for row in table.rows})
        raise DataError(f"{source} has no image of the traverse {traverse!r}. {hint}")
    refuse(_absent(folder, source, rows), _ADVICE)
    check_count(folder, card, len(rows))
    labels = np.array([row.position for row in rows], dtype=np.float64)
    if table.degrees:
        if zone is None:
            raise DataError(f"{source} has positions in degrees: the card must say in which UTM zone, zone = '33U'.")
        labels = placed(labels[:, 0], labels[:, 1], zone, [f"{source}, line {row.line}" for row in rows], _ADVICE)
    compass = np.array([np.nan if row.compass is None else row.compass for row in rows])
    return Recording(Traverse(card.name, [folder / row.image for row in rows]), labels, joint_compass(compass, folder))


def recognise(folder: Path) -> Recognised | None:
    """Look for one table of images in the folder."""
    tables = [file for file in _tables(folder) if is_table(file)]
    if len(tables) != 1:
        return None
    table = read_table(tables[0])
    counts = dict.fromkeys(dict.fromkeys(row.traverse for row in table.rows), 0)
    for row in table.rows:
        counts[row.traverse] += 1
    options = {"file": tables[0].name}
    if table.degrees:
        options["zone"] = _zone(tables[0], table)
    traverses = [Found(name, ".", count, options={"traverse": name}) for name, count in counts.items()]
    return positioned(f"positions in {tables[0].name}", traverses, options)


def _tables(folder: Path) -> list[Path]:
    try:
        return sorted(
            file
            for file in folder.iterdir()
            if file.suffix.lower() == ".csv" and not file.name.startswith(".") and file.is_file()
        )
    except OSError:
        return []


def _table_file(folder: Path, name: str | None) -> Path:
    if name is not None:
        if not (folder / name).resolve().is_relative_to(folder.resolve()):
            raise DataError(f"The table {name!r} is not in the folder {folder}.")
        return folder / name
    tables = _tables(folder)
    if len(tables) != 1:
        raise DataError(
            f"{folder} must hold one table, *.csv: found {len(tables)}. Name one in the card, file = '….csv'."
        )
    return tables[0]


def _absent(folder: Path, source: Path, rows: list[Row]) -> list[str]:
    """Say which images are not there, or are not in the folder but behind a link."""
    home = folder.resolve()
    faults = []
    for row in rows:
        file = folder / row.image
        where = f"{source}, line {row.line}: {quoted(row.image)}"
        if file.suffix.lower() not in SUFFIXES:
            faults.append(f"{where} is not the name of an image")
        elif not file.is_file():
            faults.append(f"{where} does not exist")
        elif not file.resolve().is_relative_to(home):
            faults.append(f"{where} is a link out of the folder")
    return faults


def _zone(file: Path, table: Table) -> str:
    first = table.rows[0]
    try:
        return zone_of(*first.position)
    except PositionError as error:
        raise DataError(f"{file}, line {first.line}: {error}. {_ADVICE}") from None


LAYOUT = Layout(
    about="folders with a table (.csv) of their images and where each was taken",
    load=load,
    recognise=recognise,
    rank=40,
)
