import pytest
from pydantic import ValidationError

from vpr_bench.errors import UsageError
from vpr_bench.gate.rules import FRESH, Overrides, Rule, Rules


def test_a_cells_own_rules_win_part_by_part():
    own = Rules(exact=True, metrics={"pr_auc": Rule(tolerance=0.1), "recall@5": Rule(significance=0.01)})
    merged = own.over(FRESH)
    assert merged.exact is True
    assert merged.metrics["pr_auc"] == Rule(tolerance=0.1, significance=0.05)
    assert merged.metrics["recall@1"] == FRESH.metrics["recall@1"]
    assert merged.metrics["recall@5"] == Rule(significance=0.01)


def test_overrides_win_over_everything():
    merged = Overrides({"accuracy": 0.3, "pr_auc": 0.0}, 0.01, exact=True, latency_ratio=1.5).apply(FRESH)
    assert merged.metrics["accuracy"] == Rule(tolerance=0.3, significance=0.01)
    assert merged.metrics["pr_auc"] == Rule(tolerance=0.0, significance=0.01)
    assert merged.metrics["recall@1"] == Rule(tolerance=0.02, significance=0.01)
    assert (merged.exact, merged.latency_ratio) == (True, 1.5)


def test_no_overrides_change_nothing():
    assert Overrides().apply(FRESH) == FRESH


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (Overrides({"recall@1": -0.1}), "tolerance of recall@1 must lie between 0 and 1"),
        (Overrides({"recall@1": float("nan")}), "Got nan"),
        (Overrides({"recal@1": 0.1}), "There is no metric 'recal@1'. Did you mean 'recall@1'"),
        (Overrides({"pr_auc_pairs": 0.1}), "does not hold the scores of all pairs"),
        (Overrides(significance=1.0), "Got 1"),
        (Overrides(latency_ratio=0.0), "must be positive"),
        (Overrides(0.1), r"tolerance is \{metric: drop\}, such as \{'recall@1': 0.02\}\. Got 0.1"),
        (Overrides({"recall@1": "0.1"}), "tolerance is"),
        (Overrides({1: 0.1}), "tolerance is"),
        (Overrides({"recall@1": True}), "tolerance is"),
        (Overrides(significance="5 %"), "significance is a number. Got '5 %'"),
        (Overrides(latency_ratio=[2]), "latency_ratio is a number"),
        (Overrides(exact="yes"), "exact is True or False"),
    ],
)
def test_overrides_that_make_no_sense(overrides, said):
    with pytest.raises(UsageError, match=said):
        overrides.apply(FRESH)


@pytest.mark.parametrize("content", [{"tolerance": -1}, {"significance": 1.0}, {"tolerance": "0.1"}, {"tol": 0.1}])
def test_a_rule_out_of_range_is_refused(content):
    with pytest.raises(ValidationError):
        Rule.model_validate(content)


def test_rules_that_allow_everything_are_empty():
    assert Rules(metrics={"pr_auc": Rule(significance=0)}).empty
    assert not FRESH.empty
    assert not Rules(exact=True).empty
    assert not Rules(latency_ratio=2).empty
