import os
import shutil
import socket
from contextlib import contextmanager
from pathlib import Path

import pytest

from vpr_bench.download import DiskError, download
from vpr_bench.download.partial import Partial
from vpr_bench.errors import DataError, UsageError
from vpr_bench.progress import listen

BODY = os.urandom(500_000)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def broken_download(page, target, bytes_arrived):
    """Leave a part behind, as a process does that gave up."""
    page.cut_after = [bytes_arrived]
    with pytest.raises(DataError):
        download(page.url, target, attempts=1)
    assert not target.exists()
    return (target.parent / f"{target.name}.part").stat().st_size


def test_plain_download(server, tmp_path):
    page = server.add("/a.bin", BODY)
    target = tmp_path / "new" / "a.bin"
    assert download(page.url, target, sha256=page.sha256) == target
    assert target.read_bytes() == BODY
    assert names(target.parent) == ["a.bin"]


def test_empty_file(server, tmp_path):
    download(server.add("/a.bin", b"").url, tmp_path / "a.bin")
    assert (tmp_path / "a.bin").read_bytes() == b""


@pytest.mark.parametrize("version", [{}, {"etag": None, "modified": "Thu, 01 Jan 2015 00:00:00 GMT"}])
def test_resume_asks_only_for_the_missing_bytes(server, tmp_path, version):
    page = server.add("/a.bin", BODY, **version)
    have = broken_download(page, tmp_path / "a.bin", 300_000)
    assert 200_000 < have <= 300_000
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert page.requests[-1]["Range"] == f"bytes={have}-"
    assert page.sent == [300_000, len(BODY) - have]
    assert names(tmp_path) == ["a.bin"]


def test_truncated_body_is_tried_again_and_resumed(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY, cut_after=[200_000, 200_000])
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert len(page.requests) == 3
    assert sum(page.sent) < len(BODY) + 3 * 65_536
    assert pauses == [1.0, 2.0]


def test_always_truncated_body_is_given_up(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY, ranges=False, cut_after=[200_000] * 9)
    with pytest.raises(DataError, match="broke off"):
        download(page.url, tmp_path / "a.bin")
    assert len(page.requests) == 5
    assert not (tmp_path / "a.bin").exists()


def test_tries_that_bring_much_are_not_counted(server, tmp_path, pauses):
    page = server.add("/a.bin", os.urandom(9_000_000), cut_after=[1_500_000] * 5)
    download(page.url, tmp_path / "a.bin", sha256=page.sha256, attempts=2)
    assert len(page.requests) == 6


@pytest.mark.parametrize(
    "change",
    [
        {"ranges": False},
        {"body": BODY[::-1], "etag": '"v2"'},
        {"body": BODY[::-1], "etag": '"v2"', "if_range": False},
        {"body": BODY[:1000], "etag": '"v2"', "if_range": False},
    ],
    ids=["no ranges", "changed", "changed unnoticed", "changed and shorter"],
)
def test_starts_again_when_the_server_cannot_continue(server, tmp_path, pauses, change):
    page = server.add("/a.bin", BODY)
    broken_download(page, tmp_path / "a.bin", 300_000)
    for name, value in change.items():
        setattr(page, name, value)
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert (tmp_path / "a.bin").read_bytes() == page.body
    assert page.sent[-1] == len(page.body)


def test_file_that_changes_between_tries(server, tmp_path, monkeypatch):
    page = server.add("/a.bin", BODY, cut_after=[300_000])

    def change(seconds):
        page.body, page.etag = BODY[::-1], '"v2"'

    monkeypatch.setattr("vpr_bench.download.http.time.sleep", change)
    download(page.url, tmp_path / "a.bin")
    assert (tmp_path / "a.bin").read_bytes() == BODY[::-1]


@pytest.mark.parametrize("etag", [None, 'W/"v1"'])
def test_nothing_is_resumed_without_a_strong_validator(server, tmp_path, etag):
    page = server.add("/a.bin", BODY, etag=etag)
    broken_download(page, tmp_path / "a.bin", 300_000)
    download(page.url, tmp_path / "a.bin")
    assert "Range" not in page.requests[-1]
    assert (tmp_path / "a.bin").read_bytes() == BODY


