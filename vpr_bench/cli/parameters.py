"""The options ``--param``: which method each is for."""

import sys
from pathlib import Path

from vpr_bench.errors import UsageError, closest


def sort_parameters(names: list[str], assignments: list[str]) -> dict[str, dict[str, str]]:
    """Sort ``--param`` by method, and let methods be found in the current folder.

    Parameters
    ----------
    names : list of str
        The methods that are named.
    assignments : list of str
        ``name=value`` for all of them, ``method.name=value`` for one, ``inner.name=value`` for a method inside.

    Raises
    ------
    UsageError
        If one is not written so, or is for a method that is not named.
    """
    from vpr_bench.method.build import method_parameters

    find_here(*names)
    parameters: dict[str, dict[str, str]] = {name: {} for name in names}
    for assignment in assignments:
        target, value = split_assignment(assignment)
        owners = [name for name in parameters if target.startswith(f"{name}.")]
        if owners:
            parameters[owners[0]][target[len(owners[0]) + 1 :]] = value
            continue
        owner, dot, _ = target.rpartition(".")
        if dot and not any(owner.partition(".")[0] in method_parameters(name) for name in parameters):
            raise UsageError(f"{assignment!r} is for the method {owner!r}, which is not run. {closest(owner, names)}")
        for name in parameters:
            parameters[name][target] = value
    return parameters


def split_assignment(assignment: str) -> tuple[str, str]:
    """Take ``name=value`` apart.

    Raises
    ------
    UsageError
        If it is not written so.
    """
    target, equals, value = assignment.partition("=")
    if not equals or not target:
        raise UsageError(f"A parameter is written name=value. Got {assignment!r} instead.")
    return target, value


def find_here(*names: str) -> None:
    """Let ``module:Class`` be found in the current folder, where a console script does not look."""
    if any(":" in name for name in names):
        sys.path.append(str(Path.cwd()))
