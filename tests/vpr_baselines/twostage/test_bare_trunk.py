import dataclasses

import numpy as np
import pytest

from vpr_baselines.backbones import trunk
from vpr_baselines.twostage import bare_trunk
from vpr_baselines.twostage.bare_trunk import BareTrunk
from vpr_baselines.twostage.method import TwoStage
from vpr_bench.method.build import build_method
from vpr_bench.timing import collect_stages
from vpr_bench.types.traverse import Traverse

SMALL = {"width": 96, "height": 64}


@pytest.fixture
def walk():
    return Traverse("map", list(np.random.default_rng(0).integers(0, 256, (6, 48, 64, 3), dtype=np.uint8)))


@pytest.fixture
def seen(monkeypatch):
    """Collect what goes through the network, and which layers are asked for."""
    passed = []
    respond = trunk.respond

    def watch(network, images, names):
        passed.append((network, images.numpy().copy(), tuple(names)))
        return respond(network, images, names)

    for module in (trunk, bare_trunk):
        monkeypatch.setattr(module, "respond", watch)
    return passed


def test_its_defaults_are_those_of_twostage():
    theirs = {one.name: one.default for one in dataclasses.fields(TwoStage)}
    mine = {one.name: one.default for one in dataclasses.fields(BareTrunk) if one.name != "prepare"}
    assert mine == {name: theirs[name] for name in mine}
    assert build_method("vpr_baselines.twostage.bare_trunk:BareTrunk").weights == TwoStage().weights_digest()


def test_it_does_with_a_query_what_twostage_does_up_to_the_last_layer(walk, seen):
    bare, whole = BareTrunk(**SMALL), TwoStage(**SMALL, dimensions=16, n_clusters=2, rerank="cosine")
    bare.fit(walk)
    whole.fit(walk)
    seen.clear()
    for method in (bare, whole):
        method.match(walk[3], 2)
    (network, images, layers), (its_network, its_images, its_layers) = seen
    assert network is its_network and layers == its_layers
    assert np.array_equal(images, its_images)


def test_without_preparation_the_same_input_goes_through_again(walk, seen):
    bare = BareTrunk(**SMALL, prepare=False)
    bare.fit(walk)
    for image in walk[1:3]:
        bare.match(image, 2)
    assert np.array_equal(seen[0][1], seen[1][1])


def test_it_answers_with_the_first_references_and_notes_its_one_stage(walk):
    bare = BareTrunk(**SMALL)
    bare.fit(walk)
    with collect_stages() as seconds:
        assert bare.match(walk[5], 4).indices.tolist() == [0, 1, 2, 3]
    assert list(seconds) == ["encode"]
    assert len(bare.match(walk[5], 9)) == 6
