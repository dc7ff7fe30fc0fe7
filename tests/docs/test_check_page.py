"""The page about checks names every check, and says what each one does."""

from pathlib import Path

import pytest

from vpr_bench.check.dataset import DATASET_CHECKS
from vpr_bench.check.env import ENV_CHECKS
from vpr_bench.check.method import METHOD_CHECKS

PAGE = (Path(__file__).parents[2] / "docs" / "check.md").read_text("utf-8")


@pytest.mark.parametrize("check", [*METHOD_CHECKS, *DATASET_CHECKS, *ENV_CHECKS], ids=lambda check: check.id)
def test_every_check_is_on_the_page(check):
    assert f"| `{check.id}` | {check.summary} |\n" in PAGE
