import pytest

from vpr_baselines import weights
from vpr_baselines.backbones.architectures import ARCHITECTURES
from vpr_bench.weights.card import WEIGHTS, find_weights_card
from vpr_bench.weights.digest import weights_digest

OURS = [entry.name for entry in WEIGHTS.entries() if entry.target.startswith("vpr_baselines.")]


def test_there_are_weights_for_every_network():
    assert {find_weights_card(name).architecture for name in OURS} == ARCHITECTURES.keys()
    assert {f"{one}-imagenet" for one in ARCHITECTURES} < set(OURS)


@pytest.mark.parametrize("name", OURS)
def test_a_card_agrees_with_its_network(name):
    card = find_weights_card(name)
    network = ARCHITECTURES[card.architecture]
    assert (card.mean, card.std) == (network.mean, network.std)
    if card.sha256_prefix:  # as torchvision names its files
        assert card.file.removesuffix(".pth").endswith(card.sha256_prefix)
    if card.url:
        assert card.url.endswith(f"/{card.file}")


def test_the_weights_that_come_with_the_installation_are_the_right_ones():
    assert weights_digest(find_weights_card("efficientnet-lite0-imagenet")).startswith("sha256:57934424")


def test_there_is_no_card_of_what_nobody_wrote_one_for():
    with pytest.raises(AttributeError, match="there is no card 'vgg16'"):
        weights.vgg16  # noqa: B018
