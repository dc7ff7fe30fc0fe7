import os

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_bench.files.images import natural_key
from vpr_datasets.layouts import texts
from vpr_datasets.layouts.texts import parse_number, quoted, read_text


def refused(file):
    with pytest.raises(DataError) as caught:
        read_text(file)
    message = str(caught.value)
    assert str(file) in message and "\n" not in message
    return message


def test_a_mark_and_ends_of_lines_do_not_matter(tmp_path):
    file = tmp_path / "a.txt"
    file.write_bytes(b"\xef\xbb\xbfone\r\ntwo\rthree\n")
    assert read_text(file) == "one\ntwo\nthree\n"


def test_a_file_of_another_encoding_is_refused(tmp_path):
    file = tmp_path / "a.txt"
    file.write_bytes("größe".encode("latin-1"))
    assert "is not UTF-8 text (at byte 2)" in refused(file)


def test_a_large_file_is_not_read(tmp_path, monkeypatch):
    file = tmp_path / "a.txt"
    file.write_text("12345")
    monkeypatch.setattr(texts, "LARGEST", 4)
    assert "it has 5 bytes, more than the 4" in refused(file)


def test_what_is_no_file_is_missing(tmp_path):
    assert "is missing" in refused(tmp_path / "none.txt")
    assert "is missing" in refused(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    assert "is missing" in refused(tmp_path / "pipe")


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_number_is_read_as_it_was_written(number):
    assert parse_number(repr(number)) == number


@pytest.mark.parametrize(
    "text", ["", " ", "nan", "inf", "-Infinity", "1_000", "1,5", "0x10", "1e999", "१", "1 2", "--1"]
)
def test_what_is_no_number_is_refused(text):
    with pytest.raises(ValueError, match="is not a number"):
        parse_number(text)


def test_a_long_value_is_cut_and_stays_on_its_line():
    assert quoted("a\nb\x1b[31m") == r"'a\nb\x1b[31m'"
    assert len(quoted("x" * 10_000)) < 60


@given(st.lists(st.text(max_size=6)))
def test_any_names_can_be_put_in_order(names):
    assert sorted(sorted(names, reverse=True), key=natural_key) == sorted(names, key=natural_key)


@given(st.lists(st.integers(0, 10**6), unique=True))
def test_numbers_in_names_count_as_numbers(numbers):
    names = [f"key-640-{number}.jpg" for number in numbers]
    assert sorted(names, key=natural_key) == [f"key-640-{number}.jpg" for number in sorted(numbers)]
