import dataclasses

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import UsageError
from vpr_bench.types.protocol import Protocol

NAMES = st.from_regex(r"[a-z0-9][a-z0-9._]{0,8}", fullmatch=True)
TRAVERSES = st.lists(NAMES, min_size=1, max_size=3).map("+".join)
RADII = st.one_of(
    st.integers(0, 10**18),
    st.floats(0, allow_nan=False, allow_infinity=False),
    st.sampled_from([0.1, 1e-7, 5e-324, 1e15, 1e16, 1.7976931348623157e308]),
)


@st.composite
def protocols(draw):
    unit = draw(st.sampled_from(["f", "m", "pair"]))
    return Protocol(
        dataset=draw(st.from_regex(r"[a-z0-9][a-z0-9-]{0,8}", fullmatch=True)),
        references=draw(TRAVERSES),
        queries=draw(TRAVERSES),
        radius=0 if unit == "pair" else draw(RADII),
        unit=unit,
        edition=draw(st.one_of(st.just("real"), NAMES)),
        unmatched=draw(st.sampled_from(["exclude", "miss", "reject"])),
    )


@given(protocols())
def test_every_protocol_parses_back_from_its_id(protocol):
    assert Protocol.parse(str(protocol)) == protocol


@given(protocols(), protocols())
def test_different_protocols_have_different_ids(one, other):
    assert (str(one) == str(other)) == (one == other)


@pytest.mark.parametrize(
    "text",
    [
        "gardens/day_left-night_right@2f",
        "gardens:simulated/day_left-day_right@3f~reject",
        "st-lucia/a+b-c@0.5m~miss",
        "nordland/summer-winter@pair",
        "gardens/a-b@1e-07m",
        "gardens/a-b@1e+300m",
    ],
)
def test_a_canonical_id_stays_as_it_is(text):
    assert str(Protocol.parse(text)) == text


@pytest.mark.parametrize(
    ("text", "canonical"),
    [
        ("gardens:real/a-b@2f", "gardens/a-b@2f"),
        ("gardens/a-b@2.0f~exclude", "gardens/a-b@2f"),
        ("gardens/a-b@02.50m", "gardens/a-b@2.5m"),
        ("gardens/a-b@-0f", "gardens/a-b@0f"),
    ],
)
def test_other_ways_of_writing_become_the_canonical_id(text, canonical):
    assert str(Protocol.parse(text)) == canonical


def test_the_parts_are_read():
    protocol = Protocol.parse("gardens:simulated/day_left-night_right@2.5m~reject")
    assert dataclasses.astuple(protocol) == ("gardens", "day_left", "night_right", 2.5, "m", "simulated", "reject")
    assert (protocol.source, protocol.pairing) == ("gardens:simulated", "day_left-night_right")
    assert str(protocol.with_radius(3)) == "gardens:simulated/day_left-night_right@3m~reject"


@pytest.mark.parametrize(
    "text",
    [
        *("", "gardens", "gardens/a-b", "gardens/a@2f", "/a-b@2f", "gardens/a-b@f", "gardens/a-b@2", "gardens/a-b@2km"),
        *("gardens:/a-b@2f", "Gardens/a-b@2f", "gardens/a-b-c@2f", "gardens/a-b@2f~", "gardens/a-b@2f~maybe"),
        *("gardens/a-b@-1f", "gardens/a-b@nanf", "gardens/a-b@inff", "gardens/a-b@1e999f", "gardens/a-b@..f"),
        *("gardens/a-b@2f\n", " gardens/a-b@2f", "../etc/a-b@2f", "gardens/../x-b@2f", "gardens/a+-b@2f"),
        *("gardens/a-b@2pair", "gardens/a-b@٢f", "gardens/a-b@1_0f"),
    ],
)
def test_what_is_no_id_is_refused(text):
    with pytest.raises(UsageError) as caught:
        Protocol.parse(text)
    assert str(caught.value).count("\n") <= 1


@pytest.mark.parametrize("radius", [-1, -0.001, float("nan"), float("inf"), "2", None, [2]])
def test_a_radius_is_a_number_of_at_least_0(radius):
    with pytest.raises(UsageError, match=r"radius must be a number of at least 0. Got"):
        Protocol("gardens", "a", "b", radius, "f")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"unmatched": "maybe"}, "must be one of exclude, miss, reject. Got 'maybe'"),
        ({"unit": "pair"}, "Pair labels have no radius"),
        ({"unit": "km"}, "is not a protocol"),
        ({"dataset": "Gardens"}, "is not a protocol"),
        ({"references": "day-left"}, "is not a protocol"),
        ({"queries": ""}, "is not a protocol"),
        ({"edition": ""}, "is not a protocol"),
        ({"edition": "a/b"}, "is not a protocol"),
    ],
)
def test_what_could_not_be_written_as_an_id_is_refused(changes, message):
    with pytest.raises(UsageError, match=message):
        Protocol(**{"dataset": "gardens", "references": "a", "queries": "b", "radius": 2, "unit": "f", **changes})


def test_a_protocol_is_frozen_and_can_be_a_key():
    protocol = Protocol.parse("gardens/a-b@2f")
    with pytest.raises(dataclasses.FrozenInstanceError):
        protocol.radius = 3
    assert {protocol: 1}[Protocol("gardens", "a", "b", 2, "f")] == 1
