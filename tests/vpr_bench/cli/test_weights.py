import json
import sys
import types

import pytest
import torch

from vpr_bench.registry import Entry
from vpr_bench.weights.card import WEIGHTS, WeightsCard
from vpr_bench.weights.digest import file_digest

pytestmark = pytest.mark.usefixtures("data_folder", "pauses")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Return the empty folder of weights."""
    folder = tmp_path / "weights"
    folder.mkdir()
    monkeypatch.setenv("VPR_BENCH_WEIGHTS", str(folder))
    return folder


@pytest.fixture
def tiny(folder, server, monkeypatch, tmp_path):
    """Register weights that the local server has; return their page, and a function that changes their card."""
    torch.save({"fc.weight": torch.ones(2, 3)}, tmp_path / "tiny.pth")
    page = server.add("/tiny.pth", (tmp_path / "tiny.pth").read_bytes())
    plugin = types.ModuleType("tiny_weights")
    monkeypatch.setitem(sys.modules, "tiny_weights", plugin)
    entry = Entry("tiny-dots", "tiny_weights:card", "tiny-plugin 1.0")
    monkeypatch.setitem(vars(WEIGHTS), "_found", {**WEIGHTS._found, "tiny-dots": [entry]})

    def register(**changes):
        fields = {
            "id": "tiny-dots",
            "name": "Tiny",
            "architecture": "tiny",
            "training_set": "Dots",
            "input_size": (8, 8),
            "mean": (0.5, 0.5, 0.5),
            "std": (0.5, 0.5, 0.5),
            "licence": "CC0 1.0",
            "homepage": "https://example.org",
            "file": "tiny.pth",
            "url": page.url,
        }
        plugin.card = WeightsCard(**{**fields, **changes})

    register()
    return types.SimpleNamespace(page=page, register=register, file=folder / "tiny.pth")


def test_list_says_where_weights_are_or_how_to_get_them(vpr_bench, tiny):
    done = vpr_bench("weights", "list")
    assert done.code == 0
    for fact in ("not here: vpr-bench weights fetch tiny-dots", "CC0 1.0", "Dots", "resnet18-places365", "CC BY"):
        assert fact in done.out
    assert "efficientnet-lite0-57934424.pth" in "".join(done.out.split())  # they are here


def test_list_for_programs(vpr_bench, tiny):
    listed = {one["id"]: one for one in json.loads(vpr_bench("weights", "list", "--format", "json").out)}
    assert listed["tiny-dots"]["path"] is None and listed["tiny-dots"]["mean"] == [0.5, 0.5, 0.5]
    assert listed["efficientnet-lite0-imagenet"]["path"].endswith("efficientnet-lite0-57934424.pth")


def test_fetch_then_path_then_verify(vpr_bench, tiny):
    tiny.page.cut_after = [500]
    fetched = vpr_bench("weights", "fetch", "tiny-dots")
    assert (fetched.code, fetched.out.strip()) == (0, str(tiny.file))
    assert "CC0 1.0" in fetched.err
    assert tiny.page.requests[1]["Range"] == "bytes=500-"
    assert vpr_bench("weights", "path", "tiny-dots").out.strip() == str(tiny.file)
    verified = vpr_bench("weights", "verify", "tiny-dots")
    assert verified.code == 0 and file_digest(tiny.file) in verified.out
    assert "not here: vpr-bench weights fetch tiny-dots" not in vpr_bench("weights", "list").out


def test_path_of_the_folder(vpr_bench, folder):
    assert vpr_bench("weights", "path").out.strip() == str(folder)


@pytest.mark.parametrize("command", ["path", "verify"])
def test_what_is_not_here(vpr_bench, tiny, command):
    done = vpr_bench("weights", command, "tiny-dots")
    assert done.code == 3
    assert "vpr-bench weights fetch tiny-dots" in done.err and str(tiny.file.parent) in done.err.replace("\n", "")


@pytest.mark.parametrize("command", ["path", "verify", "fetch"])
def test_what_does_not_exist(vpr_bench, tiny, command):
    done = vpr_bench("weights", command, "tiny-dot")
    assert done.code == 2
    assert "Did you mean 'tiny-dots'?" in done.err


def test_fetching_what_is_not_what_was_published(vpr_bench, tiny):
    tiny.register(sha256_prefix="0" * 8)
    assert vpr_bench("weights", "fetch", "tiny-dots").code == 3
    assert not tiny.file.exists()


def test_fetching_from_a_server_that_does_not_have_it(vpr_bench, tiny):
    tiny.page.statuses = [404]
    done = vpr_bench("weights", "fetch", "tiny-dots")
    assert done.code == 3
    assert "404" in done.err


def test_verifying_what_is_here_leaves_out_what_is_not(vpr_bench, tiny):
    done = vpr_bench("weights", "verify")
    assert done.code == 0
    assert "efficientnet-lite0-imagenet: sha256:57934424" in done.out
    assert "tiny-dots: not here" in done.out


def test_another_file_than_the_first_one_can_be_accepted(vpr_bench, tiny):
    assert vpr_bench("weights", "fetch", "tiny-dots").code == 0
    torch.save({"fc.weight": torch.zeros(2, 3)}, tiny.file)
    done = vpr_bench("weights", "verify", "tiny-dots")
    assert done.code == 1
    assert "not the file that was met here first" in done.err
    assert vpr_bench("weights", "verify", "--accept").code == 2
    assert vpr_bench("weights", "verify", "tiny-dots", "--accept").code == 0
    assert vpr_bench("weights", "verify", "tiny-dots").code == 0


def test_damaged_weights(vpr_bench, tiny):
    tiny.file.write_bytes(b"no weights")
    assert vpr_bench("weights", "verify", "tiny-dots").code == 3
    tiny.register(sha256_prefix="0" * 8)
    done = vpr_bench("weights", "verify")
    assert done.code == 3
    assert "damaged or another file" in done.err
