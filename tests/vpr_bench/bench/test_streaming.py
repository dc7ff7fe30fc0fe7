from vpr_bench.bench.streaming import run


def test_a_long_traverse_is_made_by_repeating_images():
    small = {"width": "32", "height": "32", "cell": "8"}
    facts = run("gardens:simulated", "vpr_baselines.hog:Hog", small, frames=300, limit=5)
    assert (facts["references"], facts["queries"], facts["asked"]) == (300, 300, 5)
    assert facts["images"] == "gardens:simulated, repeated"
    assert facts["fit_seconds"] > 0 and facts["latency_ms"]["latency_total_p50"] > 0
    assert 10**7 < facts["peak_rss_bytes"] < 10**10
