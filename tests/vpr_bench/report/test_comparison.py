import numpy as np
import pytest

from vpr_bench.bench.comparison import Comparison, VariantTimes
from vpr_bench.bench.variants import Variant
from vpr_bench.method.build import BuiltMethod
from vpr_bench.report.comparison import comparison_grid
from vpr_bench.runner.machine import describe_machine


@pytest.fixture
def compare():
    def make(**variants):
        times = [
            VariantTimes(
                Variant(name, BuiltMethod(name, "1", {}, None, name, None)),
                None,
                {stage: np.full((3, 7), value / 1000) for stage, value in stages.items()},
            )
            for name, stages in variants.items()
        ]
        return Comparison("d/a-b", 12, (4, 6, 3), 3, "shuffled", 5, 0, describe_machine(2), times)

    return make


def test_one_line_per_variant_with_its_times_and_its_ratio_to_the_first(compare):
    grid = comparison_grid(compare(fast={"encode": 10, "total": 10}, slow={"encode": 10, "match": 2, "total": 12.5}))
    assert grid.title == "d/a-b  7 images × 3 rounds, 12 references"
    assert grid.head == ["variant", "encode\nms", "match\nms", "total\nms", "ratio"]
    assert grid.rows == [
        ["fast", "10.0\n10.0", "", "10.0\n10.0", "1"],
        ["slow", "10.0\n10.0", "2.00\n2.00", "12.5\n12.5", "1.250\n1.250–1.250"],
    ]
    assert "threads: 2" in grid.note


def test_times_before_reranking_have_a_column_where_one_reranks(compare):
    grid = comparison_grid(compare(bare={"total": 10}, whole={"rerank": 4, "total": 15}))
    assert grid.head[-2:] == ["ratio", "before\nrerank"]
    assert [row[-2:] for row in grid.rows] == [["1", "1"], ["1.500\n1.500–1.500", "1.100\n1.100–1.100"]]
