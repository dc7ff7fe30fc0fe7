"""Methods that write down what they are asked."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from vpr_bench.bench.variants import Variant
from vpr_bench.dataset.load import load_case
from vpr_bench.method.build import BuiltMethod
from vpr_bench.timing import stage
from vpr_bench.types.match import Match


@dataclass
class Listener:
    """Answers anything, and notes its name and the image that it was shown in a log that it shares with others."""

    name: str
    log: list[tuple[str, bytes]]
    stages: tuple[str, ...] = ("encode", "match")
    fail_after: int = 10**6

    def fit(self, references):
        self.first_, self.size_ = references[0], len(references)
        self.log.append((self.name, "fit"))

    def match(self, image, k):
        if len(self.log) > self.fail_after:
            raise RuntimeError("told to fail")
        for name in self.stages:
            with stage(name):
                pass
        shown = "warm-up" if np.array_equal(image, self.first_) else image.tobytes()
        self.log.append((self.name, shown))
        return Match(np.arange(k), np.zeros(k))


@dataclass
class Sequel(Listener):
    """One that wants to be shown images in their order."""

    sequential: bool = True
    resets: list[int] = field(default_factory=list)

    def reset(self):
        self.resets.append(len(self.log))


@pytest.fixture
def case(tiny_dataset):
    return load_case("tiny")


@pytest.fixture
def log():
    return []


@pytest.fixture
def variant(log):
    """Return a maker of variants that all write into one log."""

    def make(name, kind=Listener, **options):
        return Variant(name, BuiltMethod(name, "1", {}, None, name, kind(name, log, **options)))

    return make


@pytest.fixture
def sequel():
    return Sequel
