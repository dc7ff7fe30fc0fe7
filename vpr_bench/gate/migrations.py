"""What a baseline file looked like in former versions, step by step to the present one."""

from vpr_bench.files.migrations import Step

SCHEMA_VERSION = 1

STEPS: dict[int, Step] = {}
