"""Whatever text is embedded, it comes back the same and ends no element."""

import json
from html import unescape

from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.page.embedding import as_json, breakable

texts = st.text() | st.sampled_from(["</script>", "<!--", "]]>", "&lt;", "\u2028\u2029"])


@given(st.recursive(texts | st.integers() | st.none(), lambda part: st.lists(part) | st.dictionaries(texts, part)))
def test_json_reads_back_and_holds_nothing_that_html_knows(value):
    text = str(as_json(value))
    assert json.loads(text) == value
    assert not set("<>&\u2028\u2029") & set(text)


def test_what_is_not_a_number_is_null_however_deep():
    assert as_json({"a": [1.5, float("nan"), (float("inf"),)]}) == '{"a":[1.5,null,[null]]}'


@given(texts)
def test_breakable_text_reads_as_it_was_and_is_escaped(text):
    marked = str(breakable(text))
    assert unescape(marked.replace("<wbr>", "")) == unescape(text) or unescape(marked.replace("<wbr>", "")) == text
    assert "<" not in marked.replace("<wbr>", "")