def test_part_of_another_address_is_not_continued(server, tmp_path):
    broken_download(server.add("/a.bin", BODY), tmp_path / "a.bin", 300_000)
    other = server.add("/b.bin", BODY[::-1])
    download(other.url, tmp_path / "a.bin")
    assert (tmp_path / "a.bin").read_bytes() == BODY[::-1]


def test_complete_part_needs_no_further_bytes(server, tmp_path):
    page = server.add("/a.bin", BODY)
    broken_download(page, tmp_path / "a.bin", 300_000)
    (tmp_path / "a.bin.part").write_bytes(BODY)
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert page.sent == [300_000]
    assert names(tmp_path) == ["a.bin"]


def test_damaged_note_means_starting_again(server, tmp_path):
    page = server.add("/a.bin", BODY)
    broken_download(page, tmp_path / "a.bin", 300_000)
    (tmp_path / "a.bin.part.json").write_text("[]")
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert page.sent == [300_000, len(BODY)]


def test_wrong_digest_leaves_nothing(server, tmp_path):
    page = server.add("/a.bin", BODY)
    with pytest.raises(DataError, match=r"/a\.bin has digest sha256:.*expected sha256:0000") as raised:
        download(page.url, tmp_path / "a.bin", sha256="sha256:" + "0" * 64)
    assert raised.value.exit_code == 3
    assert "Try again" in str(raised.value)
    assert names(tmp_path) == []


def test_wrong_digest_of_a_resumed_part_lets_the_next_try_succeed(server, tmp_path):
    page = server.add("/a.bin", BODY)
    broken_download(page, tmp_path / "a.bin", 300_000)
    (tmp_path / "a.bin.part").write_bytes(bytes(1000))
    with pytest.raises(DataError, match="digest"):
        download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    assert (tmp_path / "a.bin").read_bytes() == BODY


@pytest.mark.parametrize(("status", "words"), [(404, "no such file"), (403, "refused"), (418, "unexpected answer")])
def test_lasting_statuses_are_not_tried_again(server, tmp_path, pauses, status, words):
    page = server.add("/a.bin", statuses=[status])
    with pytest.raises(DataError, match=rf"{words} \(status {status}\)"):
        download(page.url, tmp_path / "a.bin")
    assert len(page.requests) == 1
    assert names(tmp_path) == []


def test_passing_statuses_are_tried_again(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY, statuses=[500, 503, 429])
    with pytest.raises(DataError, match="status 429"):
        download(page.url, tmp_path / "a.bin", attempts=3)
    page.statuses = [500, 503]
    download(page.url, tmp_path / "a.bin", attempts=3)
    assert (tmp_path / "a.bin").read_bytes() == BODY


def test_no_network_is_one_clear_line_without_the_secrets(tmp_path, pauses, monkeypatch):
    monkeypatch.setenv("NO_PROXY", "*")
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))  # bound and not listening: connections are refused
        url = f"http://me:secret@127.0.0.1:{unused.getsockname()[1]}/a.bin?token=secret"
        with pytest.raises(DataError, match="cannot be reached from here") as raised:
            download(url, tmp_path / "a.bin")
    assert "secret" not in str(raised.value)
    assert "\n" not in str(raised.value)
    assert len(pauses) == 1


def test_proxy_that_is_not_there(tmp_path, pauses, monkeypatch):
    monkeypatch.setenv("NO_PROXY", "")
    monkeypatch.setenv("HTTP_PROXY", "http://me:secret@127.0.0.1:9")
    with pytest.raises(DataError, match="the proxy cannot be reached") as raised:
        download("http://example.org/a.bin", tmp_path / "a.bin")
    assert "secret" not in str(raised.value)


def test_no_secure_connection(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY)
    with pytest.raises(DataError, match="no secure connection"):
        download(page.url.replace("http:", "https:"), tmp_path / "a.bin")
    assert pauses == []


