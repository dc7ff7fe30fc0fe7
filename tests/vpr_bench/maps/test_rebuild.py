"""A map and the method of today: the same, another version, gone, or something that nobody should run."""

import numpy as np
import pytest

from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.maps.fit import fit_map
from vpr_bench.maps.map import load_map
from vpr_bench.maps.references import of_dataset
from vpr_bench.method.build import build_method

MINE = """
open("ran", "w").close()
from colours_plugin import Colours

class Mine(Colours):
    version = "mine"
"""
IMAGE = np.full((48, 64, 3), 90, np.uint8)


@pytest.fixture
def mine(tmp_path, monkeypatch, colours):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(MINE)
    return tmp_path / "ran"


def test_another_version_of_the_method(tiny_map, place, colours, monkeypatch):
    monkeypatch.setattr(colours.Colours, "version", "2")
    with pytest.raises(DataError) as caught:
        load_map(place).locate(IMAGE)
    assert "was made by version 1 of colours (vpr-bench 0.1.0); here it is version 2" in str(caught.value)
    again = f"vpr-bench fit --method colours --dataset tiny --references day_left -o {place} --overwrite"
    assert str(caught.value).endswith(again)


def test_the_command_names_what_is_not_usual(tiny_dataset, colours, place, monkeypatch):
    built = build_method("seqslam", {"inner": "colours", "inner.cells": 3, "past": 4})
    fit_map(built, of_dataset("tiny:simulated", "day_right.every2"), place)
    monkeypatch.setattr(colours.Colours, "version", "2")
    with pytest.raises(DataError) as caught:
        load_map(place).locate(IMAGE)
    said = str(caught.value)
    assert "--param past=4" in said
    assert "cells" in said
    assert "--dataset tiny --references day_right.every2 --edition simulated" in said


def test_a_method_that_is_not_installed(tiny_map, place, edit):
    edit(lambda content: content["method"].update(id="colour"))
    with pytest.raises(UsageError, match=r"There is no method 'colour'. Did you mean 'colours'"):
        load_map(place).locate(IMAGE)


@pytest.mark.parametrize("name", ["mine.py:Mine", "os:system", "./mine.py:Mine"])
def test_a_map_cannot_have_a_file_run(tiny_map, place, edit, mine, name):
    edit(lambda content: content["method"].update(id=name))
    with pytest.raises(UsageError, match="If you trust it, say where it is with --method"):
        load_map(place).locate(IMAGE)
    assert not mine.exists()


@pytest.mark.parametrize(
    "inner", ["mine.py:Mine", {"method": "mine.py:Mine", "version": "1", "parameters": {}, "weights": None}]
)
def test_nor_as_a_method_inside(tiny_dataset, colours, place, edit, mine, inner):
    fit_map(build_method("seqslam", {"inner": "colours"}), of_dataset("tiny"), place)
    edit(lambda content: content["method"]["parameters"].update(inner=inner))
    with pytest.raises(UsageError, match="If you trust it"):
        load_map(place).locate(IMAGE)
    assert not mine.exists()


def test_unless_the_user_names_it(tiny_dataset, colours, place, mine):
    fit_map(build_method("mine.py:Mine", {"cells": 3}), of_dataset("tiny"), place)
    mine.unlink()
    (mine.parent / "elsewhere").mkdir()
    (mine.parent / "mine.py").replace(mine.parent / "elsewhere" / "mine.py")
    asked = load_map(place, method="elsewhere/mine.py:Mine")
    assert asked.locate(of_dataset("tiny").traverse[3]).locations[0].reference == 3
    assert asked.built.parameters["cells"] == 3


def test_or_where_a_method_inside_is(tiny_dataset, colours, place, mine):
    built = build_method("seqslam", {"inner": "mine.py:Mine", "inner.cells": 3})
    fit_map(built, of_dataset("tiny"), place)
    asked = load_map(place, parameters={"inner": "mine.py:Mine"})
    assert asked.built.parameters["inner"]["parameters"]["cells"] == 3
    assert len(asked.locate(IMAGE).locations) == 5


def test_the_user_names_another(tiny_map, place, mine):
    with pytest.raises(DataError, match=r"was made by version 1 of mine.py:Mine .*; here it is version mine"):
        load_map(place, method="mine.py:Mine").locate(IMAGE)
    (mine.parent / "mine.py").write_text(MINE.replace('"mine"', '"1"'))
    with pytest.raises(UsageError, match=r"is a map of 'colours', not of 'mine.py:Mine'"):
        load_map(place, method="mine.py:Mine").locate(IMAGE)


def test_parameters_that_the_method_refuses(tiny_map, place, edit):
    for wrong in ({"cell": 4}, {"cells": "many"}):
        edit(lambda content, wrong=wrong: content["method"].update(parameters=wrong))
        with pytest.raises(DataError, match="cannot be used"):
            load_map(place).locate(IMAGE)


def test_parameters_that_only_matter_to_answers_can_be_changed(tiny_map, place):
    assert load_map(place, parameters={"seed": "3"}).built.parameters["seed"] == 3
    with pytest.raises(UsageError, match=r"has no parameter 'sed'. Did you mean 'seed'"):
        load_map(place, parameters={"sed": "3"}).locate(IMAGE)


def test_other_weights(tiny_map, place, colours, monkeypatch):
    monkeypatch.setattr(colours.Colours, "weights_digest", lambda self: "net sha256:2", raising=False)
    with pytest.raises(DataError, match=r"with the weights None; here they are net sha256:2. Fit it again"):
        load_map(place).locate(IMAGE)


def test_a_method_that_cannot_read(tiny_map, place, edit):
    edit(lambda content: content["method"].update(id="forgetful", parameters={}))
    with pytest.raises(DataError, match="which cannot read maps"):
        load_map(place).locate(IMAGE)


def test_a_state_of_other_parameters(tiny_map, place, edit):
    edit(lambda content: content["method"].update(parameters={"cells": 2}))
    with pytest.raises(VprBenchError, match="failed while answering the image: ValueError"):
        load_map(place).locate(IMAGE)
