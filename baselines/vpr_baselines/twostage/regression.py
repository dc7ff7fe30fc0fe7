"""Multinomial logistic regression, the convex problem that training a last layer is."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor
from torch.nn import functional

from vpr_baselines.twostage.heads import LinearHead
from vpr_baselines.twostage.lbfgs import minimise
from vpr_baselines.twostage.report import Stopped

_BATCH = 1 << 24  # numbers of one intermediate result
_LARGE = 1 << 31  # multiplications per round, from which on a second processor core is worth waiting for


@dataclass(frozen=True, eq=False)
class Samples:
    """Some rows of a matrix of descriptors, with their classes.

    Attributes
    ----------
    descriptors : (N, D) float
        Of any precision, also memory-mapped: only the rows asked for are copied, a batch at a time.
    rows : (n,) int64
        Which of them.
    labels : (n,) int64
        The class of each row.
    """

    descriptors: NDArray[np.floating]
    rows: NDArray[np.int64]
    labels: NDArray[np.int64]

    def __len__(self) -> int:
        """Return the number of samples."""
        return len(self.rows)

    def batch(self, part: slice) -> Tensor:
        """Read some of the samples: (b, D) float32."""
        # Copied: on the alignment of NumPy's memory the last bits of products would depend.
        return torch.tensor(self.descriptors[self.rows[part]], dtype=torch.float32)


def balanced(labels: NDArray[np.int64], classes: int) -> NDArray[np.float32]:
    """Weigh the samples so that all classes count alike and the weights sum to the number of samples.

    Parameters
    ----------
    labels : (n,) int64
        In [0, classes).
    classes : int
        Number of classes.

    Returns
    -------
    (classes,) float32
        Weight of a sample of each class; 0 for a class without any.
    """
    counts = np.bincount(labels, minlength=classes)
    return np.asarray(np.divide(len(labels) / classes, counts, where=counts > 0, out=np.zeros(classes)), np.float32)


def train_head(
    training: Samples,
    classes: int,
    penalty: float,
    validation: Samples | None = None,
    advance: Callable[[int], None] = lambda rounds: None,
) -> tuple[LinearHead, int, Stopped]:
    """Fit a linear layer by its cross entropy, every class of the same weight, and an L2 penalty.

    Parameters
    ----------
    training : Samples
        Descriptors of about unit length, each class at least once.
    classes : int
        With a single class there is nothing to learn and all logits are 0.
    penalty : float
        Inverse strength of the L2 penalty on the weights, scikit-learn's ``C``.
    validation : Samples, optional
        Samples held back, for early stopping: see :func:`~vpr_baselines.twostage.lbfgs.minimise`.
    advance : callable
        Told of every round.

    Returns
    -------
    head : LinearHead
    rounds : int
        How many led to it.
    stopped : str
        Why no more followed.
    """
    dimensions = training.descriptors.shape[1]
    if classes == 1:
        return LinearHead(np.zeros((1, dimensions), np.float32), np.zeros(1, np.float32)), 0, "nothing to learn"
    weights = torch.from_numpy(balanced(training.labels, classes))
    learning, judging = (
        _Loss(samples, classes, weights) if samples is not None and len(samples) else None
        for samples in (training, validation)
    )
    assert learning is not None, "there are classes and no samples"  # noqa: S101

    def function(point: Tensor) -> tuple[float, Tensor]:
        loss, gradient = learning.with_gradient(point)
        gradient[:, :-1] += point[:, :-1] / penalty
        return loss + float(point[:, :-1].double().square().sum()) / (2 * penalty), gradient

    start = torch.zeros(classes, dimensions + 1)  # the last column is the bias
    with _threads(len(training) * start.numel()):
        point, rounds, stopped = minimise(function, start, judging.of_each if judging else None, advance)
    return LinearHead(point[:, :-1].contiguous().numpy(), point[:, -1].contiguous().numpy()), rounds, stopped


@contextmanager
def _threads(work: int) -> Iterator[None]:
    """Let one thread do what is quickly done: beside a busy process, several lose ten times what they gain."""
    before = torch.get_num_threads()
    torch.set_num_threads(before if work >= _LARGE else 1)
    try:
        yield
    finally:
        torch.set_num_threads(before)


class _Loss:
    """The weighted cross entropy of samples, summed, as a function of weights and biases (classes, D + 1)."""

    def __init__(self, samples: Samples, classes: int, weights: Tensor) -> None:
        self.samples = samples
        self.labels = torch.from_numpy(samples.labels)
        self.weights = weights[self.labels]
        rows = max(_BATCH // max(classes, samples.descriptors.shape[1]), 1)
        self.parts = [slice(first, first + rows) for first in range(0, len(samples), rows)]
        # A large set is read again for each round: beside the products with it, that costs little.
        self.whole = samples.batch(self.parts[0]) if len(self.parts) == 1 else None

    def of_each(self, point: Tensor) -> Tensor:
        """Return the (n,) losses sample by sample."""
        return torch.cat(
            [
                functional.cross_entropy(logits, labels, reduction="none").mul_(weights)
                for _, logits, labels, weights in self._batches(point)
            ]
        )

    def with_gradient(self, point: Tensor) -> tuple[float, Tensor]:
        gradient, loss = torch.zeros_like(point), 0.0
        for descriptors, logits, labels, weights in self._batches(point):
            logs = functional.log_softmax(logits, dim=1)
            own = labels[:, None]
            loss -= float(logs.gather(1, own)[:, 0].mul(weights).double().sum())
            excess = logs.exp_().scatter_add_(1, own, torch.full(own.shape, -1.0)).mul_(weights[:, None])
            gradient[:, :-1] += excess.T @ descriptors
            gradient[:, -1] += excess.sum(dim=0)
        return loss, gradient

    def _batches(self, point: Tensor) -> Iterator[tuple[Tensor, Tensor, Tensor, Tensor]]:
        for part in self.parts:
            descriptors = self.samples.batch(part) if self.whole is None else self.whole
            yield (
                descriptors,
                torch.addmm(point[:, -1], descriptors, point[:, :-1].T),
                self.labels[part],
                self.weights[part],
            )