def test_silent_server_is_given_up(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY, hold_after=100_000)
    with pytest.raises(DataError, match=r"stopped answering"):
        download(page.url, tmp_path / "a.bin", attempts=2, timeout_s=0.1)


def test_redirects_are_followed_and_limited(server, tmp_path):
    page = server.add("/a.bin", BODY)
    moved = server.add("/moved", location="/a.bin")
    download(moved.url, tmp_path / "a.bin", sha256=page.sha256)
    loop = server.add("/loop", location="/loop")
    with pytest.raises(DataError, match="more than 5 redirects"):
        download(loop.url, tmp_path / "b.bin")
    assert len(loop.requests) == 6
    leads_away = server.add("/away", location="file:///etc/passwd")
    with pytest.raises(DataError, match="cannot be followed"):
        download(leads_away.url, tmp_path / "b.bin")
    assert names(tmp_path) == ["a.bin"]


@pytest.mark.parametrize("url", ["file:///etc/passwd", "ftp://example.org/a", "a.bin", "http://", "http://[::1"])
def test_other_addresses_are_refused(tmp_path, url):
    with pytest.raises(UsageError, match="Only http"):
        download(url, tmp_path / "a.bin")


def test_largest_size(server, tmp_path):
    page = server.add("/a.bin", BODY)
    download(page.url, tmp_path / "a.bin", max_bytes=len(BODY))
    with pytest.raises(DataError, match=r"larger than the 400\.0 kB allowed"):
        download(page.url, tmp_path / "b.bin", max_bytes=400_000)
    assert names(tmp_path) == ["a.bin"]


def test_size_that_is_not_stated(server, tmp_path, pauses):
    page = server.add("/a.bin", BODY, sized=False)
    download(page.url, tmp_path / "a.bin", sha256=page.sha256)
    with pytest.raises(DataError, match=r"larger than the 400\.0 kB allowed"):
        download(page.url, tmp_path / "b.bin", max_bytes=400_000)
    assert names(tmp_path) == ["a.bin"]
    page.sized = True
    broken_download(page, tmp_path / "b.bin", 300_000)
    page.sized, page.cut_after = False, [100_000]  # now only Content-Range tells that something is missing
    with pytest.raises(DataError, match="of 500000 bytes arrived"):
        download(page.url, tmp_path / "b.bin", attempts=1)
    download(page.url, tmp_path / "b.bin")
    assert (tmp_path / "b.bin").read_bytes() == BODY


def test_folder_that_cannot_be_made(server, tmp_path):
    (tmp_path / "file").touch()
    page = server.add("/a.bin", BODY)
    with pytest.raises(DiskError, match=r"is in the way.*VPR_BENCH_DATA"):
        download(page.url, tmp_path / "file" / "a.bin")
    assert page.requests == []


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_disk_that_fills_up(server, tmp_path, monkeypatch):
    monkeypatch.setattr(Partial, "start", lambda part, headers: part.path.symlink_to("/dev/full"))
    with pytest.raises(DiskError, match=r"Cannot write .*a\.bin: the disk is full"):
        download(server.add("/a.bin", BODY).url, tmp_path / "a.bin")


def test_file_larger_than_the_free_space(server, tmp_path, monkeypatch):
    usage = shutil.disk_usage(tmp_path)._replace(free=400_000)
    monkeypatch.setattr("shutil.disk_usage", lambda folder: usage)
    with pytest.raises(DiskError, match=r"500\.0 kB are needed in .* and 400\.0 kB are free"):
        download(server.add("/a.bin", BODY).url, tmp_path / "a.bin")


def test_progress_counts_bytes(server, tmp_path):
    told = []

    @contextmanager
    def listener(description, total):
        told.append([description, total, 0])

        def advance(steps):
            told[-1][2] += steps

        yield advance

    page = server.add("/a.bin", BODY)
    broken_download(page, tmp_path / "a.bin", 300_000)
    with listen(listener):
        download(page.url + "?token=secret", tmp_path / "b.bin")
        download(page.url, tmp_path / "a.bin")
    assert told == [["Downloading a.bin", len(BODY), len(BODY)]] * 2
    assert "secret" not in str(told)
