"""Small cases in memory, and environments that ask them."""

from pathlib import Path

import gymnasium
import numpy as np
import pytest

from vpr_bench.dataset.load import Case
from vpr_bench.types.match import Match
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.traverse import Traverse

N_REFERENCES, N_QUERIES = 8, 5
LOST = 4
"""The query that has no true match."""


@pytest.fixture
def make_case():
    """Return a maker of cases of 8 references and 5 queries, one colour per place; the last query lies elsewhere."""

    def make(sizes=((6, 8),), unmatched="exclude", given=None) -> Case:
        references = [np.full((6, 8, 3), 10 + 20 * place, np.uint8) for place in range(N_REFERENCES)]
        shapes = [sizes[query % len(sizes)] for query in range(N_QUERIES)]
        queries = [np.full((*shape, 3), 12 + 20 * query, np.uint8) for query, shape in enumerate(shapes)]
        labels = np.arange(N_QUERIES, dtype=np.float64)
        labels[LOST] = 100
        return Case(
            Protocol("plain", "summer", "winter", 0 if given else 1, "given" if given else "f", unmatched=unmatched),
            Traverse("summer", references),
            Traverse("winter", queries),
            Places(labels, np.arange(N_REFERENCES, dtype=np.float64), given),
            "sha256:" + "0" * 64,
            Path("nowhere"),
        )

    return make


@pytest.fixture
def make_env(make_case, monkeypatch):
    """Return a maker of environments of such a case, single ones or, with ``num_envs``, vector ones."""

    def make(case=None, **settings):
        monkeypatch.setattr("vpr_bench.envs.task.load_case", lambda *_: case or make_case())
        if "num_envs" in settings:
            return gymnasium.make_vec("vpr_bench/Place-v0", dataset="plain", **settings)
        return gymnasium.make("vpr_bench/Place-v0", dataset="plain", **settings)

    return make


@pytest.fixture
def answer():
    """Return a maker of actions: references, the best first, with falling scores."""

    def make(env, *references):
        space = getattr(env.unwrapped, "single_action_space", env.action_space)
        return space.of(Match(list(references), np.linspace(1, 0, len(references), dtype=np.float32)))

    return make


class Brightness:
    """Compares mean brightness; needs no parameters."""

    version = "1"

    def fit(self, references: Traverse) -> None:
        self.database_ = np.array([image.mean() for image in references])

    def match(self, image: np.ndarray, k: int) -> Match:
        return Match.from_scores(-np.abs(self.database_ - image.mean()), k)


@pytest.fixture
def brightness() -> Brightness:
    return Brightness()
