import hashlib

import pytest

from vpr_bench.download import check_digest, parse_digest, sha256_of_file
from vpr_bench.errors import DataError, UsageError


def test_digest_of_a_file(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"content")
    assert sha256_of_file(path) == f"sha256:{hashlib.sha256(b'content').hexdigest()}"
    check_digest(path, sha256_of_file(path).upper())


def test_difference_names_both_digests_and_the_next_step(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"content")
    expected = "sha256:" + "0" * 64
    with pytest.raises(DataError) as raised:
        check_digest(path, expected)
    message = str(raised.value)
    assert str(path) in message
    assert expected in message
    assert sha256_of_file(path) in message
    assert "delete it" in message
    assert raised.value.exit_code == 3


@pytest.mark.parametrize("text", ["", "sha256:", "sha256:" + "g" * 64, "0" * 64, "md5:" + "0" * 32])
def test_what_is_not_a_digest_is_refused(text):
    with pytest.raises(UsageError, match="sha256:<64 hex"):
        parse_digest(text)


def test_missing_file(tmp_path):
    with pytest.raises(DataError, match=r"Cannot read .*No such file"):
        sha256_of_file(tmp_path / "none")
