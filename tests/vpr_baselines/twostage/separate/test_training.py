import numpy as np
import pytest
import torch

from vpr_baselines.backbones.resnet18 import ResNet18
from vpr_baselines.twostage.separate import finetune as finetuning
from vpr_baselines.twostage.separate import training
from vpr_baselines.twostage.separate.body import Body, load_body
from vpr_baselines.twostage.separate.networks import SeparateNetworks
from vpr_baselines.twostage.separate.pictures import Pictures
from vpr_baselines.twostage.separate.training import train_separate
from vpr_bench.checkpoint import checkpoints
from vpr_bench.types.clusters import Clusters
from vpr_bench.types.traverse import Traverse

RECIPE = {"penalty": 10.0, "seed": 0}


def state(trained):
    """Collect everything that was learnt."""
    networks = trained.networks
    arrays = [networks.head.weight, networks.head.bias, networks.components.head.weight, networks.components.head.bias]
    if networks.tuned is not None:
        for part in (None, 0, 1):
            arrays += [value.numpy() for value in networks.tuned.of(part).trunk.network.state_dict().values()]
    return [*arrays, trained.descriptors]


def same(one, other):
    pairs = zip(state(one), state(other), strict=True)
    return one.report == other.report and all(np.array_equal(a, b) for a, b in pairs)


def test_frozen_networks_learn_what_their_descriptors_say(frozen, clusters):
    report = frozen.report
    assert (report.stage_one.classes, [one.classes for one in report.components]) == (3, [4, 2, 1])
    assert report.stage_one.accuracy > 0.5
    assert frozen.descriptors.shape == (7, 32)
    assert frozen.networks.head.weight.shape == (3, 32)


def test_tuned_networks_differ_from_each_other_and_the_given_one_stays(tuned, body):
    networks = [body.trunk.network, *(tuned.networks.tuned.of(part).trunk.network for part in (None, 0, 1))]
    first = [network.conv1.weight for network in networks]
    changed = [not torch.equal(first[0], weight) for weight in first[1:]]
    assert any(changed)
    reports = [tuned.report.stage_one, *tuned.report.components[:2]]
    assert changed == [report.rounds > 0 for report in reports]
    assert not body.trunk.network.conv1.weight.requires_grad and not first[1].requires_grad


def test_tuning_is_never_worse_on_the_validation_pictures(walk, clusters, body, frozen):
    everything = np.argwhere(np.ones((7, 6)))
    pictures = Pictures(walk, everything, clusters.labels[everything[:, 0]], 0)
    held_back = Pictures(walk, everything[::5], pictures.labels[::5], 0)
    head = frozen.networks.head
    found, layer, epochs, _ = finetuning.finetune(body, head, pictures, held_back, epochs=2, seed=(0,))
    losses = [
        finetuning._Run(one, other, pictures, held_back).validation_loss()
        for one, other in ((body, head), (found, layer))
    ]
    assert losses[1] <= losses[0] + 1e-5
    assert epochs == 0 or losses[1] < losses[0]


def test_without_augmentations_every_epoch_counts(walk, clusters, body):
    trained = train_separate(walk, clusters, body, **RECIPE, finetune=True, epochs=1, augment=False)
    assert trained.report.stage_one.rounds == 1 and trained.report.stage_one.stopped == "limit"
    assert trained.report.stage_one.accuracy is None


def test_the_seed_decides_and_nothing_else(walk, clusters, body, frozen, tuned):
    assert same(train_separate(walk, clusters, body, **RECIPE), frozen)
    torch.manual_seed(99)
    again = train_separate(walk, clusters, body, **RECIPE, finetune=True, epochs=2)
    assert same(again, tuned)
    assert not same(train_separate(walk, clusters, body, penalty=10.0, seed=1), frozen)


