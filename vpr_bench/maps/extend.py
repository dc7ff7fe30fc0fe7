"""Adding references to a map."""

from pathlib import Path

from vpr_bench.errors import UsageError, one_line
from vpr_bench.maps.making import Making, claimed
from vpr_bench.maps.map import Map, load_map
from vpr_bench.maps.record import MapRecord
from vpr_bench.maps.references import References
from vpr_bench.method.interfaces import Extendable


def extend_map(
    folder: Path,
    references: References,
    output: Path | None = None,
    *,
    method: str | None = None,
    threads: int | None = None,
    overwrite: bool = False,
) -> Map:
    """Put references behind those of a map, and write it anew.

    Parameters
    ----------
    folder : Path
        The map.
    references : References
        What to add.
    output : Path, optional
        Where to put the larger map; by default in the place of the smaller one.
    method : str, optional
        Where its method is, if it is not installed.
    threads : int, optional
        For numerical libraries; by default one per core.
    overwrite : bool
        Put it in the place of another map at ``output``.

    Raises
    ------
    UsageError
        If the method cannot add references, these are part of the map already, or another map is at ``output``.
    DataError
        If an image cannot be decoded, the map is damaged, or nothing can be written.
    VprBenchError
        If the method fails.
    """
    target = output or folder
    if not folder.exists():
        load_map(folder)  # says what is missing, before anything is made beside it
    with claimed(target) as partial:
        there = load_map(folder, method=method)
        if target.exists() and any(target.iterdir()) and not overwrite and not target.samefile(folder):
            raise UsageError(f"{target} is there. --overwrite puts the extended map in its place.")
        if any(part.digest == references.part.digest for part in there.record.parts):
            raise UsageError(f"{references.part} is part of {folder} already.")
        growing = there.method
        if not isinstance(growing, Extendable):
            raise UsageError(_cannot(there.record, "it has no extend(references)"))

        def learn() -> None:
            try:
                growing.extend(references.traverse)
            except NotImplementedError as error:  # in this configuration, or a wrapper around a method that cannot
                raise UsageError(_cannot(there.record, one_line(error))) from None

        making = Making(there.record.method, (*there.record.parts, references.part), there.record.fit_seconds, threads)
        making.work(growing, learn, partial, target)
    return load_map(target, method=method)


def _cannot(record: MapRecord, reason: str) -> str:
    return (
        f"The method {record.method.id!r} cannot add references to this map{': ' if reason else ''}{reason}. "
        "Fit a map of all of them, as with --references summer+winter."
    )
