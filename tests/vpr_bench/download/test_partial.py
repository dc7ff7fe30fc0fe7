import pytest

from vpr_bench.download.partial import parse_content_range


@pytest.mark.parametrize(
    "text", ["", "bytes", "bytes 0-9", "items 0-9/10", "bytes 0-9/*", "bytes -1-9/10", "bytes 0-9/10x"]
)
def test_content_range_that_says_nothing_useful(text):
    assert parse_content_range(text) == (None, None)
