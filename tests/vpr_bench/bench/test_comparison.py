import numpy as np
import pytest

from vpr_bench.bench.comparison import VariantTimes
from vpr_bench.bench.variants import Variant
from vpr_bench.method.build import BuiltMethod


def times(**milliseconds):
    built = BuiltMethod("m", "1", {}, None, "m", None)
    seconds = {name: np.full((2, 5), value / 1000) for name, value in milliseconds.items()}
    return VariantTimes(Variant("m", built), None, seconds)


def test_percentiles_are_over_images_and_rounds():
    one = times(total=1)
    one.seconds["total"][:] = np.arange(10).reshape(2, 5) / 1000
    assert one.latency()["latency_total_p50"] == pytest.approx(4.5)
    assert one.latency()["latency_total_p95"] == pytest.approx(8.55)


def test_the_time_before_reranking_is_compared_too():
    bare = times(encode=10, total=10)
    cosine, spatial = times(encode=10, rerank=1, total=12), times(encode=10, rerank=9, total=20)
    ratios = {name: ratio.value for name, ratio in spatial.ratios(cosine).items()}
    assert ratios == pytest.approx({"encode": 1, "rerank": 9, "before_rerank": 1, "total": 20 / 12})
    assert spatial.ratios(bare)["before_rerank"].value == pytest.approx(1.1)


def test_only_what_both_noted_is_compared():
    assert set(times(own=3, total=4).ratios(times(encode=3, total=4))) == {"before_rerank", "total"}
