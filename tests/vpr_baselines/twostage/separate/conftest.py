"""What the tests of whole networks share: a small network of random weights, a tiny walk in three clusters."""

from collections.abc import Iterator

import pytest
import torch

from vpr_baselines.backbones import resnet18
from vpr_baselines.backbones.layers import Layer
from vpr_baselines.backbones.trunk import Trunk
from vpr_baselines.twostage.separate.body import Body
from vpr_baselines.twostage.separate.training import Trained, train_separate
from vpr_bench.dataset.load import load_traverse
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

PLACES = 7


@pytest.fixture(scope="session")
def walk(tiny_card, tiny_images) -> Traverse:
    """Return seven places."""
    traverse = next(one for one in tiny_card.traverses if one.name == "day_left")
    return load_traverse(tiny_card, traverse, tiny_images).traverse[:PLACES]


@pytest.fixture(scope="session")
def clusters() -> Clusters:
    """Return clusters of four, two and one of them, one behind the other."""
    return Clusters([0, 1, 0, 0, 1, 0, 2])


class Small(torch.nn.Module):
    """Two convolutions, stored in no time, and a head that nobody asks, as real ones have."""

    def __init__(self) -> None:
        super().__init__()
        self.conv1 = torch.nn.Conv2d(3, 16, 5, stride=2)
        self.conv2 = torch.nn.Conv2d(16, 32, 3, stride=2)
        self.fc = torch.nn.Linear(32, 1)

    def layers(self) -> Iterator[Layer]:
        yield "conv1", lambda x: torch.relu(self.conv1(x))
        yield "conv2", lambda x: torch.relu(self.conv2(x))


@pytest.fixture(scope="session")
def body() -> Body:
    """Return a network of random weights on small inputs."""
    with torch.random.fork_rng():
        torch.manual_seed(0)
        network = Small().eval().requires_grad_(False)
    return Body(Trunk(network, 48, 32, resnet18.MEAN, resnet18.STD, "none", ("conv2",)))


@pytest.fixture(scope="session")
def frozen(walk, clusters, body) -> Trained:
    """Return networks of which the last layers were trained."""
    return train_separate(walk, clusters, body, penalty=10.0, seed=0)


@pytest.fixture(scope="session")
def tuned(walk, clusters, body) -> Trained:
    """Return networks that were trained as a whole, for two epochs."""
    return train_separate(walk, clusters, body, penalty=10.0, seed=0, finetune=True, epochs=2)
