"""What training came to, part by part: kept with the map."""

from collections.abc import Iterable
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, FiniteFloat, NonNegativeInt, PositiveInt

Stopped = Literal["converged", "validation", "limit", "nothing to learn"]
"""Why training ended: the loss falls no further; the validation loss has been higher for a while; there were too many
rounds; or there was but one class."""


class PartReport(BaseModel):
    """How one classifier was trained, and how well it does on samples that it has not seen."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    classes: PositiveInt
    training: NonNegativeInt = Field(description="samples learnt from")
    validation: NonNegativeInt = Field(description="samples that said when to stop")
    test: NonNegativeInt = Field(description="samples behind accuracy and average_precision")
    rounds: NonNegativeInt = Field(description="of the solver, or epochs, up to the weights that were kept")
    stopped: Stopped
    accuracy: FiniteFloat | None = Field(ge=0, le=1, description="on the test samples; none without any")
    average_precision: FiniteFloat | None = Field(
        ge=0, le=1, description="mean over the classes that occur among the test samples"
    )


class TrainingReport(BaseModel):
    """Reports of stage one and of every component of stage two, in the order of the clusters.

    Accuracy is on augmentations that were held back, not on images of other drives: it says whether training worked,
    not how well places are recognised.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    stage_one: PartReport
    components: tuple[PartReport, ...]

    @property
    def components_accuracy(self) -> float | None:
        """Accuracy over the test samples of all components; none without any."""
        return _mean((one.accuracy, one.test) for one in self.components)

    @property
    def components_average_precision(self) -> float | None:
        """Average precision of the components, each counted as often as it has test samples; none without any."""
        return _mean((one.average_precision, one.test) for one in self.components)


def accuracy_and_precision(
    logits: NDArray[np.float32], labels: NDArray[np.int64]
) -> tuple[float, float] | tuple[None, None]:
    """Measure a classifier.

    Parameters
    ----------
    logits : (n, classes) float32
        Of the test samples.
    labels : (n,) int64
        Their classes.

    Returns
    -------
    accuracy : float
        In [0, 1]. Both are None without samples.
    average_precision : float
        Of each class that occurs, all samples ranked by its probability; then the mean over classes.
    """
    if not len(labels):
        return None, None
    from sklearn.metrics import average_precision_score  # only training needs it, and loading it takes a second

    exponentials = np.exp(logits - logits.max(axis=1, keepdims=True))
    probabilities = exponentials / exponentials.sum(axis=1, keepdims=True)
    precisions = [average_precision_score(labels == one, probabilities[:, one]) for one in np.unique(labels)]
    return float((logits.argmax(axis=1) == labels).mean()), float(np.mean(precisions))


def _mean(values: Iterable[tuple[float | None, int]]) -> float | None:
    known = [(value, count) for value, count in values if value is not None]
    return sum(value * count for value, count in known) / sum(count for _, count in known) if known else None
