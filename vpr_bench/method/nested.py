"""Methods that are parameters of methods: given by name, with ``parameter.name=value`` for their own parameters."""

import contextlib
import json
import typing
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vpr_bench.errors import UsageError
from vpr_bench.method.interfaces import Method

if TYPE_CHECKING:
    from vpr_bench.method.build import BuiltMethod


def nested_parameters(factory: Any) -> list[str]:
    """Return the parameters of a constructor that are methods: those annotated ``Method`` or ``Method | str``."""
    try:
        hints = typing.get_type_hints(factory.__init__)
    except (AttributeError, NameError, TypeError):  # a hint that only a type checker understands
        return []
    return [name for name, hint in hints.items() if hint is Method or Method in typing.get_args(hint)]


def take_apart(
    given: Mapping[str, Any], nested: typing.Sequence[str]
) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
    """Tell a method's own parameters from those of the methods inside it.

    Examples
    --------
    >>> take_apart({"past": 5, "inner": "hog", "inner.size": 64}, ["inner"])
    ({'past': 5, 'inner': 'hog'}, {'inner': {'size': 64}})
    """
    own: dict[str, Any] = {}
    inside: dict[str, dict[str, Any]] = {}
    for name, value in given.items():
        head, dot, rest = name.partition(".")
        if dot and head in nested:
            inside.setdefault(head, {})[rest] = value
        else:
            own[name] = value
    return own, inside


def build_inner(parameter: str, value: Any, parameters: Mapping[str, Any], seed: int | None) -> "BuiltMethod":
    """Build the method that a parameter is.

    Parameters
    ----------
    parameter : str
        What it is called.
    value : str or mapping
        The method's name, or what stands in a result: its id as ``method`` and its ``parameters``.
    parameters : mapping
        Those of the method inside; they win over those in ``value``.
    seed : int, optional
        Passed on.

    Raises
    ------
    UsageError
        If the value does not name a method, or the method cannot be built.
    """
    from vpr_bench.method.build import build_method

    if isinstance(value, str) and value.startswith("{"):
        with contextlib.suppress(ValueError):
            value = json.loads(value)
    if isinstance(value, str):
        return build_method(value, parameters, seed)
    if isinstance(value, Mapping) and isinstance(value.get("method"), str):
        own = value.get("parameters", {})
        if isinstance(own, Mapping):
            return build_method(value["method"], {**own, **parameters}, seed)
    raise UsageError(f"The parameter {parameter!r} must be the name of a method. Got {value!r} instead.")
