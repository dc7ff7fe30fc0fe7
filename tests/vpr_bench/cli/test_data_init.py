import json
import sys
import tomllib
import types
import warnings

import numpy as np
import pytest
from PIL import Image

from vpr_bench.dataset.layout import LAYOUTS, Layout, Recognised
from vpr_bench.dataset.load import DatasetWarning, load_case
from vpr_bench.dataset.own import own_card
from vpr_bench.dataset.recording import Recording
from vpr_bench.registry import Entry
from vpr_bench.types.traverse import Traverse


def files_of(folder):
    return sorted(folder.glob("*.png"))


def load(folder, card, *, spacing):
    if (folder / "spoilt").exists():
        warnings.warn("one place was spoilt", DatasetWarning, stacklevel=2)
    far = 1000 if (folder / "far").exists() else 0
    return Recording(Traverse(card.name, files_of(folder)), far + np.arange(len(files_of(folder))) * spacing)


def recognise(folder):
    names = [one for one in ("day", "night") if (folder / one).is_dir() and files_of(folder / one)]
    if len(names) < 2:
        return None
    return Recognised(
        found=f"stub folders: {', '.join(names)}",
        unit="m",
        traverses=[{"name": one, "images": np.int64(len(files_of(folder / one))), "digest": None} for one in names],
        protocols=[
            {"references": "day", "queries": "night", "radius": 5.0, "about": "default"},
            {"references": "night", "queries": "day", "radius": 5.0},
            {"references": "day", "queries": "night", "radius": 2, "unit": "nearest"},
        ],
        options={"spacing": np.float64(4)},
    )


def recognise_too(folder):
    found = recognise(folder)
    return found and Recognised("something else", "f", found.traverses, found.protocols)


@pytest.fixture
def stub(monkeypatch):
    """Register the layout ``stub``, and ``other``, which recognises the same folders and comes second; no others."""
    plugin = types.ModuleType("stub_plugin")
    plugin.STUB = Layout("two folders, day and night, of pictures", load, recognise=recognise, rank=2)
    plugin.OTHER = Layout("the same, otherwise", load, recognise=recognise_too, rank=1)
    plugin.NEVER = Layout("what is never there", load, recognise=lambda folder: None)
    monkeypatch.setitem(sys.modules, "stub_plugin", plugin)
    found = {name: [Entry(name, f"stub_plugin:{name.upper()}", "stub 1.0")] for name in ("stub", "other", "never")}
    monkeypatch.setitem(vars(LAYOUTS), "_found", found)


@pytest.fixture
def walk(stub, tmp_path):
    """Return a folder of two walks of 8 images."""
    folder = tmp_path / "My Walk"
    for name in ("day", "night"):
        (folder / name).mkdir(parents=True)
        for place in range(8):
            Image.new("RGB", (24, 16), (place * 30, 80, 80)).save(folder / name / f"{place}.png")
    return folder


def test_says_what_it_found_and_what_to_do_next(vpr_bench, walk):
    done = vpr_bench("data", "init", str(walk))
    assert (done.code, done.err) == (0, "")
    for said in ("my-walk", "stub folders: day, night", "layout stub", "my-walk/day-night@5m", "8 of 8"):
        assert said in done.out
    assert "--layout other: something else" in done.out
    assert done.out.splitlines()[-1] == f"next     vpr-bench run --method hog --dataset '{walk}'"


def test_card_loads_again(vpr_bench, walk):
    assert vpr_bench("data", "init", str(walk), "--licence", "CC0", "--citation", "me", "--name", "Täst").code == 0
    text = (walk / "vpr-bench.toml").read_text("utf-8")
    assert text.startswith("# What vpr-bench knows")
    card = own_card(walk)
    assert (card.id, card.name, card.licence, card.citation) == ("my-walk", "Täst", "CC0", "me")
    assert card.loader.options == {"spacing": 4.0}
    assert str(card.listed_protocols()[0]) == "my-walk/day-night@5m"
    assert all(one.digest and one.images == 8 for one in card.traverses)
    assert load_case(str(walk)).ground_truth.n_queries == 8
    assert sorted(one.name for one in walk.iterdir()) == ["day", "night", "vpr-bench-preview.png", "vpr-bench.toml"]
    with Image.open(walk / "vpr-bench-preview.png") as picture:
        assert picture.width > 1000


def test_changes_are_noticed(vpr_bench, walk):
    vpr_bench("data", "init", str(walk))
    assert vpr_bench("data", "verify", str(walk)).code == 0
    Image.new("RGB", (24, 16)).save(walk / "day" / "3.png")
    done = vpr_bench("data", "verify", str(walk))
    assert done.code == 1
    assert "not the copy that the card knows" in done.err


def test_json(vpr_bench, walk):
    facts = json.loads(vpr_bench("data", "init", str(walk), "--format", "json").out)
    assert facts["traverses"][0] == {"name": "day", "folder": "day", "images": 8}
    assert [one["with_match"] for one in facts["protocols"]] == [8, 8, 8]
    assert facts["card"] == str(walk / "vpr-bench.toml")


