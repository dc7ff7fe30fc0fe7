"""The ids are there whichever package is imported first, and importing ours does not import Gymnasium."""

import subprocess
import sys

import pytest

from vpr_bench.envs.hook import make_ids_known

FOUND = "assert 'vpr_bench/Gardens-v0' in gymnasium.registry, list(gymnasium.registry)"


def in_fresh_process(code):
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize(
    "code",
    [
        f"import vpr_bench\nimport gymnasium\n{FOUND}",
        f"import gymnasium\nimport vpr_bench\n{FOUND}",
        f"import vpr_bench\nfrom gymnasium.envs.registration import registry\nimport gymnasium\n{FOUND}",
        "import gymnasium\ngymnasium.envs.registration._find_spec('vpr_bench:vpr_bench/Gardens-v0')",
    ],
    ids=["ours first", "theirs first", "a part of theirs", "by module and id"],
)
def test_the_ids_are_known(code):
    in_fresh_process(code)


def test_importing_ours_does_not_import_theirs():
    in_fresh_process("import sys, vpr_bench\nassert 'gymnasium' not in sys.modules and 'numpy' not in sys.modules")


def test_nothing_is_left_behind():
    in_fresh_process(
        "import sys, vpr_bench, importlib.util\n"
        "assert importlib.util.find_spec('gymnasium').origin.endswith('__init__.py')\n"
        "import inspect, gymnasium\n"
        "assert not any(type(finder).__module__.startswith('vpr_bench') for finder in sys.meta_path)\n"
        "assert not type(gymnasium.__spec__.loader).__module__.startswith('vpr_bench')\n"
        "assert gymnasium.__loader__ is gymnasium.__spec__.loader\n"
        "assert inspect.getsource(gymnasium)\n"
    )


def test_an_import_that_fails_can_be_tried_again(tmp_path):
    broken = tmp_path / "gymnasium"
    broken.mkdir()
    (broken / "__init__.py").write_text("raise ImportError('half installed')")
    in_fresh_process(
        f"import sys\nsys.path.insert(0, {str(tmp_path)!r})\nimport vpr_bench\n"
        "try:\n    import gymnasium\nexcept ImportError as error:\n    assert 'half installed' in str(error)\n"
        f"sys.path.pop(0)\nimport importlib\nimportlib.invalidate_caches()\nimport gymnasium\n{FOUND}"
    )


def test_making_them_known_again_changes_nothing():
    import gymnasium

    before = dict(gymnasium.registry)
    make_ids_known()
    assert gymnasium.registry == before
