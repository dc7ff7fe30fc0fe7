"""A method whose map can be kept, extended and looked at; tells what it did."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from vpr_bench import Match, stage
from vpr_bench.checkpoint import kept

done = []
fail_after = []


@dataclass
class Colours:
    """Compares the mean colours of a grid of cells."""

    version: ClassVar[str] = "1"
    cells: int = 4
    seed: int = 0

    def fit(self, references):
        self.map_ = np.empty((0, 3 * self.cells**2), np.float32)
        self.extend(references)

    def extend(self, references):
        new = kept("colours", lambda: self.described(references))["colours"]
        if fail_after:
            raise fail_after.pop()
        self.map_ = np.concatenate([self.map_, new])

    def described(self, references):
        done.append(len(references))
        return {"colours": np.stack([self.describe(image) for image in references])}

    def match(self, image, k):
        with stage("encode"):
            descriptor = self.describe(image)
        with stage("match"):
            return Match.from_scores(-np.linalg.norm(self.map_ - descriptor, axis=1), k)

    def describe(self, image):
        rows = np.array_split(image.astype(np.float32), self.cells)
        cells = [cell.mean((0, 1)) for row in rows for cell in np.array_split(row, self.cells, axis=1)]
        whole = np.concatenate(cells)
        return whole / max(np.linalg.norm(whole), 1e-6)

    def augmented(self, image, index):
        noise = np.random.default_rng(index).integers(0, 60, image.shape)
        return {"dark": image // 2, "noise": np.clip(image + noise, 0, 255).astype(np.uint8)}

    def save(self, folder):
        np.save(folder / "map.npy", self.map_)

    def load(self, folder):
        self.map_ = np.load(folder / "map.npy")
        return self


class Forgetful:
    """Cannot save."""

    version = "1"

    def fit(self, references):
        self.size = len(references)

    def match(self, image, k):
        return Match([0], [1.0])
