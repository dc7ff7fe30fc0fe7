import json

from vpr_bench.bench.envs import run


def test_a_small_run_reports_what_it_measured():
    facts = run("gardens:simulated/day_left.first20-day_right.first20", num_envs=4, episodes=1)
    assert json.loads(json.dumps(facts)) == facts
    assert facts["queries"] == 20 and facts["num_envs"] == 4
    assert 0 < facts["again_seconds"] < facts["first_seconds"] < 30
    assert 0 < facts["overhead_us"] < facts["step_us"]
    assert facts["copy_us"] > 0
