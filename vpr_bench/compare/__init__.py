"""Two stored runs, compared query by query.

What a program needs is here: :func:`compare_runs` and what it returns.
"""

from vpr_bench.compare.differences import MetricDifference
from vpr_bench.compare.flipped import Best, FlippedQuery
from vpr_bench.compare.paired import PairedComparison, compare_runs
from vpr_bench.compare.speed import Speed, StageRatio

__all__ = ["Best", "FlippedQuery", "MetricDifference", "PairedComparison", "Speed", "StageRatio", "compare_runs"]
