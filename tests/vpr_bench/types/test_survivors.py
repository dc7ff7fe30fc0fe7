import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.types.survivors import Survivors, from_arrays, gathered, to_arrays

_LISTS = st.none() | st.sets(st.integers(0, 9)).map(lambda found: np.array(sorted(found), dtype=np.int32))


def _as_lists(survivors):
    return {
        one.step: [None if one[query] is None else one[query].tolist() for query in range(len(one))]
        for one in survivors
    }


@given(st.lists(st.dictionaries(st.sampled_from(["coarse", "fine", "last"]), _LISTS), max_size=6))
def test_round_trip(shortlists):
    survivors = gathered(shortlists)
    again = from_arrays(to_arrays(survivors), len(shortlists), 10)
    assert _as_lists(again) == _as_lists(survivors)
    for step, lists in _as_lists(survivors).items():
        wanted = [of_query.get(step) for of_query in shortlists]
        assert lists == [None if one is None else one.tolist() for one in wanted]


def test_a_step_that_few_queries_took_keeps_its_place():
    taken = [["coarse", "last"], ["last"], ["coarse", "fine", "last"]]
    assert [one.step for one in gathered([dict.fromkeys(steps) for steps in taken])] == ["coarse", "fine", "last"]
    assert [one.step for one in gathered([{"last": None}, {"coarse": None, "last": None}])] == ["coarse", "last"]


def test_nothing_noted_is_nothing_stored():
    assert to_arrays(gathered([{}, {}])) == {}
    assert from_arrays({}, 2, 10) == []


def test_what_was_not_ruled_out_takes_no_room():
    survivors = gathered([{"coarse": None}] * 1000)
    assert sum(array.nbytes for array in to_arrays(survivors).values()) < 10_000


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"step0.references": np.array([0, 1, 10], np.int32)}, "must lie in"),
        ({"step0.references": np.array([0, 1, -1], np.int32)}, "must lie in"),
        ({"step0.references": np.array([0.0, 1.0, 2.0])}, "made of integers"),
        ({"step0.offsets": np.array([0, 3, 2])}, "ascend"),
        ({"step0.offsets": np.array([0, 4, 3])}, "ascend"),
        ({"step0.offsets": np.array([0, 3])}, "one offset more"),
        ({"step0.narrowed": np.array([True, False])}, "lists nothing"),
        ({"step0.narrowed": np.array([True])}, "for 2 queries"),
        ({"steps": np.array(["coarse", "coarse"])}, "step1"),
        ({"steps": np.array([""])}, "printable"),
        ({"steps": np.array(["\x1b[31m"])}, "printable"),
        ({"steps": np.array([7])}, "printable"),
    ],
)
def test_what_comes_from_elsewhere_is_checked(change, said):
    arrays = {
        "steps": np.array(["coarse"]),
        "step0.narrowed": np.array([True, True]),
        "step0.offsets": np.array([0, 1, 3]),
        "step0.references": np.array([0, 1, 2], np.int32),
    }
    assert isinstance(from_arrays(arrays, 2, 10)[0], Survivors)
    with pytest.raises((ValueError, KeyError), match=said):
        from_arrays(arrays | change, 2, 10)
