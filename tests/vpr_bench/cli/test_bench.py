import json


def test_pairs(vpr_bench):
    done = vpr_bench("bench", "pairs", "--queries", "300", "--dimensions", "8", "--radius", "2")
    facts = json.loads(done.out)
    assert done.code == 0
    assert 0 < facts["pr_auc_pairs"] < 1
    assert facts["peak_rss_bytes"] > 0


def test_bootstrap(vpr_bench):
    done = vpr_bench("bench", "bootstrap", "--queries", "200", "--resamples", "20")
    assert done.code == 0 and json.loads(done.out)["resamples"] == 20


def test_envs(vpr_bench, monkeypatch):
    monkeypatch.setattr("vpr_bench.bench.envs.run", lambda *given: {"given": given})
    done = vpr_bench("bench", "envs", "--dataset", "gardens", "--num-envs", "8", "--episodes", "2")
    assert done.code == 0 and json.loads(done.out) == {"given": ["gardens", 8, 2]}
