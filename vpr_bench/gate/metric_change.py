"""One metric then and now, and whether its rule allows that."""

import math
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vpr_bench.gate.rules import Rule
from vpr_bench.metrics.answers import Answers
from vpr_bench.metrics.bootstrap import bootstrap_difference
from vpr_bench.metrics.definitions import compute
from vpr_bench.metrics.mcnemar import mcnemar
from vpr_bench.metrics.undefined import or_none

RESAMPLES = 2000
"""Of the paired bootstrap."""

_ROUNDING = 1e-12


@dataclass(frozen=True)
class MetricChange:
    """What became of one metric.

    Attributes
    ----------
    metric : str
        Its id.
    before, after : float
        In the baseline, and now; NaN where undefined.
    rule : Rule
        What is allowed.
    p_value : float or None
        Of McNemar's exact test, or of the paired bootstrap; None where nothing was tested.
    interval : (float, float) or None
        Of the difference, by the paired bootstrap, at the rule's significance; None where it was not computed.
    faults : tuple of str
        Why it is not allowed; empty if it is.
    """

    metric: str
    before: float
    after: float
    rule: Rule
    p_value: float | None = None
    interval: tuple[float, float] | None = None
    faults: tuple[str, ...] = ()

    @property
    def difference(self) -> float:
        """Now minus then; NaN if either is undefined."""
        return self.after - self.before

    def as_dict(self) -> dict[str, Any]:
        """Return everything JSON-able, NaN as None."""
        values = {"before": self.before, "after": self.after, "difference": self.difference}
        return {
            **{name: or_none(value) for name, value in values.items()},
            **self.rule.model_dump(),
            "p_value": self.p_value,
            "interval": None if self.interval is None else list(self.interval),
            "faults": list(self.faults),
        }


def metric_change(metric: str, rule: Rule, before: Answers, after: Answers) -> MetricChange:
    """Compare one metric of two runs on the same queries.

    Significance is tested only where the metric fell: by McNemar's exact test for shares of queries (``recall@K`` and
    ``accuracy``), by the paired bootstrap for all others, whose p-value is never below 2 / (``RESAMPLES`` + 1).

    Parameters
    ----------
    metric : str
        A metric's id.
    rule : Rule
        What is allowed.
    before, after : Answers
        To the same queries, under the same policy.
    """
    old, new = (compute([metric], answers)[metric] for answers in (before, after))
    if math.isnan(new) and not math.isnan(old):
        return MetricChange(metric, old, new, rule, faults=(f"{metric} was {old:.3f} and is undefined now",))
    if fault := _too_deep(metric, before):
        return MetricChange(metric, old, new, rule, faults=(fault,))
    if not old - new > _ROUNDING:
        return MetricChange(metric, old, new, rule)
    too_far = rule.tolerance is not None and old - new > rule.tolerance + _ROUNDING
    faults = [f"only {rule.tolerance:g} is allowed"] if too_far else []
    p_value, interval = None, None
    if rule.significance:
        p_value, interval = _test(metric, before, after, rule.significance)
        if p_value <= rule.significance:
            test = "McNemar's exact test"
            if interval is not None:
                test = f"{interval[0]:.3f} to {interval[1]:.3f}, paired bootstrap"
            faults.append(f"significant at {rule.significance:g} (p = {p_value:.2g}, {test})")
    told = (f"{metric} fell by {old - new:.3f} ({old:.3f} → {new:.3f}): {', '.join(faults)}",) if faults else ()
    return MetricChange(metric, old, new, rule, p_value, interval, told)


def _too_deep(metric: str, answers: Answers) -> str | None:
    """Say that a metric needs answers that nobody kept, so that it could never fall."""
    recall = re.fullmatch(r"recall@([0-9]+)", metric)
    if recall is None or int(recall[1]) <= answers.depth:
        return None
    return f"{metric} is undefined: it needs more answers than the {answers.depth} that were kept (--k)"


def _test(
    metric: str, before: Answers, after: Answers, significance: float
) -> tuple[float, tuple[float, float] | None]:
    """Return the p-value of McNemar's test for a share of queries, else the bootstrap's with the interval."""
    old, new = _well(metric, before), _well(metric, after)
    if old is not None and new is not None:
        return mcnemar(old, new).p_value, None
    found = bootstrap_difference(after, before, [metric], RESAMPLES, confidence=1 - significance)[metric]
    return found.p_value, (found.low, found.high)


def _well(metric: str, answers: Answers) -> NDArray[np.bool_] | None:
    """(n,) bool: which queries count for a metric that is a share of queries, None for another one."""
    if recall := re.fullmatch(r"recall@([0-9]+)", metric):
        return answers.expected & (answers.rank < int(recall[1]))
    if metric == "accuracy":
        rejected = ~(answers.has_match | answers.answered)
        return answers.correct | rejected if answers.unmatched == "reject" else answers.correct
    return None
