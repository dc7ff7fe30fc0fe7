"""Start-up is light: what only names things imports nothing that computes."""

import subprocess
import sys

import pytest

import vpr_bench

HEAVY = {"cv2", "gymnasium", "matplotlib", "pandas", "scipy", "sklearn", "torch"}
COMMAND = """
from vpr_bench.cli import main
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
"""


def heavy_after(code, *arguments):
    """Run Python code in a fresh process and return which heavy packages it imported."""
    script = f"import sys\n{code}\nprint('imported:', *sorted({HEAVY!r} & sys.modules.keys()))"
    done = subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[-1].split()[1:]


@pytest.mark.parametrize(
    "arguments",
    [
        ["--help"],
        ["list"],
        ["info", "gardens"],
        ["info", "twostage"],
        ["weights", "list"],
        ["fit", "--help"],
        ["locate", "--help"],
        ["leaderboard", "--help"],
        ["compare", "--help"],
        ["gate", "--help"],
        ["reproduce", "--help"],
    ],
    ids=" ".join,
)
def test_commands_that_only_name_things_import_nothing_heavy(arguments):
    assert heavy_after(COMMAND, *arguments) == []


def test_the_pytest_plug_in_imports_nothing_heavy():
    """Every pytest session of an environment with vpr-bench loads it."""
    assert heavy_after("import vpr_bench.gate.fixture") == []


def test_a_map_is_asked_without_what_only_fitting_and_drawing_need(tiny_images, tmp_path):
    fitted, photo = str(tmp_path / "hog.map"), str(tiny_images / "day_right" / "Image003.jpg")
    words = ["fit", "-m", "hog", "-p", "width=64", "-p", "height=64", "--images", str(tiny_images / "day_left")]
    heavy_after(COMMAND, *words, "-o", fitted)
    assert heavy_after(COMMAND, "info", fitted) == []
    assert heavy_after(COMMAND, "locate", fitted, photo) == ["cv2"]


@pytest.mark.parametrize(
    "code",
    [
        "import vpr_bench.types.protocol",
        "from vpr_bench.method.build import METHODS; [entry.summary() for entry in METHODS.entries()]",
        "from vpr_bench.dataset.card import DATASETS; assert 'gardens' in DATASETS.load_all()",
        "import vpr_bench; vpr_bench.Traverse, vpr_bench.Match, vpr_bench.load_case",
    ],
    ids=["protocol", "methods", "cards", "package"],
)
def test_modules_that_only_name_things_import_nothing_heavy(code):
    assert heavy_after(code) == []


def test_the_check_sees_what_is_imported():
    assert "cv2" in heavy_after("import vpr_baselines.photometry")


def test_public_names_are_there_and_others_are_not():
    for name in vpr_bench.__all__:
        assert getattr(vpr_bench, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'Metods'"):
        vpr_bench.Metods  # noqa: B018
