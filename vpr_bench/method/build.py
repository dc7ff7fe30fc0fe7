"""From a name and parameters to a method, and back to what stands in the result."""

import contextlib
import dataclasses
import inspect
import json
import typing
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from vpr_bench.errors import DataError, UsageError, blaming, closest, one_line
from vpr_bench.method.interfaces import Method, Weighted
from vpr_bench.method.nested import build_inner, nested_parameters, take_apart
from vpr_bench.method.presets import preset_parameters
from vpr_bench.method.trust import check_trusted, place_of
from vpr_bench.method.version import version_of
from vpr_bench.registry import NOT_INSTALLED, Entry, Registry

METHODS: Registry[type[Method]] = Registry("vpr_bench.methods", "method")


def find_method(name: str) -> tuple[Entry, str | None]:
    """Take ``method``, ``method:preset`` or ``module:Class`` apart; a registered method wins over a module.

    Raises
    ------
    UsageError
        If there is no such method, or it may not be run here.
    """
    name = place_of(name)
    base, colon, preset = name.partition(":")
    entry, chosen = (METHODS.entry(base), preset) if colon and base in METHODS else (METHODS.entry(name), None)
    check_trusted(name, entry)
    return entry, chosen


@dataclass(frozen=True)
class BuiltMethod:
    """A method with everything that identifies it in a result.

    Attributes
    ----------
    id : str
        Registered name, with its preset if one is used, or ``module:Class``, or ``file.py:Class`` without folders.
    version : str
        The class's ``version``, else a digest of its package's source, so that edited code is not taken for the
        same.
    parameters : dict
        Every constructor parameter with its value; of a method inside, its own id, version, parameters and weights.
    weights : str or None
        Digest of the pre-trained weights, also those of a method inside.
    label : str
        The id with the parameters that differ from their defaults, or from the preset, for tables; the seed is
        left out, and a method inside is always named.
    method : Method
        Not fitted yet.
    origin : str
        The distribution that brings it, with its version; ``not installed`` for what comes from none.
    """

    id: str
    version: str
    parameters: dict[str, Any]
    weights: str | None
    label: str
    method: Method
    origin: str = NOT_INSTALLED

    def as_parameter(self) -> dict[str, Any]:
        """Return what stands in the result of a method that this one is a parameter of; it is built again from it."""
        return {"method": self.id, "version": self.version, "parameters": self.parameters, "weights": self.weights}


def build_method(name: str, parameters: Mapping[str, Any] | None = None, seed: int | None = None) -> BuiltMethod:
    """Make a method from its name and parameters.

    Parameters
    ----------
    name : str
        A registered method, also with one of its presets as in ``hog:thesis``, ``module:Class`` or
        ``path/to/file.py:Class``.
    parameters : mapping, optional
        Constructor arguments; strings are converted to the annotated types. They override the preset's. Where an
        argument is itself a method, its name, and ``argument.name`` for its own parameters.
    seed : int, optional
        Passed on as the parameter ``seed`` if the method has one and ``parameters`` does not set it.

    Raises
    ------
    UsageError
        If the method or its preset is unknown or is not a method, or a parameter is unknown or of the wrong type.
    """
    entry, preset = find_method(name)
    factory = entry.load()
    if not callable(factory) or not all(hasattr(factory, part) for part in ("fit", "match")):
        raise UsageError(f"{name!r} is not a method: {entry.target} must be a class with fit and match.")
    called = entry.name if preset is None else name
    known = _defaults(factory)
    usual = preset_parameters(entry, factory, preset)
    nested = nested_parameters(factory)
    given, inside = take_apart(usual | dict(parameters or {}), nested)
    if seed is not None and "seed" in known:
        given.setdefault("seed", seed)
    for parameter in given:
        if parameter not in known:
            raise UsageError(f"The method {name!r} has no parameter {parameter!r}. {closest(parameter, known)}")
    typed = {key: _convert(name, factory, key, value) for key, value in given.items() if key not in nested}
    inner = {key: build_inner(key, given.get(key, known[key]), inside.get(key, {}), seed) for key in nested}
    with blaming(f"The method {name!r} cannot be made"):
        try:
            method = factory(**typed, **{key: one.method for key, one in inner.items()})
        except (TypeError, ValueError) as error:
            raise UsageError(f"The method {name!r} refuses its parameters: {error}") from error
    values = known | typed | {key: one.as_parameter() for key, one in inner.items()}
    _check_json(name, values)
    with blaming(f"The weights of {name!r} cannot be found", DataError):
        digests = [str(method.weights_digest())] if isinstance(method, Weighted) else []
    weights = ", ".join(digests + [one.weights for one in inner.values() if one.weights]) or None
    usual, _ = take_apart(usual, nested)
    expected = known | {key: _convert(name, factory, key, usual[key]) for key in usual if key not in nested}
    told = {key: inner[key].label if key in inner else value for key, value in values.items()}
    told = {key: value for key, value in told.items() if key in inner or (key != "seed" and value != expected[key])}
    changed = [one_line(f"{key}={value}") for key, value in told.items()]
    label = f"{called}({', '.join(changed)})" if changed else called
    return BuiltMethod(called, version_of(entry, factory), values, weights, label, method, entry.origin)


def method_parameters(name: str) -> list[str]:
    """Return the names of a method's own parameters.

    Raises
    ------
    UsageError
        If there is no such method.
    """
    factory = find_method(name)[0].load()
    return list(_defaults(factory)) if callable(factory) else []


def _defaults(factory: Any) -> dict[str, Any]:
    """Return each named parameter of a constructor with its default, ``Parameter.empty`` if it is required."""
    fields = dataclasses.fields(factory) if dataclasses.is_dataclass(factory) else ()
    made = {one.name: one.default_factory() for one in fields if one.default_factory is not dataclasses.MISSING}
    return {
        name: made.get(name, parameter.default)
        for name, parameter in inspect.signature(factory).parameters.items()
        if parameter.kind not in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD)
    }


def _convert(method: str, factory: Any, parameter: str, value: Any) -> Any:
    from pydantic import PydanticUserError, TypeAdapter, ValidationError

    try:
        hints = typing.get_type_hints(factory.__init__, include_extras=True)
        adapter = TypeAdapter(hints.get(parameter, _type_of(_defaults(factory)[parameter])))
    except (AttributeError, NameError, TypeError, PydanticUserError):  # a hint that only a type checker understands
        return value
    try:
        return adapter.validate_python(value)
    except ValidationError as error:
        if isinstance(value, str):  # null, lists and mappings, as the command line must write them
            with contextlib.suppress(ValidationError):
                return adapter.validate_json(value)
        reason = error.errors()[0]["msg"]
        raise UsageError(f"The parameter {parameter!r} of {method!r}: {reason}. Got {value!r} instead.") from None


def _type_of(default: Any) -> Any:
    """Guess the type of a parameter without a hint from its default."""
    return type(default) if isinstance(default, bool | int | float | str) else Any


def _check_json(method: str, values: Mapping[str, Any]) -> None:
    for name, value in values.items():
        try:
            json.dumps(value, allow_nan=False)
        except (TypeError, ValueError) as error:
            raise UsageError(f"The parameter {name!r} of {method!r} cannot stand in a result: {error}.") from None
