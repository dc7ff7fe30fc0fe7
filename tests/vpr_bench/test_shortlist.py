import numpy as np
import pytest

from vpr_bench.shortlist import collect_shortlists, shortlist


def test_steps_are_collected_in_their_order():
    with collect_shortlists() as shortlists:
        shortlist("coarse", [3, 1])
        shortlist("nothing ruled out", None)
        shortlist("fine", [1])
    assert list(shortlists) == ["coarse", "nothing ruled out", "fine"]
    assert shortlists["coarse"].tolist() == [3, 1] and shortlists["nothing ruled out"] is None


def test_nobody_has_to_listen():
    shortlist("coarse", [3, 1])
    shortlist("coarse", [3, 1])
    with collect_shortlists() as shortlists:
        pass
    shortlist("coarse", [1])
    assert shortlists == {}


def test_the_array_may_be_used_again():
    indices = np.array([1, 2])
    with collect_shortlists() as shortlists:
        shortlist("coarse", indices)
        indices[:] = 0
    assert shortlists["coarse"].tolist() == [1, 2]


def test_a_step_is_taken_once():
    with collect_shortlists(), pytest.raises(ValueError, match="'coarse' was noted twice"):
        shortlist("coarse", [1])
        shortlist("coarse", [1])


def test_collections_do_not_mix():
    with collect_shortlists() as outer:
        with collect_shortlists() as inner:
            shortlist("inside", [1])
        shortlist("outside", [1])
    assert list(inner) == ["inside"] and list(outer) == ["outside"]
