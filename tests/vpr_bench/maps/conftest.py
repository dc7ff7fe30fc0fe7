"""A map of twelve places, and the photos to ask it with."""

import json
from pathlib import Path

import pytest

from vpr_bench.maps.fit import fit_map
from vpr_bench.maps.record import _digest
from vpr_bench.maps.references import of_dataset
from vpr_bench.method.build import build_method


@pytest.fixture
def place(tmp_path) -> Path:
    """Return where a map may go."""
    (tmp_path / "maps").mkdir()
    return tmp_path / "maps" / "tiny.map"


@pytest.fixture
def tiny_map(tiny_dataset, colours, place):
    """Return the map of ``day_left`` by the method ``colours``."""
    return fit_map(build_method("colours"), of_dataset("tiny"), place, threads=1)


@pytest.fixture
def edit(place):
    """Edit the map.json of the map, and give it the digest that it then should have."""

    def edit(change, *, sealed=True):
        file = place / "map.json"
        content = json.loads(file.read_text())
        change(content)
        if sealed:
            content.pop("digest", None)
            content["digest"] = _digest(content)
        file.write_text(json.dumps(content))

    return edit
