"""Curves are drawn around the radius that counts, and never where every answer would be right."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.page.radii import drawn, radii, unit_in_words
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol


@given(st.floats(0, 1e6), st.sampled_from(["f", "m"]))
def test_the_protocols_own_radius_is_among_them(radius, unit):
    found = radii(Protocol("own", "a", "b", radius, unit))
    assert radius in found
    assert found == sorted(set(found))


def test_radii_that_reach_over_the_whole_map_are_left_out():
    places = Places(np.arange(5.0), np.arange(5.0))
    found = drawn(Protocol.parse("own/a-b@1f"), places)
    assert [one.radius for one in found] == [0, 1, 2]


@pytest.mark.parametrize(
    ("reach", "words"), [("2f", "frames"), ("5m", "metres"), ("3nearest", "nearest references"), ("pair", "")]
)
def test_units_have_names(reach, words):
    assert unit_in_words(Protocol.parse(f"own/a-b@{reach}")) == words
