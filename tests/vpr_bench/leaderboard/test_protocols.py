import pytest

from vpr_bench.leaderboard.merge import merge
from vpr_bench.leaderboard.protocols import protocols_of, serves
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol


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


def test_a_run_does_not_serve_what_its_places_do_not_say(make_run):
    run = make_run(protocol="berlin-a100:simulated/a100_2-a100_1@5nearest")
    # The ten places by hand lie within nine metres.
    assert {one.reach: serves(run, one) for one in protocols_of(run)} == {"5nearest": True, "25m": False}


def test_a_listed_ground_truth_is_served_only_where_it_was_stored(make_run):
    run = make_run(protocol="streets/day-night@0f")
    given = Protocol.parse("streets/day-night@given")
    assert not serves(run, given)
    run.__dict__["places"] = Places(given=GroundTruth.from_pairs([0], [0], 10, 10))
    assert serves(run, given)
    assert not serves(run, run.protocol)
