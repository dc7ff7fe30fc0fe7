"""What the wrappers add to single images of real walks and rails, by the past alone."""

from dataclasses import dataclass

import numpy as np

from vpr_baselines.sequence.forward import ForwardFilter
from vpr_baselines.sequence.seqslam import SeqSlam
from vpr_bench.dataset.load import load_case
from vpr_bench.method.build import build_method
from vpr_bench.types.match import Match


@dataclass
class Computed:
    """Similarities that were computed before: several wrappers share them, where describing takes longest."""

    rows: np.ndarray

    def fit(self, references):
        self.asked = 0

    def match(self, image, k): ...

    def scores(self, image):
        self.asked += 1
        return self.rows[self.asked - 1]


class Walk:
    """One case, with what a single-image method makes of each query."""

    def __init__(self, dataset, protocol, name, n_queries=None):
        self.case = load_case(dataset, protocol)
        method = build_method(name).method
        method.fit(self.case.references)
        self.rows = np.stack([method.scores(image) for image in self.case.queries[:n_queries]])

    def alone(self):
        return self.recall([Match.from_scores(row, 1) for row in self.rows])

    def wrapped(self, wrapper, **parameters):
        """Follow the walk with a wrapper; it gets no image before it is asked about it."""
        method = wrapper(Computed(self.rows), **parameters)
        method.fit(self.case.references)
        return self.recall([method.match(None, 1) for _ in self.rows])

    def recall(self, matches):
        truth, first = self.case.ground_truth, np.array([match.indices[0] for match in matches])
        asked = np.flatnonzero(
            truth.has_match[: len(first)]
        )  # Nordland's black frames are left out of one season and not the other
        return truth.contains(asked, first[asked]).mean()


def test_gardens_at_night_gains_fifteen_points(real_gardens):
    walk = Walk("gardens:real", "day_left-night_right", "efficientnet-lite0")
    alone = walk.alone()
    assert walk.wrapped(SeqSlam) >= alone + 0.15  # measured: .645, then .865
    assert walk.wrapped(ForwardFilter) >= alone + 0.15  # .915


def test_nordland_in_winter_is_found_by_its_last_frames(real_nordland):
    """The first half of the queries, in the whole map; all of them give .169, .691, .796 and .921."""
    walk = Walk(real_nordland, "summer-winter", "sad", n_queries=1700)
    assert walk.alone() < 0.25
    assert walk.wrapped(SeqSlam, past=10) >= 0.60
    assert walk.wrapped(SeqSlam, past=20) >= 0.70
    assert walk.wrapped(ForwardFilter) >= 0.70
