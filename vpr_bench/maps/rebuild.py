"""The method of a map, made again as it was when the map was fitted."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vpr_bench.errors import DataError, UsageError, one_line
from vpr_bench.maps.commands import fit_again
from vpr_bench.maps.record import MapRecord
from vpr_bench.method.build import BuiltMethod, build_method, find_method
from vpr_bench.method.interfaces import Persistent
from vpr_bench.method.rebuild import rebuilding
from vpr_bench.method.trust import UntrustedError
from vpr_bench.method.version import version_of


def rebuild(
    record: MapRecord, folder: Path, method: str | None = None, parameters: Mapping[str, str] | None = None
) -> BuiltMethod:
    """Make the method of a map, without what it has learnt.

    Parameters
    ----------
    record : MapRecord
        Of the map.
    folder : Path
        Where the map is, for messages.
    method : str, optional
        Where the method is, if it is not installed: ``my_file.py:MyMethod``. A map alone cannot have a file run.
    parameters : mapping, optional
        Instead of those that the map was fitted with: where a method inside or a file of weights is, or what only
        matters to answers.

    Raises
    ------
    UsageError
        If the method is unknown or another one, or must be named by the user.
    DataError
        If it is another version than the map's, or its weights or parameters are others.
    """
    given = dict(parameters or {})
    name, fitted = method or record.method.id, record.method
    with rebuilding(besides=[name for name in (method, *given.values()) if name is not None]):
        entry, _ = find_method(name)
        factory = entry.load()
        if not callable(factory):
            raise UsageError(f"{name!r} is not a method: {entry.target} must be a class with fit and match.")
        _check_version(record, folder, name, version_of(entry, factory))
        built = _built(record, folder, name, given)
    if built.id != fitted.id:
        raise UsageError(f"{folder} is a map of {one_line(fitted.id)!r:.200}, not of {built.id!r}.")
    if not isinstance(built.method, Persistent):
        raise DataError(f"{folder} is a map of {built.id!r}, which cannot read maps. {_again(record, folder)}")
    if built.weights != fitted.weights:
        raise DataError(
            f"{folder} was fitted with the weights {one_line(fitted.weights)}; here they are {built.weights}. "
            f"{_again(record, folder)}"
        )
    now = json.loads(json.dumps(built.parameters))
    for parameter, value in fitted.parameters.items():
        if now.get(parameter) != value and not any(one.partition(".")[0] == parameter for one in given):
            raise DataError(
                f"{folder} was fitted with {one_line(parameter)}={one_line(json.dumps(value)):.300}, which is now "
                f"{one_line(json.dumps(now.get(parameter))):.300}. {_again(record, folder)}"
            )
    return built


def _built(record: MapRecord, folder: Path, name: str, given: Mapping[str, str]) -> BuiltMethod:
    values: dict[str, Any] = dict(record.method.parameters)
    for parameter, value in given.items():
        former = values.get(parameter)
        # Of a method inside, only where it is: its parameters are still those of the map.
        values[parameter] = {**former, "method": value} if isinstance(former, Mapping) and "method" in former else value
    try:
        return build_method(name, values)
    except UntrustedError:
        raise
    except UsageError as error:
        if given:
            raise
        raise DataError(f"{folder} cannot be used: {error} {_again(record, folder)}") from None


def _check_version(record: MapRecord, folder: Path, name: str, version: str) -> None:
    made = record.method.version
    if version != made:
        raise DataError(
            f"{folder} was made by version {one_line(made):.100} of {one_line(name):.200} (vpr-bench "
            f"{one_line(record.package):.40}); here it is version {version}. {_again(record, folder)}"
        )


def _again(record: MapRecord, folder: Path) -> str:
    try:
        defaults: Mapping[str, Any] | None = build_method(record.method.id).parameters
    except Exception:  # it only makes the command longer
        defaults = {}
    return fit_again(record.model_dump(mode="json"), folder, defaults)
