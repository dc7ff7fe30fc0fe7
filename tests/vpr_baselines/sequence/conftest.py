"""A walk past places that look alike, which only their order tells apart."""

from dataclasses import dataclass

import numpy as np
import pytest

from vpr_bench.types.match import Match
from vpr_bench.types.traverse import Traverse

N_PLACES = 60


@dataclass
class Similarities:
    """Looks its scores up in a table: the query's number is its images' colour."""

    table: np.ndarray
    asked: int = 0

    def fit(self, references):
        self.size_ = len(references)

    def scores(self, image):
        self.asked += 1
        return self.table[number(image)]

    def match(self, image, k):
        return Match.from_scores(self.scores(image), k)


def number(image):
    return int(image[0, 0, 0]) + 256 * int(image[0, 0, 1])


def frame(query):
    return np.full((2, 2, 3), (query % 256, query // 256, 0), np.uint8)


@pytest.fixture
def walk():
    """Return frames whose numbers stand in their colours."""
    return Traverse("walk", [frame(query) for query in range(N_PLACES)])


@pytest.fixture
def similarities():
    """Return a maker of inner methods: weak likeness at the true places, drowned in noise."""

    def make(truth, strength=1.0, seed=0, n_references=N_PLACES):
        table = np.random.default_rng(seed).normal(size=(len(truth), n_references)).astype(np.float32)
        table[np.arange(len(truth)), truth] += strength
        return Similarities(table)

    return make


def follow(method, references, n_queries=None, k=1):
    """Fit a sequence method and return its best answer to every query in order."""
    method.fit(references)
    return [int(method.match(frame(query), k).indices[0]) for query in range(n_queries or len(references))]
