import pytest

from vpr_bench.leaderboard.merge import merge
from vpr_bench.leaderboard.protocols import protocols_of


def test_a_run_serves_every_reach_that_its_dataset_lists(make_run):
    run = make_run(protocol="gardens/day_left-night_right@0f", right=5)
    expected = ["gardens/day_left-night_right@0f", "gardens/day_left-night_right@2f"]
    assert [str(protocol) for protocol in protocols_of(run)] == expected
    entries = merge([], [run]).entries
    assert [str(entry.protocol) for entry in entries] == expected
    assert len({entry.run for entry in entries}) == 1


@pytest.mark.parametrize("protocol", ["streets/day-night@0f", "gardens:foggy/day_left-night_right@2f"])
def test_without_the_card_a_run_has_the_protocol_it_was_asked_for(make_run, protocol):
    assert [str(one) for one in protocols_of(make_run(protocol=protocol))] == [protocol]


def test_what_the_places_do_not_say_is_passed_over(make_run):
    run = make_run(protocol="berlin-a100:simulated/a100_2-a100_1@5nearest")
    assert [protocol.reach for protocol in protocols_of(run)] == ["5nearest", "25m"]
    # The ten places by hand lie within nine metres.
    assert [entry.protocol.reach for entry in merge([], [run]).entries] == ["5nearest"]
