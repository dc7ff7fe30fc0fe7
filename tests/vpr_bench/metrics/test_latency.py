import numpy as np
import pytest

from vpr_bench.metrics.latency import latency


def test_percentiles_in_milliseconds():
    # 101 queries of 0 to 100 ms: the percentiles are the values themselves.
    encode = np.arange(101) / 1000
    values = latency({"encode": encode, "match": np.full(101, 0.002)})
    assert list(values) == [
        f"latency_{stage}_p{percentile}" for stage in ("encode", "match", "total") for percentile in (50, 95, 99)
    ]
    assert values["latency_encode_p95"] == pytest.approx(95)
    assert values["latency_match_p99"] == pytest.approx(2)
    assert values["latency_total_p50"] == pytest.approx(52)


def test_the_total_is_summed_query_by_query():
    # The slow queries of the two stages are not the same ones: no query takes 20 ms.
    values = latency({"encode": np.array([0.010, 0.001]), "match": np.array([0.001, 0.010])})
    assert values["latency_total_p99"] == pytest.approx(11)


def test_a_measured_total_is_kept():
    values = latency({"total": np.array([0.5]), "encode": np.array([0.2])})
    assert values["latency_total_p50"] == 500
    assert list(values)[-1] == "latency_total_p99"


def test_nothing_measured():
    assert latency({}) == {}
    assert np.isnan(latency({"encode": np.zeros(0)})["latency_total_p50"])


def test_stages_of_different_length_are_refused():
    with pytest.raises(ValueError, match="'match': 1"):
        latency({"encode": np.zeros(2), "match": np.zeros(1)})
