import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.dataset.recording import Recording
from vpr_bench.types.traverse import Traverse

IMAGE = np.zeros((2, 2, 3), np.uint8)


def recording(name, length, compass=True):
    traverse = Traverse(name, [IMAGE] * length)
    return Recording(traverse, np.arange(length) + 0.5, np.arange(length) * 10.0 if compass else None)


@given(st.lists(st.integers(0, 4), min_size=1, max_size=4))
def test_joining_and_splitting_again_loses_nothing(lengths):
    parts = [recording(f"part{number}", length) for number, length in enumerate(lengths)]
    again = Recording.join(parts).split()
    for new, old in zip(again, parts, strict=True):
        assert new.traverse.name == old.traverse.name
        assert new.labels.tolist() == old.labels.tolist() and new.compass.tolist() == old.compass.tolist()


def test_what_only_some_have_is_not_joined():
    with pytest.raises(ValueError, match=r"only some of a\+b have compass"):
        Recording.join([recording("a", 2), recording("b", 2, compass=False)])


def test_a_subset_keeps_what_belongs_together():
    some = recording("a", 5).subset([4, 1])
    assert some.labels.tolist() == [4.5, 1.5] and some.compass.tolist() == [40.0, 10.0] and len(some) == 2


@pytest.mark.parametrize("labels", [np.zeros(3), np.array([0.0, np.nan])])
def test_one_finite_label_per_image(labels):
    with pytest.raises(ValueError, match="labels must be 2 finite numbers"):
        Recording(Traverse("a", [IMAGE] * 2), labels)
