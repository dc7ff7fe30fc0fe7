import numpy as np
import pytest
import torch

from vpr_baselines.twostage import lbfgs
from vpr_baselines.twostage.lbfgs import PATIENCE, minimise
from vpr_bench.checkpoint import checkpoints

CENTRE = torch.arange(12, dtype=torch.float32).reshape(3, 4)
SCALES = torch.logspace(-1, 1, 12).reshape(3, 4)


def bowl(point):
    """A quadratic that is a hundred times steeper in some directions than in others."""
    away = point - CENTRE
    return float((SCALES * away.square()).double().sum()) / 2, SCALES * away


class StoppedHereError(Exception):
    pass


def failing_after(calls, function=bowl):
    left = [calls]

    def call(point):
        left[0] -= 1
        if left[0] < 0:
            raise StoppedHereError
        return function(point)

    return call


def test_it_finds_the_bottom_of_a_bowl():
    point, rounds, stopped = minimise(bowl, torch.zeros(3, 4))
    assert torch.allclose(point, CENTRE, atol=1e-2)
    assert stopped == "converged" and 3 < rounds < 60


def test_the_bottom_is_where_it_may_begin():
    point, rounds, stopped = minimise(bowl, CENTRE.clone())
    assert torch.equal(point, CENTRE) and rounds == 0 and stopped == "converged"


def test_it_goes_on_as_long_as_the_validation_losses_do_not_rise_beyond_chance():
    noise = torch.tensor([1.0, -1.0, 2.0, -2.0])
    calls = []

    def validate(point):
        calls.append(point)
        return noise * (-1) ** len(calls) + 0.1 * len(calls)

    point, _, stopped = minimise(bowl, torch.zeros(3, 4), validate)
    assert stopped == "converged" and torch.allclose(point, CENTRE, atol=1e-2)


def test_it_stops_when_all_validation_losses_have_risen_for_a_while_and_keeps_the_best():
    points = []

    def validate(point):
        points.append(point)
        return torch.full((5,), abs(len(points) - 3.0))  # lowest in the third round

    point, rounds, stopped = minimise(bowl, torch.zeros(3, 4), validate)
    assert stopped == "validation" and rounds == 3
    assert torch.equal(point, points[2]) and len(points) == 3 + PATIENCE


@pytest.mark.parametrize("losses", [torch.empty(0), torch.ones(1)], ids=["none", "one"])
def test_too_few_validation_samples_to_tell_chance_by_never_stop_it(losses):
    rises = iter(range(1000))
    _, _, stopped = minimise(bowl, torch.zeros(3, 4), lambda point: losses * next(rises))
    assert stopped == "converged"


def test_it_gives_up_after_so_many_rounds(monkeypatch):
    monkeypatch.setattr(lbfgs, "LIMIT", 2)
    told = []
    _, rounds, stopped = minimise(bowl, torch.zeros(3, 4), advance=told.append)
    assert rounds == 2 and stopped == "limit"


@pytest.mark.parametrize("calls", [1, 4, 9, 15])
def test_interrupted_it_goes_on_the_same_to_the_last_bit(tmp_path, monkeypatch, calls):
    monkeypatch.setattr(lbfgs, "_SAVE_EVERY", 0.0)

    def validate(point):
        return (point - CENTRE).square().flatten()

    expected = minimise(bowl, torch.zeros(3, 4), validate)
    with checkpoints(tmp_path), pytest.raises(StoppedHereError):
        minimise(failing_after(calls), torch.zeros(3, 4), validate)
    counted = failing_after(100)
    with checkpoints(tmp_path):
        found = minimise(counted, torch.zeros(3, 4), validate)
    assert torch.equal(found[0], expected[0]) and found[1:] == expected[1:]


def test_what_is_stored_lets_it_begin_in_the_middle(tmp_path, monkeypatch):
    monkeypatch.setattr(lbfgs, "_SAVE_EVERY", 0.0)
    with checkpoints(tmp_path), pytest.raises(StoppedHereError):
        minimise(failing_after(12), torch.zeros(3, 4))
    with checkpoints(tmp_path):
        calls = []
        minimise(lambda point: calls.append(0) or bowl(point), torch.zeros(3, 4))
    whole = []
    minimise(lambda point: whole.append(0) or bowl(point), torch.zeros(3, 4))
    assert len(calls) <= len(whole) - 10


def test_it_needs_no_curvature_to_take_the_first_step():
    """A gradient a million times too long."""
    point, _, _ = minimise(lambda point: tuple(1e6 * part for part in bowl(point)), torch.zeros(3, 4))
    assert np.allclose(point, CENTRE, atol=1e-2)
