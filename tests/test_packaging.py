"""What is installed is what is in the tree."""

import tomllib
from importlib.metadata import entry_points
from pathlib import Path

ROOT = Path(__file__).parents[1]
ROOTS = {"vpr_bench": ROOT, "vpr_baselines": ROOT / "baselines", "vpr_datasets": ROOT / "datasets"}


def test_every_package_is_listed():
    listed = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]["packages"]
    found = {
        ".".join(module.parent.relative_to(root).parts)
        for name, root in ROOTS.items()
        for module in (root / name).rglob("*.py")
    }
    assert set(listed) == found


def test_our_own_plug_ins_come_through_the_same_door():
    for group in ("vpr_bench.methods", "vpr_bench.datasets"):
        ours = [point for point in entry_points(group=group) if point.dist and point.dist.name == "vpr-bench"]
        assert ours
        for point in ours:
            assert point.load() is not None


def test_the_harness_knows_no_dataset_and_no_method_by_name():
    for module in (ROOT / "vpr_bench").rglob("*.py"):
        for line in module.read_text("utf-8").splitlines():
            assert not line.strip().startswith(
                ("from vpr_baselines", "from vpr_datasets", "import vpr_baselines", "import vpr_datasets")
            )
