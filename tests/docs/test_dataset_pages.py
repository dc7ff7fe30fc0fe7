"""The pages of the datasets are what their cards say."""

from pathlib import Path

import pytest

from vpr_bench.dataset.card import DATASETS
from vpr_bench.report.card_page import card_page

PAGES = Path(__file__).parents[2] / "docs" / "datasets"
OURS = [entry for entry in DATASETS.entries() if entry.target.startswith("vpr_datasets.")]


@pytest.mark.parametrize("entry", OURS, ids=lambda entry: entry.name)
def test_the_page_is_written_from_the_card(entry):
    page = PAGES / f"{entry.name}.md"
    assert page.exists(), f"make it: vpr-bench info {entry.name} --format markdown > {page}"
    fresh = card_page(DATASETS.find(entry.name))
    assert page.read_text("utf-8") == fresh, f"it is stale: vpr-bench info {entry.name} --format markdown > {page}"


def test_no_page_is_left_over():
    assert {page.stem for page in PAGES.glob("*.md")} == {entry.name for entry in OURS}
