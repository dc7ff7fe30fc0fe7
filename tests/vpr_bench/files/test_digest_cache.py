import os

import pytest

from vpr_bench.errors import DataError
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.files.digest_cache import sha256_of_files

LONG_AGO = 1_000_000_000


@pytest.fixture
def files(tmp_path):
    folder = tmp_path / "images"
    folder.mkdir()
    paths = [folder / name for name in "ab"]
    for path in paths:
        path.write_text(path.name)
        os.utime(path, ns=(LONG_AGO, LONG_AGO))
    return paths


@pytest.fixture
def reads(monkeypatch):
    seen = []

    def read(path):
        seen.append(path.name)
        return sha256_of_file(path)

    monkeypatch.setattr("vpr_bench.files.digest_cache.sha256_of_file", read)
    return seen


def test_a_file_that_was_not_touched_is_read_once(files, reads, tmp_path):
    first = sha256_of_files(files, tmp_path / "cache")
    assert sha256_of_files(files[::-1], tmp_path / "cache") == first[::-1] == [sha256_of_file(f) for f in files[::-1]]
    assert reads == ["a", "b"]


def test_a_file_that_changed_is_read_again(files, reads, tmp_path):
    before = sha256_of_files(files, tmp_path / "cache")
    files[0].write_text("A")
    os.utime(files[0], ns=(LONG_AGO, LONG_AGO + 1))
    after = sha256_of_files(files, tmp_path / "cache")
    assert after[0] != before[0] and after[1] == before[1]
    assert reads == ["a", "b", "a"]


def test_a_file_that_may_still_be_changing_is_not_remembered(files, reads, tmp_path):
    files[0].write_text("now")
    for _ in range(2):
        sha256_of_files(files, tmp_path / "cache")
    assert reads == ["a", "b", "a"]


def test_without_a_cache_every_file_is_read(files, reads):
    for _ in range(2):
        sha256_of_files(files, None)
    assert reads == ["a", "b", "a", "b"]


@pytest.mark.parametrize("content", ["", "[]", "{", '{"a": 1}', '{"a": [1, 1000000000]}'])
def test_a_damaged_cache_is_as_good_as_none(files, tmp_path, content):
    expected = sha256_of_files(files, tmp_path / "cache")
    next((tmp_path / "cache").iterdir()).write_text(content)
    assert sha256_of_files(files, tmp_path / "cache") == expected


def test_a_cache_that_cannot_be_written_is_done_without(files, tmp_path):
    (tmp_path / "cache").write_text("a file in place of a folder")
    assert len(sha256_of_files(files, tmp_path / "cache")) == 2


def test_a_missing_file_is_a_data_error(files, tmp_path):
    files[1].unlink()
    with pytest.raises(DataError, match="Cannot read"):
        sha256_of_files(files, tmp_path / "cache")
