import numpy as np
import pytest
import utm
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_datasets.layouts.metres import PositionError, parse_zone, to_metres, zone_of


def refused(latitude, longitude, zone="33U"):
    with pytest.raises(PositionError) as caught:
        to_metres(latitude, longitude, zone)
    return caught.value


def test_a_known_point_in_berlin():
    metres = to_metres([52.489175], [13.298339], "33U")
    assert metres.shape == (1, 2) and metres.dtype == np.float64
    np.testing.assert_allclose(metres, [[384462.04, 5816809.06]], atol=0.01)


def test_no_positions_are_no_metres():
    assert to_metres([], [], "33U").shape == (0, 2)


zones = st.tuples(st.integers(1, 60), st.floats(-4.4, 4.4), st.floats(-79.9, 83.9)).filter(lambda z: abs(z[2]) > 0.01)


@given(zones)
def test_positions_come_back_from_metres_within_a_centimetre(place):
    number, aside, latitude = place
    longitude = (6 * number - 183 + aside + 180) % 360 - 180
    zone = f"{number}{'N' if latitude > 0 else 'M'}"
    east, north = to_metres([latitude], [longitude], zone)[0]
    back = utm.to_latlon(east, north, number, zone[-1], strict=False)
    metres_per_degree = 111_700
    assert abs(back[0] - latitude) * metres_per_degree < 0.01
    turned = (back[1] - longitude + 180) % 360 - 180
    assert abs(turned) * np.cos(np.radians(latitude)) * metres_per_degree < 0.01


@given(st.permutations(range(6)))
def test_the_first_position_decides_nothing(order):
    latitude, longitude = np.linspace(52, 53, 6), np.linspace(11.5, 12.5, 6)  # zones 32 and 33
    order = list(order)
    np.testing.assert_array_equal(
        to_metres(latitude, longitude, "33U")[order], to_metres(latitude[order], longitude[order], "33U")
    )


def test_metres_are_even_across_a_border_of_zones():
    east = to_metres([52.5, 52.5, 52.5], [11.999, 12.0, 12.001], "33U")
    np.testing.assert_allclose(np.linalg.norm(np.diff(east, axis=0), axis=1), 68.0, atol=0.1)


@pytest.mark.parametrize("zone", ["37N", "37M"])
def test_metres_are_even_across_the_equator(zone):
    north = to_metres([0.001, 0.0, -0.001], [36.8] * 3, zone)[:, 1]
    np.testing.assert_allclose(np.diff(north), -110.53, atol=0.1)


def test_the_date_line_is_no_border():
    metres = to_metres([-17.0, -17.0], [179.999, -179.999], "60K")
    assert np.linalg.norm(metres[1] - metres[0]) == pytest.approx(213, abs=1)


def test_the_wrong_sign_of_the_latitude_is_told():
    error = refused([27.5], [153.0], "56J")
    assert "the latitude's sign looks wrong" in str(error) and "south of the equator" in str(error)
    assert "the latitude's sign looks wrong" in str(refused([-52.5], [13.3]))


@pytest.mark.parametrize(
    ("latitude", "longitude", "why"),
    [
        (float("nan"), 13.3, "is not a position"),
        (52.5, float("inf"), "is not a position"),
        (0.0, 0.0, "no fix"),
        (-0.0, 0.0, "no fix"),
        (84.1, 13.3, "the latitude must lie"),
        (-81, 13.3, "the latitude must lie"),
        (52.5, 180.5, "the longitude must lie"),
        (52.5, 21.1, "more than 6 degrees of longitude from the middle of the zone 33U"),
        (13.3, 52.5, "more than 6 degrees"),  # the two exchanged
    ],
)
def test_what_cannot_be_a_position_is_refused_with_its_row(latitude, longitude, why):
    error = refused([52.4, 52.4, latitude, latitude], [13.3, 13.3, longitude, longitude])
    assert why in str(error)
    assert (error.row, error.count) == (2, 2)


def test_six_degrees_from_the_middle_are_near_enough():
    assert np.isfinite(to_metres([52.5, 52.5], [9.0, 21.0], "33U")).all()


@pytest.mark.parametrize(
    ("latitude", "longitude", "zone"),
    [(52.5, 13.3, "33U"), (-27.5, 153, "56J"), (60.4, 5.3, "32V"), (78.2, 15.6, "33X"), (-33.9, 18.4, "34H")],
)
def test_zones_are_named_with_the_exceptions_of_norway(latitude, longitude, zone):
    assert zone_of(latitude, longitude) == zone


@pytest.mark.parametrize("place", [(0, 0), (float("nan"), 1), (91, 0), (0, 200)])
def test_nowhere_is_in_no_zone(place):
    with pytest.raises(PositionError):
        zone_of(*place)


@pytest.mark.parametrize("zone", ["", "33", "U", "0U", "61U", "33I", "33O", "33A", "33Z", "33UU", 33, None, "33 U"])
def test_what_is_no_zone_is_refused(zone):
    with pytest.raises(DataError, match=r"The zone must be .* 33U\. Got"):
        parse_zone(zone)


def test_a_zone_may_be_written_in_small_letters():
    assert parse_zone(" 05q ") == (5, "Q")
