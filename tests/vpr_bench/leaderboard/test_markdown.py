from html.parser import HTMLParser

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from vpr_bench.errors import one_line
from vpr_bench.leaderboard.markdown import plain
from vpr_bench.report.grid import markdown_table

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


@given(st.text("ab_*`\\|<>&;[]()!#~$@:/.-+= 1\n\u05d0\u202e\x1b", max_size=30))
@example("<script>alert(1)</script>")
@example("[x](http://example.org)")
@example("![x](y) &lt; &amp;lt; \\| `a|b` ~~c~~ __d__")
def test_a_renderer_shows_foreign_text_as_it_is(text):
    page = markdown_table(["name", "value"], [[plain(text), "1"]])
    cells = Cells()
    cells.feed(markdown_it.MarkdownIt("commonmark").enable(["table", "strikethrough"]).render(page))
    assert cells.texts == [one_line(text).strip() or "?", "1"]
    assert cells.tags == {"table", "thead", "tbody", "tr", "th", "td"}
