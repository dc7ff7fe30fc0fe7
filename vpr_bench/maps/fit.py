"""Fitting a map, once: the same again is found, not made."""

from pathlib import Path

from vpr_bench.errors import DataError, UsageError
from vpr_bench.maps.making import Making, check_place, claimed
from vpr_bench.maps.map import Map, load_map
from vpr_bench.maps.record import RECORD, Fitted, MapRecord
from vpr_bench.maps.references import References
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Persistent


def fit_map(
    built: BuiltMethod, references: References, folder: Path, *, threads: int | None = None, overwrite: bool = False
) -> Map:
    """Fit a method and keep the map, or return the same map if it is there.

    Whatever happens, what is in its place is whole. A fit that was interrupted goes on with what the method kept.

    Parameters
    ----------
    built : BuiltMethod
        Not fitted yet; it must be able to save.
    references : References
        What to fit it on.
    folder : Path
        Where to put the map.
    threads : int, optional
        For numerical libraries; by default one per core.
    overwrite : bool
        Make it again, in the place of whatever map is there.

    Raises
    ------
    UsageError
        If the method cannot save, another map is there, or something that is no map.
    DataError
        If an image cannot be decoded, the map that is there is damaged, or nothing can be written.
    VprBenchError
        If the method fails.
    """
    check_persistent(built)
    check_place(folder)
    with claimed(folder) as partial:
        found = None if overwrite else find_map(built, references, folder)
        if found is not None:
            return found
        making = Making(as_fitted(built), (references.part,), threads=threads)
        making.work(built.method, lambda: built.method.fit(references.traverse), partial, folder)
    return load_map(folder)


def find_map(built: BuiltMethod, references: References, folder: Path) -> Map | None:
    """Return the map in a place if it is what fitting would make, None if the place is free.

    Raises
    ------
    UsageError
        If another map is there, or something that is no map.
    DataError
        If it is damaged.
    """
    check_place(folder)
    if not (folder / RECORD).exists():
        return None
    try:
        there = load_map(folder)
    except DataError as error:
        raise DataError(f"{error} --overwrite replaces it.") from None
    fitted = as_fitted(built)
    if there.record.method != fitted or [part.digest for part in there.record.parts] != [references.part.digest]:
        raise UsageError(
            f"{folder} is another map: {_called(there.record)}. --overwrite puts "
            f"{built.label} on {references.part} in its place."
        )
    return there


def check_persistent(built: BuiltMethod) -> None:
    """Refuse a method whose map cannot be kept.

    Raises
    ------
    UsageError
        If it has no ``save`` and ``load``.
    """
    if not isinstance(built.method, Persistent):
        raise UsageError(
            f"The method {built.id!r} cannot be kept on disk: it has no save(folder) and load(folder). "
            "It can be measured with `vpr-bench run`."
        )


def as_fitted(built: BuiltMethod) -> Fitted:
    """Return what stands in a map about its method; as it is read back, so that the two can be compared."""
    given = Fitted(
        id=built.id, version=built.version, parameters=built.parameters, weights=built.weights, label=built.label
    )
    return Fitted.model_validate_json(given.model_dump_json())


def _called(record: MapRecord) -> str:
    return f"{record.method.label} on {' + '.join(map(str, record.parts))}"
