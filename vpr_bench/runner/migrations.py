"""What ``run.json`` looked like in former versions, and how it is brought up to date when it is read.

Files on disk are left as they are. A step takes the content of one schema version to the next; ``stored runs`` of
every former version are kept with the tests.
"""

from collections.abc import Callable
from typing import Any

SCHEMA_VERSION = 2


def _to_2(content: dict[str, Any]) -> dict[str, Any]:
    """Version 1 noted nothing of how a run came about; memory and BLAS of the machine were not noted either."""
    return {**content, "provenance": {}}


_STEPS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {1: _to_2}


def migrated(content: dict[str, Any]) -> dict[str, Any]:
    """Bring the content of a ``run.json`` of a former schema up to date.

    Parameters
    ----------
    content : dict
        With a ``schema_version`` from 1 to the present one.
    """
    for version in range(content["schema_version"], SCHEMA_VERSION):
        content = {**_STEPS[version](content), "schema_version": version + 1}
    return content