def test_own_card_is_never_overwritten_unasked(vpr_bench, walk):
    (walk / "vpr-bench.toml").write_text("mine")
    done = vpr_bench("data", "init", str(walk))
    assert done.code == 2
    assert "--force" in done.err
    assert (walk / "vpr-bench.toml").read_text() == "mine"
    assert vpr_bench("data", "init", str(walk), "--force").code == 0
    assert tomllib.loads((walk / "vpr-bench.toml").read_text("utf-8"))["id"] == "my-walk"


def test_radius_is_for_protocols_that_have_one(vpr_bench, walk):
    vpr_bench("data", "init", str(walk), "--radius", "9")
    assert [str(one).partition("@")[2] for one in own_card(walk).listed_protocols()] == ["9m", "9m", "2nearest"]


@pytest.mark.parametrize("radius", ["-1", "nan", "1e9"])
def test_radius_that_is_none(vpr_bench, walk, radius):
    done = vpr_bench("data", "init", str(walk), "--radius", radius)
    assert done.code == 2
    assert "radius" in done.err
    assert not (walk / "vpr-bench.toml").exists()


def test_no_query_with_a_match_is_said(vpr_bench, walk):
    (walk / "night" / "far").touch()
    done = vpr_bench("data", "init", str(walk))
    assert done.code == 0
    assert "no query has a match" in done.err
    assert "0 of 8" in done.out


def test_layout_that_fails_is_named(vpr_bench, walk):
    done = vpr_bench("data", "init", str(walk), "--layout", "other")  # gives load() no spacing
    assert done.code == 3
    assert "The layout 'other' failed" in done.err
    assert not (walk / "vpr-bench.toml").exists()


def test_another_layout_on_demand(vpr_bench, walk):
    done = vpr_bench("data", "init", str(walk), "--layout", "never")
    assert done.code == 3
    assert "is not of the layout 'never' (what is never there), but of stub and other" in done.err
    done = vpr_bench("data", "init", str(walk), "--layout", "stb")
    assert done.code == 2
    assert "Did you mean 'stub'?" in done.err


def test_id_that_is_taken(vpr_bench, walk, tiny_dataset):
    done = vpr_bench("data", "init", str(walk), "--id", "tiny")
    assert done.code == 2
    assert "choose another id" in done.err
    walk.rename(walk.parent / "tiny")
    done = vpr_bench("data", "init", str(walk.parent / "tiny"), "--format", "json")
    assert json.loads(done.out)["dataset"] == "my-tiny"


def test_id_that_is_none(vpr_bench, walk):
    done = vpr_bench("data", "init", str(walk), "--id", "My Id")
    assert done.code == 2
    assert "Try 'my-id'" in done.err


def test_damaged_image_leaves_neither_card_nor_picture(vpr_bench, walk):
    (walk / "night" / "0.png").write_bytes(b"\x89PNG")
    done = vpr_bench("data", "init", str(walk))
    assert done.code == 3
    assert "0.png" in done.err
    assert sorted(one.name for one in walk.iterdir()) == ["day", "night"]


def test_warnings_are_shown(vpr_bench, walk):
    (walk / "night" / "spoilt").touch()
    done = vpr_bench("data", "init", str(walk))
    assert done.code == 0
    assert "warning: one place was spoilt" in done.err


def test_what_is_no_folder(vpr_bench, stub, tmp_path):
    (tmp_path / "walk.zip").touch()
    for name, said in (("nowhere", "There is no folder"), ("walk.zip", "is a file")):
        done = vpr_bench("data", "init", str(tmp_path / name))
        assert done.code == 3
        assert said in done.err


def test_folder_that_is_not_recognised(vpr_bench, stub, tmp_path):
    Image.new("RGB", (24, 16)).save(tmp_path / "0.jpg")
    done = vpr_bench("data", "init", str(tmp_path))
    assert done.code == 3
    assert "holds 1 image." in done.err
    assert "two folders, day and night, of pictures" in done.err


def test_folder_around_or_inside_is_suggested(vpr_bench, walk):
    for given in (walk.parent, walk / "day"):
        done = vpr_bench("data", "init", str(given))
        assert done.code == 3
        assert f"Did you mean {walk}?" in done.err


def test_next_command_cannot_mean_a_dataset(vpr_bench, walk, tiny_dataset):
    walk.rename(walk.parent / "here" / "tiny")  # the current folder
    done = vpr_bench("data", "init", "tiny")
    assert done.out.splitlines()[-1].endswith("--dataset ./tiny")


def test_information_and_path_of_a_folder(vpr_bench, walk):
    assert vpr_bench("data", "path", str(walk)).out.strip() == str(walk)
    vpr_bench("data", "init", str(walk), "--licence", "CC0")
    done = vpr_bench("info", str(walk))
    assert done.code == 0
    for said in ("my-walk: My Walk", "CC0", "my-walk/day-night@5m", str(walk)):
        assert said in done.out


def test_folders_in_the_same_order_without_a_stub(vpr_bench, tmp_path):
    for name in ("a", "b"):
        (tmp_path / "two" / name).mkdir(parents=True)
        for place in range(5):
            Image.new("RGB", (24, 16), (place * 30, 80, 80)).save(tmp_path / "two" / name / f"{place}.jpg")
    done = vpr_bench("data", "init", str(tmp_path / "two"))
    assert done.code == 0
    assert load_case(str(tmp_path / "two")).ground_truth.has_match.all()
