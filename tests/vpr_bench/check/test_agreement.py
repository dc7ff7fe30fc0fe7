import pytest

from vpr_bench.check.method.agreement import agree, expect_same
from vpr_bench.check.outcome import Failed
from vpr_bench.types.match import Match


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (([], []), ([], [])),
        (([1, 2], [9, 3]), ([1, 2], [9, 3.0005])),
        (([1, 2], [3, 3]), ([2, 1], [3, 3])),
        (([1, 2], [9, 3]), ([1, 5], [9, 3])),
        (([1], [0]), ([4], [0])),
    ],
    ids=["nothing", "rounding", "equal scores", "equal at the cut", "all zero"],
)
def test_the_same_answers(one, other):
    assert agree(Match(*one), Match(*other)) and agree(Match(*other), Match(*one))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (([1], [9]), ([], [])),
        (([1, 2], [9, 3]), ([1, 2], [9, 3.1])),
        (([1, 2], [9, 3]), ([2, 1], [9, 3])),
        (([1, 2], [9, 3]), ([5, 2], [9, 3])),
    ],
    ids=["length", "scores", "exchanged", "another place"],
)
def test_other_answers(one, other):
    assert not agree(Match(*one), Match(*other)) and not agree(Match(*other), Match(*one))


def test_the_first_difference_is_told():
    one = [Match([0], [1]), Match([4, 3, 2, 1], [4, 3, 2, 1])]
    other = [Match([0], [1]), Match([], [])]
    with pytest.raises(
        Failed, match=r"^again: query 1 is answered with nothing instead of 4 \(4\), 3 \(3\), 2 \(2\), …$"
    ):
        expect_same(one, other, "again")
    with pytest.raises(Failed, match=r"^again: 1 answers instead of 2$"):
        expect_same(one, other[:1], "again")


def test_bit_by_bit():
    one, other = [Match([0], [1])], [Match([0], [1.000001])]
    expect_same(one, other, "again")
    with pytest.raises(Failed):
        expect_same(one, other, "again", exactly=True)
