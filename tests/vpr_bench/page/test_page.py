"""The page as a file: the same every time, complete, closed to the outside, and no larger than agreed."""

import re
import subprocess
import sys

import pytest

from vpr_bench.errors import DataError
from vpr_bench.page import page as module
from vpr_bench.page.libraries import chart_library, script_digest, table_library
from vpr_bench.page.page import write_page


@pytest.fixture(scope="module")
def html(page_file):
    return page_file.read_text("utf-8")


def test_the_same_boards_give_the_same_bytes(made, page_file, tmp_path):
    again = write_page(made.boards, made.runs, tmp_path / "again.html", pytest.fail)
    assert again.read_bytes() == page_file.read_bytes()


def test_only_scripts_of_known_digest_may_run_and_nothing_may_be_fetched(html):
    policy = re.search('Content-Security-Policy" content="([^"]*)"', html)[1]
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    allowed = set(re.findall(r"'(sha256-[^']*)'", policy))
    inline = {script_digest(text) for text in re.findall(r"<script>(.*?)</script>", html, re.S)}
    assert len(inline) == 2
    assert allowed == inline | {chart_library().digest, table_library().digest}
    assert "unsafe" not in policy.replace("style-src 'unsafe-inline'", "")
    assert not re.search(r"""(src|href)=["']?(https?:)?//""", html)


def test_it_names_its_date_and_version_and_the_libraries_with_their_licences(html):
    assert 'datetime="2026-01-05"' in html
    assert "plotly.js, from plotly" in html and "DataTables, from itables" in html


def test_no_name_becomes_markup(html, hostile):
    assert "<b>they</b>" not in html and "<i>who</i>" not in html and "<u>chip" not in html
    assert "<img src=x" not in html and "<script>alert" not in html
    assert "\u202e" not in html and "\u2028" not in html


def test_every_table_has_a_caption_and_every_protocol_a_heading(html):
    assert html.count("<table") == html.count("<caption")
    assert html.count('<section class="protocol"') == html.count('<h2 id="title-') == 3


def test_pictures_shrink_until_the_page_is_small_enough(made, page_file, tmp_path, monkeypatch):
    monkeypatch.setattr(module, "LIMIT", page_file.stat().st_size - 10_000)
    monkeypatch.setattr(module, "LEAST", 0)
    said = []
    smaller = write_page(made.boards, made.runs, tmp_path / "small.html", said.append)
    assert smaller.stat().st_size < page_file.stat().st_size - 5_000
    assert all("pictures" in line for line in said)


def test_a_file_of_somebody_else_is_not_written_over(made, tmp_path):
    file = tmp_path / "index.html"
    file.write_text("<!doctype html><title>mine</title>")
    with pytest.raises(DataError, match="was not made by `vpr-bench leaderboard`"):
        write_page(made.boards, {}, file, pytest.fail)
    assert file.read_text() == "<!doctype html><title>mine</title>"


def test_a_page_is_written_over_a_page(made, tmp_path):
    file = tmp_path / "index.html"
    write_page(made.boards, {}, file, pytest.fail)
    before = file.stat().st_ino
    write_page(made.boards, {}, file, pytest.fail)
    assert file.stat().st_ino != before


def test_a_disk_that_refuses_is_reported_and_nothing_is_left(made, tmp_path):
    with pytest.raises(DataError):
        write_page(made.boards, {}, tmp_path / "missing" / "index.html", pytest.fail)
    assert list(tmp_path.iterdir()) == []


def test_making_a_page_imports_no_library_for_its_javascript():
    code = "import sys, vpr_bench.page.page; vpr_bench.page.page.chart_library(); vpr_bench.page.page.table_library();"
    code += "sys.exit(any(name in sys.modules for name in ('plotly', 'itables', 'torch')))"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0
