"""Named sets of parameters: ``hog:thesis`` is the method ``hog`` with the parameters of its preset ``thesis``."""

from collections.abc import Mapping
from typing import Any

from vpr_bench.errors import UsageError, closest
from vpr_bench.registry import Entry


def written_presets(entry: Entry) -> dict[str, dict[str, Any]]:
    """Return a method's presets as its source writes them, without importing it; those it computes are left out."""
    found = entry.definition()
    return _checked(entry, found.constant("presets") if found else None)


def preset_parameters(entry: Entry, factory: Any, preset: str | None) -> dict[str, Any]:
    """Return the parameters that a preset sets; none for no preset.

    Raises
    ------
    UsageError
        If the method has no such preset; the closest one is suggested.
    """
    return {} if preset is None else chosen(entry, _checked(entry, getattr(factory, "presets", None)), preset)


def chosen(entry: Entry, presets: Mapping[str, dict[str, Any]], preset: str) -> dict[str, Any]:
    """Return one of a method's presets.

    Raises
    ------
    UsageError
        If there is none of that name; the closest one is suggested.
    """
    if preset not in presets:
        raise UsageError(f"The method {entry.name!r} has no preset {preset!r}. {closest(preset, presets)}")
    return dict(presets[preset])


def _checked(entry: Entry, presets: Any) -> dict[str, dict[str, Any]]:
    if presets is None:
        return {}
    if not isinstance(presets, Mapping) or not all(isinstance(one, Mapping) for one in presets.values()):
        raise UsageError(f"The presets of {entry.name!r} must be a dict of dicts: name, then parameters.")
    return {str(name): dict(parameters) for name, parameters in presets.items()}
