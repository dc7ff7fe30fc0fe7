"""What a baseline file looked like in former versions, and how it is brought up to date when it is read."""

from collections.abc import Callable
from typing import Any

SCHEMA_VERSION = 1

_STEPS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}


def migrated(content: dict[str, Any]) -> dict[str, Any]:
    """Bring the content of a baseline of a former schema up to date.

    Parameters
    ----------
    content : dict
        With a ``schema_version`` from 1 to the present one.
    """
    for version in range(content["schema_version"], SCHEMA_VERSION):
        content = {**_STEPS[version](content), "schema_version": version + 1}
    return content
