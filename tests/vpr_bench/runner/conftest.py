"""A case in memory and a method that answers it, so that running needs neither disk images nor a network."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.dataset.load import Case
from vpr_bench.method.build import BuiltMethod
from vpr_bench.runner.store import RunStore
from vpr_bench.timing import stage
from vpr_bench.types.match import Match
from vpr_bench.types.places import Places
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.traverse import Traverse

N_PLACES = 12


@dataclass
class MeanColour:
    """Euclidean distance of mean colours; counts what it is asked, and can be told to fail."""

    fail_after: int | None = None
    error: type[BaseException] = RuntimeError
    fits: int = 0
    matches: int = 0

    def fit(self, references: Traverse) -> None:
        self.fits += 1
        self.database_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def match(self, image: np.ndarray, k: int) -> Match:
        if self.matches == self.fail_after:
            raise self.error("told to fail")
        self.matches += 1
        with stage("encode"):
            colour = image.mean(axis=(0, 1))
        with stage("match"):
            return Match.from_scores(-np.linalg.norm(self.database_ - colour, axis=1), k)

    def save(self, folder: Path) -> None:
        np.save(folder / "database.npy", self.database_)

    def load(self, folder: Path) -> "MeanColour":
        self.database_ = np.load(folder / "database.npy")
        return self


@pytest.fixture
def case() -> Case:
    random = np.random.default_rng(5)
    places = random.integers(20, 235, (N_PLACES, 1, 1, 3))
    references = [np.broadcast_to(place, (6, 8, 3)).astype(np.uint8) for place in places]
    queries = [np.clip(image.astype(int) + 2, 0, 255).astype(np.uint8) for image in references]
    labels = np.arange(N_PLACES, dtype=np.float64)
    protocol = Protocol("tiny", "summer", "winter", 1, "f")
    return Case(
        protocol,
        Traverse("summer", references),
        Traverse("winter", queries),
        Places(labels.copy(), labels),
        "sha256:" + "0" * 64,
        Path("nowhere"),
    )


@pytest.fixture
def store(tmp_path) -> RunStore:
    return RunStore(tmp_path / "runs")


def built(method: object, **parameters: object) -> BuiltMethod:
    """Wrap a method as ``build_method`` does."""
    return BuiltMethod("mean-colour", "1", parameters, None, "mean-colour", method)


@pytest.fixture(name="built")
def built_fixture():
    return built


@pytest.fixture(name="mean_colour")
def mean_colour_fixture():
    return MeanColour
