"""How far new answers may fall behind those of the baseline."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from numbers import Real

from pydantic import BaseModel, ConfigDict, Field

from vpr_bench.errors import UsageError
from vpr_bench.metrics.definitions import lookup

ALLOWED = (
    'Rules hold "exact" (true or false), "latency_ratio" (above 0), and "metrics", each with a "tolerance" (0 to 1), '
    'a "significance" (0 to less than 1), or both.'
)
"""What may stand in a file, for those who edit it."""


class Rule(BaseModel):
    """What is allowed to one metric; failing either part fails.

    Attributes
    ----------
    tolerance : float or None
        Largest absolute drop that passes, in [0, 1]; None: drops are not measured.
    significance : float or None
        A drop fails if chance alone would do it less often than this, in [0, 1); None or 0: not tested.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    tolerance: float | None = Field(None, ge=0, le=1, allow_inf_nan=False)
    significance: float | None = Field(None, ge=0, lt=1, allow_inf_nan=False)

    def over(self, other: "Rule") -> "Rule":
        """Return the other rule with what this one says in place of it."""
        return other.model_copy(update=self.model_dump(exclude_none=True))


class Rules(BaseModel):
    """What is allowed to a cell, or to all of them.

    Attributes
    ----------
    exact : bool or None
        Any query whose best answer is another reference fails; None is no.
    latency_ratio : float or None
        How many times as long the median query may take, on the same machine; None: times never fail.
    metrics : dict
        Metric id to its rule; the metrics that are judged.

    Examples
    --------
    >>> Rules(metrics={"pr_auc": Rule(tolerance=0.1)}).over(FRESH).metrics["pr_auc"]
    Rule(tolerance=0.1, significance=0.05)
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    exact: bool | None = None
    latency_ratio: float | None = Field(None, gt=0, allow_inf_nan=False)
    metrics: dict[str, Rule] = {}

    def over(self, other: "Rules") -> "Rules":
        """Return the other rules with what these say in place of them."""
        metrics = {name: rule.over(other.metrics.get(name, Rule())) for name, rule in self.metrics.items()}
        return Rules(
            exact=other.exact if self.exact is None else self.exact,
            latency_ratio=other.latency_ratio if self.latency_ratio is None else self.latency_ratio,
            metrics=other.metrics | metrics,
        )

    def check(self) -> None:
        """Refuse rules that cannot be followed.

        Raises
        ------
        UsageError
            If a metric does not exist, or cannot be had from the best answers alone.
        """
        for name in self.metrics:
            if lookup(name).function is None:
                raise UsageError(f"The gate cannot judge {name}: a baseline does not hold the scores of all pairs.")

    @property
    def empty(self) -> bool:
        """Whether nothing can fail by them."""
        bounds = (bound for rule in self.metrics.values() for bound in (rule.tolerance, rule.significance or None))
        return not self.exact and self.latency_ratio is None and all(bound is None for bound in bounds)


FRESH = Rules(
    metrics={
        "pr_auc": Rule(tolerance=0.02, significance=0.05),
        "recall@1": Rule(tolerance=0.02, significance=0.05),
    }
)
"""The rules of a new baseline."""


@dataclass(frozen=True)
class Overrides:
    """What somebody wants instead of the rules of the file, for one call.

    Attributes
    ----------
    tolerance : mapping
        Metric id to the largest drop; a metric that was not judged is from now on.
    significance : float or None
        For every metric that is judged.
    exact : bool or None
        As in :class:`Rules`.
    latency_ratio : float or None
        As in :class:`Rules`.
    """

    tolerance: Mapping[str, float] = field(default_factory=dict)
    significance: float | None = None
    exact: bool | None = None
    latency_ratio: float | None = None

    def apply(self, rules: Rules) -> Rules:
        """Return the rules with these in place of theirs.

        Raises
        ------
        UsageError
            If a number is out of range, or a metric cannot be judged.
        """
        self._check()
        named = Rules(
            exact=self.exact,
            latency_ratio=self.latency_ratio,
            metrics={name: Rule(tolerance=value) for name, value in self.tolerance.items()},
        )
        merged = named.over(rules)
        if self.significance is not None:
            alpha = Rule(significance=self.significance)
            merged = Rules(metrics=dict.fromkeys(merged.metrics, alpha)).over(merged)
        merged.check()
        return merged

    def _check(self) -> None:
        self._check_types()
        for name, value in self.tolerance.items():
            if not 0 <= value <= 1:
                raise UsageError(f"The tolerance of {name} must lie between 0 and 1. Got {value:g} instead.")
        if self.significance is not None and not 0 <= self.significance < 1:
            raise UsageError(f"The significance must be at least 0 and below 1. Got {self.significance:g} instead.")
        if self.latency_ratio is not None and not 0 < self.latency_ratio < float("inf"):
            raise UsageError(f"The latency ratio must be positive. Got {self.latency_ratio:g} instead.")

    def _check_types(self) -> None:
        """Refuse what tests may pass, whose types nobody checks."""
        drops = self.tolerance.items() if isinstance(self.tolerance, Mapping) else [(None, None)]
        if not all(isinstance(name, str) and _is_number(drop) for name, drop in drops):
            raise UsageError(
                f"tolerance is {{metric: drop}}, such as {{'recall@1': 0.02}}. Got {self.tolerance!r:.200} instead."
            )
        for name, value in (("significance", self.significance), ("latency_ratio", self.latency_ratio)):
            if value is not None and not _is_number(value):
                raise UsageError(f"{name} is a number. Got {value!r:.200} instead.")
        if not isinstance(self.exact, bool | None):
            raise UsageError(f"exact is True or False. Got {self.exact!r:.200} instead.")


def _is_number(value: object) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)
