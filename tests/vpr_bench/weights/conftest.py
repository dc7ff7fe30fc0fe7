"""Registered weights of a tiny network, and a folder of weights of the test's own."""

import io
import sys
import types
from dataclasses import dataclass
from pathlib import Path

import pytest
import torch

from vpr_bench.registry import Entry
from vpr_bench.weights.card import WEIGHTS, WeightsCard


def card_fields(**changes):
    fields = {
        "id": "tiny-net-dots",
        "name": "Tiny",
        "architecture": "tiny-net",
        "training_set": "Dots",
        "input_size": [8, 8],
        "mean": [0.5, 0.5, 0.5],
        "std": [0.5, 0.5, 0.5],
        "licence": "CC0",
        "homepage": "https://example.org/tiny",
        "file": "tiny.pth",
        "url": "https://example.org/tiny.pth",
    }
    return {key: value for key, value in {**fields, **changes}.items() if value is not None}


@pytest.fixture
def make_card():
    """Return a maker of cards that differ from a good one."""
    return lambda **changes: WeightsCard(**card_fields(**changes))


@pytest.fixture
def saved() -> bytes:
    """Return what ``torch.save`` makes of a tiny state dict."""
    buffer = io.BytesIO()
    torch.save({"state_dict": {"module.fc.weight": torch.ones(2, 3)}}, buffer)
    return buffer.getvalue()


@dataclass
class TinyWeights:
    """Weights registered as ``tiny-net-dots``."""

    folder: Path

    def register(self, **changes) -> WeightsCard:
        sys.modules["tiny_weights"].card = card = WeightsCard(**card_fields(**changes))
        return card


@pytest.fixture
def tiny_weights(data_folder, tmp_path, monkeypatch) -> TinyWeights:
    """Register weights and set up an empty folder for them."""
    folder = tmp_path / "weights"
    folder.mkdir()
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(folder))
    monkeypatch.setitem(sys.modules, "tiny_weights", types.ModuleType("tiny_weights"))
    entry = Entry("tiny-net-dots", "tiny_weights:card", "tiny-plugin 1.0")
    monkeypatch.setitem(vars(WEIGHTS), "_found", {"tiny-net-dots": [entry]})
    tiny = TinyWeights(folder)
    tiny.register()
    return tiny
