"""The list of pairs that AmsterTime has: ``image_pairs.csv``, a line for each place."""

from pathlib import Path

from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.spec import SimulationSpec


def write(spec: SimulationSpec, folder: Path, files: Files) -> None:
    """List the files of the same place in all traverses; the header has the traverses' names."""
    names = [traverse.name for traverse in spec.traverses]
    count = min(spec.frames_of(traverse) for traverse in spec.traverses)
    lines = [",".join(("id", *names))]
    for index in range(count):
        paths = [files.name(name, index).as_posix() for name in names]
        lines.append(",".join((f"{files.number(index):04d}", *paths)))
    (folder / "image_pairs.csv").write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
