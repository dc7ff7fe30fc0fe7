"""Files of former versions, brought up to date when they are read; on disk they are left as they are."""

from collections.abc import Callable, Mapping
from typing import Any

Step = Callable[[dict[str, Any]], dict[str, Any]]
"""Takes the content of one schema version to the next; the number of the version is none of its business."""


def migrated(content: dict[str, Any], steps: Mapping[int, Step], present: int) -> dict[str, Any]:
    """Bring the content of a file of a former schema up to date.

    Parameters
    ----------
    content : dict
        With a ``schema_version`` from 1 to the present one; it is not changed.
    steps : mapping
        By the version that each starts from.
    present : int
        The present version.

    Examples
    --------
    >>> migrated({"schema_version": 1, "colour": "red"}, {1: lambda old: {**old, "size": None}}, 2)
    {'schema_version': 2, 'colour': 'red', 'size': None}
    """
    for version in range(content["schema_version"], present):
        content = {**steps[version](content), "schema_version": version + 1}
    return content
