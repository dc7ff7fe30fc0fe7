"""A method in somebody else's package: installed by pip, found by its entry point, run by its name."""

import json
import os
import shutil
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[1] / "example_plugin"


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Install the example package into a folder of its own, offline."""
    try:
        able = tuple(map(int, version("setuptools").split(".")[:2])) >= (70, 1)
    except PackageNotFoundError:
        able = False
    if not able:
        pytest.skip("an offline pip install needs setuptools 70.1 or newer in this environment")
    source = tmp_path_factory.mktemp("source") / "example"  # a copy: building leaves files beside the source
    shutil.copytree(EXAMPLE, source)
    target = tmp_path_factory.mktemp("target")
    words = ["install", "--quiet", "--no-deps", "--no-build-isolation", "--no-index", "--target", target, source]
    done = subprocess.run([sys.executable, "-m", "pip", *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return target


def vpr_bench(installed, folder, *words):
    command = [Path(sys.executable).with_name("vpr-bench"), *words]
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_it_is_listed_with_where_it_comes_from(installed, tmp_path):
    methods = json.loads(vpr_bench(installed, tmp_path, "list", "methods", "--format", "json"))["methods"]
    ours = next(one for one in methods if one["name"] == "mean-colour")
    assert ours["from"] == "mean-colour-place 1.2"
    assert ours["what"] == "Compares the mean colours of a grid of cells."


def test_it_is_run_by_its_name(installed, tmp_path, tiny_dataset):
    words = ("--dataset", str(tiny_dataset.folder), "--protocol", "day_left-day_right", "--format", "json")
    rows = json.loads(vpr_bench(installed, tmp_path, "run", "--method", "mean-colour", "--param", "cells=3", *words))
    assert rows[0]["method"] == "mean-colour(cells=3)"
    assert rows[0]["metrics"]["recall@1"] > 0.9
    record = json.loads(next((tmp_path / "runs").rglob("run.json")).read_text())
    assert record["key"]["version"].startswith("source:")
