import pytest
import torch
from torch import nn

from vpr_bench.errors import DataError
from vpr_bench.weights.fit import compare, fit_checkpoint


def network(classes=3):
    return nn.Sequential(nn.Conv2d(3, 4, 3), nn.BatchNorm2d(4), nn.Flatten(), nn.Linear(4, classes))


def test_what_fits_is_loaded():
    source, target = network(), network()
    assert str(fit_checkpoint(target, source.state_dict())) == "9 keys fit"
    assert all(torch.equal(target.state_dict()[key], value) for key, value in source.state_dict().items())


def test_what_does_not_fit_is_reported_and_nothing_is_changed():
    target = network()
    before = {key: value.clone() for key, value in target.state_dict().items()}
    state = network(5).state_dict()
    state["extra"] = state.pop("0.bias")
    with pytest.raises(DataError) as raised:
        fit_checkpoint(target, state, name="dots.pth")
    assert str(raised.value) == (
        "dots.pth does not fit Sequential: 6 keys fit; 1 missing (0.bias); 1 unexpected (extra); "
        "2 of another shape (3.weight: 5×4 for 3×4, 3.bias: 5 for 3)."
    )
    assert all(torch.equal(target.state_dict()[key], value) for key, value in before.items())


@pytest.mark.parametrize("number", [float("nan"), float("inf")])
def test_weights_that_are_no_numbers_are_refused_and_nothing_is_changed(number):
    layer = nn.Linear(2, 3)
    before = layer.weight.clone()
    state = {"weight": torch.zeros(3, 2), "bias": torch.tensor([0.0, number, 0.0])}
    with pytest.raises(DataError, match="is damaged: bias holds NaN or infinite numbers"):
        fit_checkpoint(layer, state)
    assert torch.equal(layer.weight, before)


def test_only_the_first_of_many_keys_are_named():
    fit = compare(network(), {})
    assert "8 missing (0.weight, 0.bias, 1.weight, 1.bias and 4 more)" in str(fit)


@pytest.mark.parametrize("cut", [None, "3.weight", "3.bias", "both"])
def test_the_head_may_differ_where_that_is_allowed(cut):
    target, state = network(), network(5).state_dict()
    before = target[3].weight.clone()
    for key in ("3.weight", "3.bias"):
        if cut in (key, "both"):
            del state[key]
    fit = fit_checkpoint(target, state, allow_head="3")
    assert set(fit.dropped) == {"3.weight", "3.bias"}
    assert torch.equal(target[3].weight, before) and torch.equal(target[0].weight, state["0.weight"])


def test_a_head_that_fits_is_loaded():
    source, target = network(), network()
    assert fit_checkpoint(target, source.state_dict(), allow_head="3").dropped == ()
    assert torch.equal(target[3].weight, source[3].weight)


def test_nothing_but_the_head_may_differ():
    with pytest.raises(DataError, match="does not fit"):
        fit_checkpoint(network(5), network().state_dict(), allow_head="0")


def test_batch_counts_may_be_missing():
    """They were not stored before torch 0.4.1, and only training needs them."""
    state = network().state_dict()
    del state["1.num_batches_tracked"]
    assert compare(network(), state).missing == ()
