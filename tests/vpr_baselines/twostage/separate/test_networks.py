import gc

import numpy as np
import pytest
from safetensors.numpy import load_file, save_file

from vpr_baselines.backbones.trunk import Trunk
from vpr_baselines.twostage.separate.networks import SeparateNetworks
from vpr_baselines.twostage.separate.training import train_separate
from vpr_bench.errors import DataError
from vpr_bench.types.clusters import Clusters


@pytest.fixture
def passes(monkeypatch):
    """Return a list that grows with every image that passes through a network."""
    counted = []
    respond = Trunk.respond
    monkeypatch.setattr(Trunk, "respond", lambda self, image: counted.append(self.network) or respond(self, image))
    return counted


@pytest.mark.parametrize("finetune", [False, True])
@pytest.mark.parametrize("triggered", [[0], [2, 1], [1, 0, 2]])
def test_a_query_passes_through_a_whole_network_for_every_part(frozen, tuned, walk, passes, finetune, triggered):
    networks = (tuned if finetune else frozen).networks
    networks.stage_one(walk[0])
    networks.answers(walk[0], np.array(triggered), 3)
    assert len(passes) == 1 + len(triggered)
    if finetune:
        assert len(set(map(id, passes))) == len(passes)


def test_stage_one_ranks_clusters_and_components_rank_their_members(frozen, walk, clusters):
    networks = frozen.networks
    assert networks.stage_one(walk[3]).shape == (3,)
    assert [networks.component(one, walk[3]).shape for one in range(3)] == [(4,), (2,), (1,)]
    assert networks.clusters is clusters


@pytest.mark.parametrize("kind", ["frozen", "tuned"])
def test_originals_are_recognised_through_both_stages(kind, request, walk, clusters):
    networks = request.getfixturevalue(kind).networks
    for reference, image in enumerate(walk):
        cluster = clusters.labels[reference]
        assert networks.stage_one(image).argmax() == cluster
        answers = networks.answers(image, np.array([cluster]), 1)
        assert answers.references.tolist() == [reference] and answers.components.tolist() == [cluster]


@pytest.mark.parametrize("kind", ["frozen", "tuned"])
def test_the_pass_through_stage_one_describes_too(kind, request, walk):
    trained = request.getfixturevalue(kind)
    descriptor = trained.networks.describe(walk[2])
    assert np.allclose(descriptor, trained.descriptors[2], rtol=1e-4)
    assert np.array_equal(trained.networks.rank(descriptor), trained.networks.stage_one(walk[2]))


@pytest.mark.parametrize("kind", ["frozen", "tuned"])
def test_what_is_saved_answers_as_before(kind, request, walk, clusters, body, tmp_path):
    networks = request.getfixturevalue(kind).networks
    networks.save(tmp_path)
    loaded = SeparateNetworks.load(tmp_path, clusters, body, finetune=kind == "tuned")
    for image in walk:
        assert np.array_equal(loaded.stage_one(image), networks.stage_one(image))
        for component in range(3):
            assert np.array_equal(loaded.component(component, image), networks.component(component, image))


def test_frozen_networks_are_not_stored_with_the_map(frozen, tuned, tmp_path):
    (tmp_path / "tuned").mkdir()
    frozen.networks.save(tmp_path)
    assert sum(file.stat().st_size for file in tmp_path.rglob("*") if file.is_file()) < 100_000
    tuned.networks.save(tmp_path / "tuned")
    stored = sorted(file.name for file in (tmp_path / "tuned" / "networks").iterdir())
    # The component of a single image has learnt nothing.
    assert stored == ["component-00000.safetensors", "component-00001.safetensors", "stage-one.safetensors"]


def test_networks_are_read_when_they_are_run_and_few_stay_in_memory(tuned, clusters, body, walk, tmp_path, monkeypatch):
    tuned.networks.save(tmp_path)
    monkeypatch.setattr("vpr_baselines.twostage.separate.tuned._HELD", 1)
    loaded = SeparateNetworks.load(tmp_path, clusters, body, finetune=True)
    assert not loaded.tuned._held
    for component in (0, 1, 0):
        expected = tuned.networks.component(component, walk[0])
        assert np.array_equal(loaded.component(component, walk[0]), expected)
        assert list(loaded.tuned._held) == [component]


def test_tuned_networks_vanish_with_the_object(walk, clusters, body):
    trained = train_separate(walk[:2], Clusters([0, 1]), body, penalty=10.0, seed=0, finetune=True, epochs=1)
    folder = trained.networks.tuned.folder
    assert folder.is_dir()
    del trained
    gc.collect()
    assert not folder.exists()


def test_a_network_that_is_missing_or_damaged_is_a_data_error(tuned, clusters, body, walk, tmp_path):
    tuned.networks.save(tmp_path)
    files = sorted((tmp_path / "networks").iterdir())
    files[0].write_bytes(files[0].read_bytes()[:1000])
    files[2].unlink()
    loaded = SeparateNetworks.load(tmp_path, clusters, body, finetune=True)
    with pytest.raises(DataError, match=r"component-00000\.safetensors is damaged"):
        loaded.component(0, walk[0])
    with pytest.raises(DataError, match=r"stage-one\.safetensors is missing"):
        loaded.stage_one(walk[0])


def test_last_layers_that_are_missing_or_damaged_are_a_data_error(frozen, clusters, body, tmp_path):
    with pytest.raises(DataError, match="fit the map again"):
        SeparateNetworks.load(tmp_path, clusters, body, finetune=False)
    frozen.networks.save(tmp_path)
    file = tmp_path / "heads.safetensors"
    file.write_bytes(file.read_bytes()[:-10])
    with pytest.raises(DataError, match="damaged"):
        SeparateNetworks.load(tmp_path, clusters, body, finetune=False)


@pytest.mark.parametrize(
    "change",
    [
        {"stage_one.weight": None},
        {"stage_one.bias": np.zeros(4, np.float32)},
        {"components.weight": np.zeros((7, 32), np.float64)},
        {"components.weight": np.full((7, 32), np.nan, np.float32)},
        {"components.weight": np.zeros((7, 5), np.float32)},
        {"components.weight": np.zeros(7, np.float32)},
    ],
    ids=["missing", "classes", "type", "nan", "width", "flat"],
)
def test_last_layers_of_another_map_are_a_data_error(frozen, clusters, body, tmp_path, change):
    frozen.networks.save(tmp_path)
    arrays = {**load_file(tmp_path / "heads.safetensors"), **change}
    save_file({name: array for name, array in arrays.items() if array is not None}, tmp_path / "heads.safetensors")
    with pytest.raises(DataError, match=r"heads\.safetensors is damaged"):
        SeparateNetworks.load(tmp_path, clusters, body, finetune=False)


def test_last_layers_of_other_clusters_are_a_data_error(frozen, body, tmp_path):
    frozen.networks.save(tmp_path)
    with pytest.raises(DataError, match="is no layer of 2 classes"):
        SeparateNetworks.load(tmp_path, Clusters([0, 1, 0, 0, 1, 0, 0]), body, finetune=False)


def test_last_layers_of_another_network_are_a_data_error(frozen, clusters, tmp_path):
    from vpr_baselines.twostage.separate.body import load_body

    frozen.networks.save(tmp_path)
    loaded = SeparateNetworks.load(
        tmp_path, clusters, load_body("efficientnet-lite0", "random", width=32, height=32), finetune=False
    )
    with pytest.raises(DataError, match="another network: 1280 inputs in place of 32"):
        loaded.stage_one(np.zeros((9, 9, 3), np.uint8))
