import pytest

from vpr_bench.dataset.parts import Part, parse_parts
from vpr_bench.errors import UsageError


def test_a_name_is_a_traverse_parts_of_it_or_several():
    assert parse_parts("summer") == [Part("summer")]
    assert parse_parts("summer.first100.every10+fall.even5") == [
        Part("summer", (("first", 100), ("every", 10))),
        Part("fall", (("even", 5),)),
    ]


@pytest.mark.parametrize(
    ("name", "taken"),
    [
        ("a", [0, 1, 2, 3, 4, 5, 6]),
        ("a.every3", [0, 3, 6]),
        ("a.first2", [0, 1]),
        ("a.first9", [0, 1, 2, 3, 4, 5, 6]),
        ("a.even3", [0, 2, 4]),
        ("a.even7", [0, 1, 2, 3, 4, 5, 6]),
        ("a.even70", [0, 1, 2, 3, 4, 5, 6]),
        ("a.first4.every2", [0, 2]),
        ("a.every2.first3", [0, 2, 4]),
    ],
)
def test_what_is_taken_of_seven_frames(name, taken):
    assert parse_parts(name)[0].indices(7) == taken


@pytest.mark.parametrize("name", ["a.every", "a.every0", "a.each2", "a.", "a.every-1", "a.every2x"])
def test_what_is_no_part_is_refused(name):
    with pytest.raises(UsageError, match=r"Write it like a\.every10"):
        parse_parts(name)
