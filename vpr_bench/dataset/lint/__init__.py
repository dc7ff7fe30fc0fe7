"""Looking for what is wrong with the images and the ground truth of a dataset before anything is measured on it.

Each module holds checks of one kind; every check has an id that never changes, and :func:`lint_source` runs all.
"""

from vpr_bench.dataset.lint.finding import SEVERITIES, Finding, Severity
from vpr_bench.dataset.lint.inspection import Inspection, inspect_source, lint_source

__all__ = ["SEVERITIES", "Finding", "Inspection", "Severity", "inspect_source", "lint_source"]