@pytest.mark.parametrize("labels", [[0, 0, 0], [0, 1, 2], [0, 1, 0]], ids=["one", "singles", "two"])
@pytest.mark.parametrize("finetune", [False, True])
def test_every_shape_of_clusters_can_be_trained(walk, body, labels, finetune, tmp_path):
    clusters = Clusters(labels)
    trained = train_separate(walk[:3], clusters, body, **RECIPE, finetune=finetune, epochs=1)
    trained.networks.save(tmp_path)
    loaded = SeparateNetworks.load(tmp_path, clusters, body, finetune=finetune)
    for networks in (trained.networks, loaded):
        assert networks.stage_one(walk[0]).shape == (len(clusters),)
        answers = networks.answers(walk[1], np.arange(len(clusters)), 3)
        assert sorted(answers.references.tolist()) == [0, 1, 2]


@pytest.mark.parametrize("level", [0, 255])
def test_identical_images_can_be_trained(body, level):
    still = Traverse("still", [np.full((30, 40, 3), level, np.uint8)] * 4)
    trained = train_separate(still, Clusters([0, 0, 1, 1]), body, **RECIPE, augment=False)
    assert np.isfinite(trained.networks.stage_one(still[0])).all()


class StoppedHereError(Exception):
    pass


def after(calls, function):
    left = [calls]

    def call(*args, **kwargs):
        left[0] -= 1
        if left[0] < 0:
            raise StoppedHereError
        return function(*args, **kwargs)

    return call


@pytest.mark.parametrize(
    ("owner", "name", "calls"),
    [
        (Body, "respond", 3),  # describing references
        (finetuning._Run, "train", 0),
        (finetuning._Run, "train", 1),  # within stage one
        (finetuning._Run, "judge", 2),  # within a component, an epoch half done
        (SeparateNetworks, "describe", 4),  # describing references once more
    ],
)
def test_interrupted_anywhere_it_goes_on_the_same_to_the_last_bit(
    walk, clusters, body, tuned, tmp_path, monkeypatch, owner, name, calls
):
    monkeypatch.setattr(training, "_CHUNK", 2)
    arguments = {**RECIPE, "finetune": True, "epochs": 2}
    with monkeypatch.context() as patch:
        patch.setattr(owner, name, after(calls, getattr(owner, name)))
        with checkpoints(tmp_path), pytest.raises(StoppedHereError):
            train_separate(walk, clusters, body, **arguments)
    done = []
    original = getattr(owner, name)
    with monkeypatch.context() as patch, checkpoints(tmp_path) as resumed:
        patch.setattr(owner, name, lambda *args, **kwargs: done.append(0) or original(*args, **kwargs))
        again = train_separate(walk, clusters, body, **arguments)
    assert same(again, tuned)
    assert resumed.resumed


def test_what_was_described_is_not_described_again(walk, clusters, body, tmp_path, monkeypatch):
    monkeypatch.setattr(training, "_CHUNK", 2)
    respond = Body.respond
    monkeypatch.setattr(Body, "respond", after(5, respond))
    with checkpoints(tmp_path), pytest.raises(StoppedHereError):
        train_separate(walk, clusters, body, **RECIPE)
    monkeypatch.setattr(Body, "respond", after(3, respond))  # four of seven references were kept
    with checkpoints(tmp_path):
        train_separate(walk, clusters, body, **RECIPE)


def test_weights_in_the_format_of_places365_work_from_a_file(tmp_path, walk):
    torch.manual_seed(3)
    state = {f"module.{key}": value for key, value in ResNet18(365).state_dict().items()}
    file = tmp_path / "resnet18_places365.pth.tar"
    torch.save({"epoch": 90, "arch": "resnet18", "state_dict": state}, file)
    body = load_body("resnet18", str(file), width=48, height=32)
    clusters = Clusters([0, 0, 1])
    for finetune in (False, True):
        trained = train_separate(walk[:3], clusters, body, **RECIPE, finetune=finetune, epochs=1, augment=False)
        (tmp_path / str(finetune)).mkdir()
        trained.networks.save(tmp_path / str(finetune))
        loaded = SeparateNetworks.load(tmp_path / str(finetune), clusters, body, finetune=finetune)
        for reference, image in enumerate(walk[:3]):
            assert np.array_equal(loaded.stage_one(image), trained.networks.stage_one(image))
            assert reference in loaded.answers(image, np.arange(2), 2).references
