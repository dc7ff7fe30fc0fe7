import subprocess
import sys

import pytest

from vpr_bench.check import parametrize_with_checks
from vpr_bench.errors import UsageError

FILE = """
from vpr_baselines.random_answers import Random
from vpr_bench.check import parametrize_with_checks


class Found(Random):
    expected_failures = {"map-of-one": "it is shy"}


class Numbers(Random):
    def match(self, image, k):
        return 5


def made():
    return Random()


@parametrize_with_checks(["random", Found, Numbers, made], only=CHECKS)
def test_it(check):
    check()
"""


@pytest.fixture(scope="module")
def printed(tmp_path_factory):
    file = tmp_path_factory.mktemp("plugin") / "test_plugin.py"
    checks = ["answers-are-matches", "map-of-one", "reset-forgets", "finds-the-same-image"]
    file.write_text(FILE.replace("CHECKS", repr(checks)))
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-rA", "--tb=short", file.name]
    return subprocess.run(command, cwd=file.parent, capture_output=True, text=True, check=False).stdout


@pytest.mark.parametrize(
    "line",
    [
        "PASSED test_plugin.py::test_it[random-map-of-one]",
        "XFAIL test_plugin.py::test_it[random-finds-the-same-image] - answers have nothing to do with what is seen",
        "FAILED test_plugin.py::test_it[Found-map-of-one]",
        "FAILED test_plugin.py::test_it[Numbers-answers-are-matches]",
        "XFAIL test_plugin.py::test_it[made-finds-the-same-image] - answers have nothing to do with what is seen",
    ],
)
def test_each_check_is_a_test(printed, line):
    assert line in printed


def test_reasons(printed):
    assert "map-of-one: it passes, but is declared to fail (it is shy)" in printed
    assert "answers-are-matches: match answers query 0 with a int instead of a Match" in printed
    assert "it builds on answers-are-matches, which fails" in printed
    assert "it is not sequential" in printed


def test_checks_that_do_not_exist():
    with pytest.raises(UsageError, match=r"no check 'map-of-two'\. Did you mean 'map-of-one'"):
        parametrize_with_checks(["hog"], only=["map-of-two"])
