"""A picture of photos beside the places that a map answers."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.maps.answer import Answer, Location
from vpr_bench.maps.map import Map
from vpr_bench.maps.record import Part
from vpr_bench.maps.references import find_again
from vpr_bench.report.ink import BLUE, GREY, INK
from vpr_bench.report.panel import Panel
from vpr_bench.report.panel_sheet import draw_panel_sheet
from vpr_bench.report.places import place_text
from vpr_bench.types.traverse import Traverse

MOST, ACROSS = 40, 7
"""How many photos, and how many answers of each, are drawn at most; a larger picture hardly opens."""


def draw_answers(asked: Map, answers: Sequence[Answer], file: Path, warn: Callable[[str], None]) -> Path:
    """Draw each photo beside the references that were answered, best first, with their scores.

    Parameters
    ----------
    asked : Map
        The map; its references are looked for where they came from.
    answers : sequence of Answer
        At least one.
    file : Path
        Where to write, as PNG.
    warn : callable
        Told in one line what cannot be shown: references that are not here any more leave a space.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    if len(answers) > MOST:
        warn(f"{file} shows the first {MOST} of {len(answers)} photos.")
    pictures = _Pictures(asked, warn)
    rows = []
    for answer in answers[:MOST]:
        total = f"{1000 * answer.seconds['total']:.1f} ms"
        photo = Panel("Photo", BLUE, answer.photo.image, "", (Path(answer.photo.name).name, total))
        shown = [_panel(pictures, location) for location in answer.locations[:ACROSS]]
        rows.append([photo, *(shown or [Panel("No answer", GREY, None, "nothing answered")])])
    record = asked.record
    said = f"{len(asked):,} references of {' + '.join(str(part) for part in record.parts)}"
    simulated = any(part.edition == "simulated" for part in record.parts)
    title = f"{asked.folder.name}: {record.method.label}"
    return draw_panel_sheet(file, title, said, rows, warning="SIMULATED" if simulated else "")


def _panel(pictures: "_Pictures", location: Location) -> Panel:
    place = place_text(location.place)
    lines = (f"reference {location.reference}" + (f" · place {place}" if place else ""), location.file)
    colour = INK if location.rank == 1 else GREY
    title = f"{location.rank} · score {location.score:.4g}"
    return Panel(title, colour, pictures.find(location.reference), "image not here", lines)


class _Pictures:
    """The images of a map's references, found part by part when one is asked for."""

    def __init__(self, asked: Map, warn: Callable[[str], None]) -> None:
        self._asked = asked
        self._warn = warn
        self._found: dict[str, Traverse | None] = {}

    def find(self, reference: int) -> NDArray[np.uint8] | None:
        """Return an image, None if it is not here."""
        part, index = self._asked.record.locate(reference)
        if part.digest not in self._found:
            self._found[part.digest] = self._look_for(part)
        traverse = self._found[part.digest]
        if traverse is None:
            return None
        try:
            return traverse[index]
        except DataError as error:
            self._warn(str(error))
            return None

    def _look_for(self, part: Part) -> Traverse | None:
        try:
            return find_again(part).traverse
        except VprBenchError as error:
            self._warn(f"The images of {part} cannot be shown: {error}")
            return None
