"""Minimising a convex function, so that it can be interrupted and goes on the same to the last bit."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from vpr_baselines.twostage.report import Stopped
from vpr_bench.checkpoint import load_checkpoint, save_checkpoint

Function = Callable[[Tensor], tuple[float, Tensor]]
"""Returns value and gradient at a point."""

Validate = Callable[[Tensor], Tensor]
"""Returns the (n,) losses of the validation samples at a point."""

LIMIT = 300
"""Rounds at most."""
PATIENCE = 10
"""Rounds in a row that may be worse on the validation samples than the best one."""

_HISTORY = 10  # past steps that tell the curvature
_SUFFICIENT = 1e-4  # of the decrease that the slope promises (Armijo)
_SHORTEST = 1e-6  # part of a step; beyond, float32 has no better point to offer
_CONVERGED = 1e-7  # relative decrease of one round
_DEVIATIONS = 2.0  # standard errors
_SAVE_EVERY = 30.0  # seconds; what is saved does not change what comes out


@dataclass
class _State:
    """Everything that the next round depends on."""

    point: Tensor
    gradient: Tensor
    loss: float
    kept: Tensor
    kept_round: int = 0
    round: int = 0
    lowest: Tensor = field(default_factory=lambda: torch.empty(0))  # validation losses of the best round
    steps: list[Tensor] = field(default_factory=list)
    changes: list[Tensor] = field(default_factory=list)

    def arrays(self) -> dict[str, NDArray[Any]]:
        none = self.point.new_empty((0, *self.point.shape))
        return {
            "point": self.point.numpy(),
            "gradient": self.gradient.numpy(),
            "kept": self.kept.numpy(),
            "lowest": self.lowest.numpy(),
            "steps": torch.stack(self.steps).numpy() if self.steps else none.numpy(),
            "changes": torch.stack(self.changes).numpy() if self.changes else none.numpy(),
            "numbers": np.array([self.loss, self.kept_round, self.round], dtype=np.float64),
        }

    @classmethod
    def of(cls, arrays: dict[str, NDArray[Any]]) -> "_State":
        names = ("point", "gradient", "kept", "lowest", "steps", "changes")
        # Copied to memory of torch's alignment, on which the last bits of sums depend.
        point, gradient, kept, lowest, steps, changes = (torch.tensor(arrays[name]) for name in names)
        loss, kept_round, last_round = arrays["numbers"].tolist()
        return cls(
            point,
            gradient,
            loss,
            kept,
            int(kept_round),
            int(last_round),
            lowest,
            [one.clone() for one in steps],
            [one.clone() for one in changes],
        )


def minimise(
    function: Function,
    start: Tensor,
    validate: Validate | None = None,
    advance: Callable[[int], None] = lambda rounds: None,
) -> tuple[Tensor, int, Stopped]:
    """Go downhill by limited-memory BFGS (Nocedal and Wright, Numerical Optimization, algorithm 7.5).

    A strictly convex function has one minimum, and what overfits is held off by its penalty. So stopping early is not
    a choice among solutions: it halts on the way to the only one, where samples held back say that going on does
    harm. They are few, a handful for a small cluster, and the first rounds wander. A round therefore counts as worse
    only if its losses are higher, sample by sample, than those of the best round by more than twice the standard
    error; any other later round is kept. Keeping the round of lowest loss instead lost one true place in a hundred
    from the candidates of Gardens Point's day_right.

    Any step along which the function falls will do, because with convexity every step meets positive curvature.

    Parameters
    ----------
    function : callable
        Strictly convex, except along directions in which it is constant.
    start : Tensor
        Where to begin, float32.
    validate : callable, optional
        Returns the validation losses at a point. The last round that is not worse than the best one is kept, and
        after ``PATIENCE`` worse ones in a row the search ends. Without it, the last point is kept.
    advance : callable
        Told of every round.

    Returns
    -------
    point : Tensor
        Of the shape of ``start``.
    rounds : int
        How many led to it.
    stopped : str
        Why no more followed.
    """
    stored = load_checkpoint("minimise")
    if stored is None:
        loss, gradient = function(start)
        state = _State(start, gradient, loss, kept=start)
    else:
        state = _State.of(stored)
    advance(state.round)
    stopped, saved = None, time.monotonic()
    while stopped is None:
        stopped = _round(state, function, validate)
        advance(1)
        if stopped is None and time.monotonic() - saved >= _SAVE_EVERY:
            save_checkpoint("minimise", state.arrays())
            saved = time.monotonic()
    return state.kept, state.kept_round, stopped


def _round(state: _State, function: Function, validate: Validate | None) -> Stopped | None:
    """Take one step and judge it; say whether it was the last one."""
    if state.round >= LIMIT:
        return "limit"
    if state.round - state.kept_round >= PATIENCE:
        return "validation"
    before = state.loss
    if not _descend(state, function):
        return "converged"
    state.round += 1
    losses = validate(state.point) if validate is not None else torch.empty(0)
    if not _worse(losses, state.lowest):
        state.kept, state.kept_round = state.point, state.round
    if not len(state.lowest) or losses.sum() < state.lowest.sum():
        state.lowest = losses
    return "converged" if before - state.loss <= _CONVERGED * abs(state.loss) else None


def _worse(losses: Tensor, lowest: Tensor) -> bool:
    """Tell whether (n,) losses are higher than others of the same samples by more than chance explains."""
    if len(lowest) < 2:  # nothing to compare with, or nothing to tell chance by
        return False
    rise = losses - lowest
    error = float(rise.std()) / math.sqrt(len(rise))
    return float(rise.mean()) > _DEVIATIONS * error


def _descend(state: _State, function: Function) -> bool:
    """Halve the step until the function falls; tell whether it does."""
    direction = _direction(state)
    slope = float((state.gradient * direction).sum())
    length = 1.0
    while length > _SHORTEST and slope > 0:
        point = state.point - length * direction
        loss, gradient = function(point)
        if loss < state.loss - _SUFFICIENT * length * slope:
            state.steps = [*state.steps, point - state.point][-_HISTORY:]
            state.changes = [*state.changes, gradient - state.gradient][-_HISTORY:]
            state.point, state.gradient, state.loss = point, gradient, loss
            return True
        length /= 2
    return False


def _direction(state: _State) -> Tensor:
    """Multiply the gradient by what past steps tell of the inverse Hessian (algorithm 7.4)."""
    direction = state.gradient.clone()
    if not state.steps:  # nothing is known: a step of unit length
        return direction / max(float(direction.norm()), 1e-12)
    past = [(s, y, 1 / float((s * y).sum())) for s, y in zip(state.steps, state.changes, strict=True)]
    factors = []
    for s, y, inverse in reversed(past):
        factors.append(inverse * float((s * direction).sum()))
        direction -= factors[-1] * y
    s, y, inverse = past[-1]
    direction /= inverse * float((y * y).sum())
    for (s, y, inverse), factor in zip(past, reversed(factors), strict=True):
        direction += (factor - inverse * float((y * direction).sum())) * s
    return direction
