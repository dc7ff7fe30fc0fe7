"""Linear classifiers on descriptors: the last layer, which is all that learns."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression


@dataclass(frozen=True, eq=False)
class LinearHead:
    """One linear layer.

    Attributes
    ----------
    weight : (classes, D) float32
    bias : (classes,) float32
    """

    weight: NDArray[np.float32]
    bias: NDArray[np.float32]

    def logits(self, descriptor: NDArray[np.float32]) -> NDArray[np.float32]:
        """Score a (D,) descriptor: (classes,) float32."""
        return self.weight @ descriptor + self.bias


def train_head(descriptors: NDArray[np.float32], labels: NDArray[np.int64], classes: int, penalty: float) -> LinearHead:
    """Fit multinomial logistic regression, the convex problem that training a last layer is.

    Parameters
    ----------
    descriptors : (n, D) float32
        Unit length.
    labels : (n,) int64
        In [0, classes), each at least once.
    classes : int
        With a single class there is nothing to learn and all logits are 0.
    penalty : float
        Inverse strength of the L2 penalty, scikit-learn's ``C``.
    """
    if classes == 1:
        return LinearHead(np.zeros((1, descriptors.shape[1]), np.float32), np.zeros(1, np.float32))
    model = LogisticRegression(C=penalty, max_iter=300).fit(descriptors, labels)
    weight, bias = model.coef_, model.intercept_
    if classes == 2:  # scikit-learn keeps one row for two classes: the difference of theirs
        weight, bias = np.vstack([-weight, weight]) / 2, np.concatenate([-bias, bias]) / 2
    return LinearHead(np.ascontiguousarray(weight, dtype=np.float32), bias.astype(np.float32))
