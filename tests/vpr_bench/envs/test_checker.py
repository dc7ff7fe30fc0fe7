"""Gymnasium's own checker has nothing to say about any of our environments, nor about one of somebody's folder."""

import warnings
from collections import deque

import gymnasium
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env

from vpr_bench.dataset.card import DATASETS, find_card
from vpr_bench.envs.ids import env_id
from vpr_datasets.simulation.job import Job

OURS = [entry.name for entry in DATASETS.entries() if entry.target.startswith("vpr_datasets.")]


@pytest.fixture
def quick_simulation(data_folder, monkeypatch):
    """Write tiny noise in place of what takes long to render, under the same names, into a cache of this test."""

    def noise(spec, name, index):
        return np.random.default_rng(index).integers(0, 256, (24, 32, 3), dtype=np.uint8)

    def render(spec, folder, *, files):
        deque(Job(spec=spec, folder=folder, files=files, worker=0, workers=1).carry_out(), maxlen=0)

    monkeypatch.setattr("vpr_datasets.simulation.job.render_frame", noise)
    monkeypatch.setattr("vpr_datasets.simulation.rendering.render", render)


def check(identifier, **settings):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(identifier, **settings)
        check_env(env.unwrapped)
        spec = EnvSpec.from_json(env.spec.to_json())
        assert spec == env.spec
        vector = gymnasium.make_vec(spec, num_envs=3)
        observation, _ = vector.reset(seed=0)
        assert observation in vector.observation_space
        assert vector.step(vector.action_space.sample())[0] in vector.observation_space


@pytest.mark.usefixtures("quick_simulation")
@pytest.mark.parametrize("dataset", OURS)
def test_every_id_passes(dataset):
    if find_card(dataset).simulation is None:
        pytest.skip(f"{dataset} has no simulated edition")
    check(env_id(dataset))


def test_small_maps_and_every_setting(tiny_dataset):
    check("vpr_bench/Place-v0", dataset="tiny", k=12, order="sequential", size=[10, 12], in_memory=True)
    check("vpr_bench/Place-v0", dataset="tiny", protocol="day_left-night_right.first1", k=1, unmatched="reject")


def test_a_folder_of_ones_own(tiny_images):
    check("vpr_bench/Place-v0", dataset=str(tiny_images))


@pytest.mark.parametrize("sizes", [[(6, 8), (9, 5)], [(7, 7)]])
def test_mixed_sizes(make_env, make_case, sizes):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make_env(make_case(sizes=sizes)).unwrapped)
