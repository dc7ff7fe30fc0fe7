from html.parser import HTMLParser

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from vpr_bench.errors import one_line
from vpr_bench.report.foreign import guarded, guarded_cells, plain, shortened, unguarded
from vpr_bench.report.grid import Grid

markdown_it = pytest.importorskip("markdown_it")


class Cells(HTMLParser):
    """Collects the text of every cell, and the tags that are not those of a table."""

    def __init__(self):
        super().__init__()
        self.texts, self.tags, self.within = [], set(), False

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.within = tag == "td"
        if self.within:
            self.texts.append("")

    def handle_endtag(self, tag):
        self.within = self.within and tag != "td"

    def handle_data(self, data):
        if self.within:
            self.texts[-1] += data


def rendered(page):
    cells = Cells()
    cells.feed(markdown_it.MarkdownIt("commonmark").enable(["table", "strikethrough"]).render(page))
    return cells


MARKS = st.text("ab_*`\\|<>&;[]()!#~$@:/.-+= 1\n\u05d0\u202e\x1b", max_size=30)


@given(MARKS)
@example("<script>alert(1)</script>")
@example("[x](http://example.org)")
@example("![x](y) &lt; &amp;lt; \\| `a|b` ~~c~~ __d__")
@example("<img src=x onerror=1>[a](javascript:1)")
def test_a_renderer_shows_the_cells_of_a_grid_as_they_are(text):
    cells = rendered(Grid("", ["name", "value"], [[text, "1"]]).markdown())
    assert cells.texts == [(one_line(text).strip() or "?") if text else "", "1"]
    assert cells.tags == {"table", "thead", "tbody", "tr", "th", "td"}


@given(MARKS)
@example("10. item")
@example("1) item")
@example("- item")
@example("---")
def test_a_line_of_its_own_begins_nothing(text):
    assert rendered(plain(text)).tags == {"p"}


@pytest.mark.parametrize(
    "text", ["-0.123", "+0.050", "recall@1", "1.5", ".86–.95", "gardens/day_left-night_right@2f", "pr_auc", "hog(k=1)"]
)
def test_what_is_no_markup_stays_readable(text):
    assert plain(text) == text


@pytest.mark.parametrize("text", ["www.evil.example/x", "http://evil.example", "a@b.com", "see @somebody"])
def test_nothing_becomes_a_link_by_itself(text):
    assert plain(text) in {text.replace(mark, f"\\{mark}", 1) for mark in ".:@"}


@given(st.text())
@example("=HYPERLINK(0)")
@example("\uff1d1")
@example("\t=1")
@example("'=1")
def test_no_text_is_a_formula_and_each_is_read_back(text):
    assert guarded(text)[0] not in "=+-@\uff1d\uff0b\uff0d\uff20\t\r\n "
    assert unguarded(guarded(text)) == text


def test_numbers_are_not_guarded():
    assert guarded_cells({"a": -1.5, "b": None, "c": "-1.5"}) == {"a": -1.5, "b": None, "c": "'-1.5"}


@given(st.text(), st.integers(1, 40))
def test_a_shortened_text_has_the_ends_of_the_whole_one(text, most):
    whole, short = one_line(text) or "?", shortened(text, most)
    if len(whole) <= most:
        assert short == whole
    else:
        head, tail = short[: most // 2], short[most // 2 + 1 :]
        assert len(short) == most and short[most // 2] == "…"
        assert whole.startswith(head) and whole.endswith(tail)
