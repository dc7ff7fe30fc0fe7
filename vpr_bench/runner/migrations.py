"""What ``run.json`` looked like in former versions, step by step to the present one.

Stored runs of every former version are kept with the tests.
"""

from typing import Any

from vpr_bench.files.migrations import Step

SCHEMA_VERSION = 2


def _to_2(content: dict[str, Any]) -> dict[str, Any]:
    """Version 1 noted nothing of how a run came about; memory and BLAS of the machine were not noted either."""
    return {**content, "provenance": {}}


STEPS: dict[int, Step] = {1: _to_2}
