"""What all tests share: folders of their own, a tiny dataset, and the real images where this machine has them."""

import os

# One thread: more are no faster on small images, and stand in each other's way on a busy machine. Set before
# anything that computes is imported, NumPy included.
os.environ.setdefault("OMP_NUM_THREADS", "1")

import shutil
import sys
import types
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest
from hypothesis import settings
from PIL import Image

from vpr_bench.dataset.card import DATASETS, Card
from vpr_bench.dataset.content import traverse_digest
from vpr_bench.dataset.editions import find_images
from vpr_bench.registry import Entry
from vpr_bench.types.traverse import Traverse

settings.register_profile("tests", deadline=None)
settings.load_profile("tests")

_REAL_IMAGES = os.environ.get("VPR_BENCH_DATA")  # read before the tests get folders of their own


@pytest.fixture(scope="session", autouse=True)
def _own_folders(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep the tests, and the processes they start, out of the user's data and caches."""
    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        for kind in ("DATA", "CACHE", "CONFIG", "STATE"):
            patch.setenv(f"XDG_{kind}_HOME", str(home / kind.lower()))
        patch.delenv("VPR_BENCH_DATA", raising=False)
        yield


@pytest.fixture
def data_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty data root; cache and state are empty too, all for this test alone."""
    root = tmp_path / "data"
    root.mkdir()
    monkeypatch.setenv("VPR_BENCH_DATA", str(root))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return root


@pytest.fixture
def real_gardens(monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder of the real Gardens Point images, or skip the test."""
    if not _REAL_IMAGES:
        pytest.skip("set VPR_BENCH_DATA to the folder that holds gardens to test on the real images")
    monkeypatch.setenv("VPR_BENCH_DATA", _REAL_IMAGES)
    folder = find_images(DATASETS.entry("gardens").load())
    if folder is None:
        pytest.skip(f"{_REAL_IMAGES} does not hold the real images of gardens")
    return folder


@pytest.fixture
def real_nordland(monkeypatch: pytest.MonkeyPatch) -> str:
    """Return how to ask for the real small Nordland images, or skip the test."""
    if not _REAL_IMAGES:
        pytest.skip("set VPR_BENCH_DATA to the folder that holds nordland-64x32 to test on the real images")
    monkeypatch.setenv("VPR_BENCH_DATA", _REAL_IMAGES)
    if find_images(DATASETS.entry("nordland").load(), "64x32") is None:
        pytest.skip(f"{_REAL_IMAGES} does not hold the images of nordland-64x32")
    return "nordland:64x32"


TINY_PLACES, TINY_WIDTH, TINY_HEIGHT = 12, 64, 48
TINY_TRAVERSES = {"day_left": (0, 1.0), "day_right": (3, 0.9), "night_right": (3, 0.5)}
"""How far each traverse's camera stands to the right, in pixels, and how bright its pictures are."""


def tiny_image(place: int, traverse: str) -> np.ndarray:
    """Return a picture whose texture tells its place, as this traverse sees it: (48, 64, 3) uint8."""
    shift, brightness = TINY_TRAVERSES[traverse]
    blocks = np.random.default_rng(place).integers(0, 256, (6, 9, 3), dtype=np.uint8)
    texture = Image.fromarray(blocks).resize((72, TINY_HEIGHT), Image.Resampling.BICUBIC)
    return (np.asarray(texture)[:, shift : shift + TINY_WIDTH] * brightness).astype(np.uint8)


def write_tiny_images(folder: Path) -> None:
    """Write every traverse of the tiny dataset."""
    for traverse in TINY_TRAVERSES:
        (folder / traverse).mkdir(parents=True)
        for place in range(TINY_PLACES):
            Image.fromarray(tiny_image(place, traverse)).save(folder / traverse / f"Image{place:03d}.jpg", quality=95)


class TinyRenderer:
    """Renders the tiny dataset's simulated edition, and remembers into which folders."""

    rendered: ClassVar[list[Path]] = []

    def __init__(self, options: dict[str, Any]) -> None:
        self.options = options

    def fingerprint(self) -> str:
        return f"v{self.options['version']}"

    def render(self, folder: Path) -> None:
        self.rendered.append(folder)
        write_tiny_images(folder)


@dataclass(frozen=True)
class TinyDataset:
    """A dataset of 3 traverses × 12 places, registered as ``tiny``, with its real images in the data root."""

    card: Card
    folder: Path
    """Holds the traverses of the real edition; a copy for this test alone."""
    rendered: list[Path]
    """Where the simulated edition was rendered."""

    def without_images(self) -> "TinyDataset":
        """Delete the real edition."""
        shutil.rmtree(self.folder)
        return self


@pytest.fixture(scope="session")
def tiny_images(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the tiny dataset's images, for reading only."""
    folder = tmp_path_factory.mktemp("tiny") / "images"
    write_tiny_images(folder)
    return folder


@pytest.fixture(scope="session")
def tiny_card(tiny_images: Path) -> Card:
    """Return the tiny dataset's card, which knows the digests of its images."""
    traverses = [
        {
            "name": name,
            "images": TINY_PLACES,
            "digest": traverse_digest(Traverse(name, sorted((tiny_images / name).iterdir()))),
        }
        for name in TINY_TRAVERSES
    ]
    return Card.model_validate(
        {
            "id": "tiny",
            "name": "Tiny",
            "summary": "Twelve textures, seen three times.",
            "citation": "none",
            "licence": "CC0",
            "homepage": "https://example.org/tiny",
            "folders": ["TinyTextures"],
            "unit": "f",
            "loader": {
                "layout": "numbered",
                "options": {"pattern": "Image{index:03d}.jpg"},
            },
            "traverses": traverses,
            "protocols": [
                {"references": "day_left", "queries": "day_right", "radius": 1},
                {"references": "day_left", "queries": "night_right", "radius": 1, "unmatched": "miss"},
            ],
            "simulation": {"renderer": "tiny_plugin:Renderer", "options": {"version": 1}},
        }
    )


@pytest.fixture
def tiny_dataset(tiny_card: Card, tiny_images: Path, data_folder: Path, monkeypatch: pytest.MonkeyPatch) -> TinyDataset:
    """Register the dataset ``tiny`` and put its images into this test's data root."""
    monkeypatch.setattr(TinyRenderer, "rendered", [])
    plugin = types.ModuleType("tiny_plugin")
    vars(plugin).update(card=tiny_card, Renderer=TinyRenderer)
    monkeypatch.setitem(sys.modules, "tiny_plugin", plugin)
    found = {**DATASETS._found, "tiny": [Entry("tiny", "tiny_plugin:card", "tiny-plugin 1.0")]}
    monkeypatch.setitem(vars(DATASETS), "_found", found)
    folder = data_folder / "tiny"
    shutil.copytree(tiny_images, folder)
    return TinyDataset(tiny_card, folder, TinyRenderer.rendered)
