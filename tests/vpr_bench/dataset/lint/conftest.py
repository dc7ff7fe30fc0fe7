"""Making datasets that have one thing wrong with them."""

import sys
import types
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.layout import LAYOUTS, Layout
from vpr_bench.dataset.lint import Finding, lint_source
from vpr_bench.dataset.load import DatasetWarning
from vpr_bench.dataset.recording import Recording
from vpr_bench.dataset.source import Source
from vpr_bench.errors import DataError
from vpr_bench.registry import Entry
from vpr_bench.types.ground_truth import GroundTruth
from vpr_bench.types.traverse import Traverse


def _picture(seed: int) -> np.ndarray:
    """Return a texture that no other number has: (24, 32, 3) uint8."""
    return np.random.default_rng(seed).integers(20, 236, (24, 32, 3), dtype=np.uint8)


def _load(folder: Path, card: Any, labels: Any = None, warning: str = "") -> Recording:
    if not folder.is_dir():
        raise DataError(f"The folder {folder} is missing.")
    if warning:
        warnings.warn(warning, DatasetWarning, stacklevel=2)
    files = sorted(file for file in folder.iterdir() if file.suffix in (".png", ".jpg") and file.name[0] != ".")
    return Recording(Traverse(card.name, files), None if labels == [] else labels or np.arange(len(files)))


def _given(folder: Path, references: Recording, queries: Recording, lists: Any, warning: str = "") -> GroundTruth:
    if warning:
        warnings.warn(warning, DatasetWarning, stacklevel=2)
    return GroundTruth.from_lists(lists, len(references))


@dataclass
class Made:
    """Two traverses of ten images each, ``day`` and ``night``, with nothing wrong."""

    folder: Path
    unit: str = "f"
    options: dict[str, dict[str, Any]] = field(default_factory=lambda: {"day": {}, "night": {}})
    protocols: list[dict[str, Any]] = field(
        default_factory=lambda: [{"references": "day", "queries": "night", "radius": 1}]
    )
    given: dict[str, Any] | None = None

    def write(self, traverse: str, names: list[str], first: int) -> None:
        """Write a traverse anew, under these names."""
        (self.folder / traverse).mkdir(exist_ok=True)
        for file in (self.folder / traverse).iterdir():
            file.unlink()
        for index, name in enumerate(names):
            Image.fromarray(_picture(first + index)).save(self.folder / traverse / name)

    def image(self, traverse: str, index: int) -> Path:
        return self.folder / traverse / f"{index:02d}.png"

    def paint(self, traverse: str, index: int, image: np.ndarray) -> None:
        Image.fromarray(image).save(self.image(traverse, index))

    def source(self) -> Source:
        pair = {"references": "day", "queries": "night"}
        card = Card.model_validate(
            {
                **dict.fromkeys(("name", "summary", "citation", "licence", "homepage"), "made"),
                "id": "made",
                "unit": self.unit,
                "loader": {"layout": "made"},
                "traverses": [{"name": name, "options": options} for name, options in self.options.items()],
                "protocols": self.protocols,
                "given": [] if self.given is None else [{**pair, "options": self.given}],
            }
        )
        return Source(card, "real", card, self.folder)

    def lint(self) -> list[Finding]:
        return lint_source(self.source())

    def only(self) -> Finding:
        """Return the one finding."""
        (finding,) = self.lint()
        return finding


@pytest.fixture
def made(tmp_path: Path, data_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Made:
    """Return a dataset with nothing wrong, to be spoilt."""
    plugin = types.ModuleType("made_plugin")
    plugin.LAYOUT = Layout("made for a test", _load, _given)  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "made_plugin", plugin)
    monkeypatch.setitem(vars(LAYOUTS), "_found", {"made": [Entry("made", "made_plugin:LAYOUT", "made 1.0")]})
    dataset = Made(tmp_path / "made")
    dataset.folder.mkdir()
    for first, name in ((0, "day"), (100, "night")):
        dataset.write(name, [f"{index:02d}.png" for index in range(10)], first)
    return dataset


@pytest.fixture
def picture() -> Callable[[int], np.ndarray]:
    """Return what makes the picture of a number."""
    return _picture
