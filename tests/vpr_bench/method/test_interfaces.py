import pytest

from vpr_bench.method.interfaces import frames_ahead, is_sequential


class Single:
    def reset(self): ...


class Follower:
    sequential = True

    def reset(self): ...


class Foreseer(Follower):
    future = 4

    def foresee(self, image): ...


class Stuck:
    sequential = True


def test_a_method_is_sequential_if_it_says_so():
    assert not is_sequential(Single())  # whatever its reset does, it asked for nothing
    assert is_sequential(Follower())
    with pytest.raises(TypeError, match=r"no reset\(\)"):
        is_sequential(Stuck())


def test_only_who_foresees_is_shown_frames_ahead():
    assert (frames_ahead(Single()), frames_ahead(Follower()), frames_ahead(Foreseer())) == (0, 0, 4)
