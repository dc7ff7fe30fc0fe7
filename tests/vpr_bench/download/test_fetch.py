import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import pytest

from vpr_bench.download import DiskError, fetch_archive, fetch_file
from vpr_bench.errors import DataError, UsageError
from vpr_bench.progress import listen

FILES = {"day_left/Image000.jpg": bytes(range(256)) * 2000, "notes.txt": b"hello"}
WRONG = "sha256:" + "0" * 64

SCRIPT = """
import sys
from contextlib import contextmanager
from pathlib import Path
from vpr_bench.download import fetch_archive
from vpr_bench.progress import listen

@contextmanager
def listener(description, total):
    print(description, flush=True)
    yield lambda steps: None

with listen(listener):
    fetch_archive(sys.argv[1], Path(sys.argv[2]), sha256=sys.argv[3])
"""


def start(page, folder):
    command = [sys.executable, "-c", SCRIPT, page.url, str(folder), page.sha256]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def wait_for(condition):
    deadline = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.01)


def test_archive_is_fetched_once(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))
    folder = tmp_path / "data" / "gardens"
    for _ in range(2):
        assert fetch_archive(page.url, folder, sha256=page.sha256) == folder
    assert contents(folder) == FILES
    assert len(page.requests) == 1
    assert names(folder.parent) == [".gardens.lock", "gardens"]


def test_check_refuses_and_nothing_stays(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))

    def check(folder):
        assert contents(folder) == FILES
        raise DataError("day_right is missing")

    with pytest.raises(DataError, match="day_right"):
        fetch_archive(page.url, tmp_path / "gardens", sha256=None, check=check)
    assert names(tmp_path) == [".gardens.lock"]


@pytest.mark.parametrize("body", ["escape.zip", "escape.tar", "damaged", "web page"])
def test_bad_archives_leave_nothing(server, tmp_path, make_zip, make_tar, body):
    data = {
        "escape.zip": make_zip({"a": b"x", "../../evil": b"x"}),
        "escape.tar": make_tar({"a": b"x", "../../evil": b"x"}),
        "damaged": make_zip(FILES)[:-30],
        "web page": b"<html>",
    }[body]
    page = server.add("/gardens.zip", data)
    before = set(tmp_path.rglob("*"))
    with pytest.raises(DataError):
        fetch_archive(page.url, tmp_path / "a" / "b" / "gardens", sha256=page.sha256)
    left = {path.name for path in set(tmp_path.rglob("*")) - before}
    assert left == {"a", "b", ".gardens.lock"}


def test_wrong_digest_leaves_nothing(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))
    with pytest.raises(DataError, match="expected sha256:0000"):
        fetch_archive(page.url, tmp_path / "gardens", sha256=WRONG)
    assert names(tmp_path) == [".gardens.lock"]


def test_second_process_waits_and_finds_it_done(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES), hold_after=1000)
    first, second = start(page, tmp_path / "gardens"), start(page, tmp_path / "gardens")
    wait_for(lambda: page.requests)
    time.sleep(0.3)
    page.released.set()
    said = [process.communicate(timeout=10) for process in (first, second)]
    assert (first.returncode, second.returncode) == (0, 0), said
    assert contents(tmp_path / "gardens") == FILES
    assert len(page.requests) == 1


def test_waiting_is_told(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES), hold_after=1000)
    first = start(page, tmp_path / "gardens")
    wait_for(lambda: page.requests)
    second = start(page, tmp_path / "gardens")
    assert second.stdout.readline() == "Waiting for another process that is fetching gardens\n"
    page.released.set()
    for process in (first, second):
        process.communicate(timeout=10)
        assert process.returncode == 0


def test_threads_do_not_collide_either(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))
    work = {
        "target": fetch_archive,
        "args": (page.url, tmp_path / "gardens"),
        "kwargs": {"sha256": page.sha256},
    }
    threads = [threading.Thread(**work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert contents(tmp_path / "gardens") == FILES
    assert len(page.requests) == 1


def test_download_of_a_killed_process_is_continued(server, tmp_path, make_tar):
    page = server.add("/gardens.tar", make_tar(FILES), hold_after=300_000)
    process = start(page, tmp_path / "gardens")
    part = tmp_path / ".gardens.archive.part"
    wait_for(lambda: part.exists() and part.stat().st_size > 200_000)
    process.kill()
    process.communicate()
    have, page.hold_after = part.stat().st_size, None
    page.released.set()
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert page.requests[-1]["Range"] == f"bytes={have}-"
    assert page.sent[-1] == len(page.body) - have
    assert contents(tmp_path / "gardens") == FILES
    assert names(tmp_path) == [".gardens.lock", "gardens"]


def test_unpacking_of_a_killed_process_is_done_anew(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))
    (tmp_path / ".gardens.archive").write_bytes(page.body)
    (tmp_path / ".gardens.unpacking").mkdir()
    (tmp_path / ".gardens.unpacking" / "stale").touch()
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert contents(tmp_path / "gardens") == FILES
    assert page.requests == []
    assert names(tmp_path) == [".gardens.lock", "gardens"]


@pytest.mark.parametrize("verified", [True, False])
def test_stale_archive_that_cannot_be_trusted_is_replaced(server, tmp_path, make_zip, verified):
    page = server.add("/gardens.zip", make_zip(FILES))
    (tmp_path / ".gardens.archive").write_bytes(make_zip({"other": b"x"}))
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256 if verified else None)
    assert contents(tmp_path / "gardens") == FILES


def test_interruption_keeps_what_arrived_and_frees_the_lock(server, tmp_path, make_tar):
    page = server.add("/gardens.tar", make_tar(FILES))

    @contextmanager
    def listener(description, total):
        arrived = []

        def advance(steps):
            arrived.append(steps)
            if sum(arrived) > 200_000:
                raise KeyboardInterrupt

        yield advance

    with listen(listener), pytest.raises(KeyboardInterrupt):
        fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert names(tmp_path) == [".gardens.archive.part", ".gardens.archive.part.json", ".gardens.lock"]
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert "Range" in page.requests[-1]
    assert contents(tmp_path / "gardens") == FILES


def test_full_disk_keeps_the_archive_for_the_next_try(server, tmp_path, make_zip, monkeypatch):
    page = server.add("/gardens.zip", make_zip(FILES))

    def fail(needed_in, size):
        raise DiskError("the disk is full")

    with monkeypatch.context() as patch, pytest.raises(DiskError):
        patch.setattr("vpr_bench.download.archive.require_space", fail)
        fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert len(page.requests) == 1
    assert names(tmp_path) == [".gardens.lock", "gardens"]


def test_folder_behind_a_link(server, tmp_path, make_zip):
    page = server.add("/gardens.zip", make_zip(FILES))
    (tmp_path / "big").mkdir()
    (tmp_path / "gardens").symlink_to(tmp_path / "big")
    fetch_archive(page.url, tmp_path / "gardens", sha256=page.sha256)
    assert (tmp_path / "gardens").is_symlink()
    assert contents(tmp_path / "big") == FILES


def test_what_is_in_the_way(server, tmp_path):
    page = server.add("/gardens.zip", b"")
    (tmp_path / "file").touch()
    with pytest.raises(DataError, match="is a file, and a folder is to be made there"):
        fetch_archive(page.url, tmp_path / "file", sha256=None)
    for fetch in (fetch_archive, fetch_file):
        with pytest.raises(DiskError, match="is in the way"):
            fetch(page.url, tmp_path / "file" / "gardens", sha256=None)
    assert page.requests == []


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="the system has no /proc")
def test_folder_that_cannot_be_written(server):
    for fetch in (fetch_archive, fetch_file):
        with pytest.raises(DiskError, match="Cannot write /proc"):
            fetch(server.add("/gardens.zip", b"").url, Path("/proc/gardens"), sha256=None)


def test_file_is_fetched_once_and_verified_every_time(server, tmp_path):
    page = server.add("/weights.bin", b"weights")
    path = tmp_path / "new" / "weights.bin"
    for _ in range(2):
        assert fetch_file(page.url, path, sha256=page.sha256) == path
    assert path.read_bytes() == b"weights"
    assert len(page.requests) == 1
    assert names(path.parent) == [".weights.bin.lock", "weights.bin"]
    path.write_bytes(b"my own weights")
    with pytest.raises(DataError, match="Move or delete it"):
        fetch_file(page.url, path, sha256=page.sha256)
    assert path.read_bytes() == b"my own weights"
    assert fetch_file(page.url, path, sha256=None) == path


def test_file_refusals(server, tmp_path):
    page = server.add("/weights.bin", b"weights")
    with pytest.raises(DataError, match="larger than"):
        fetch_file(page.url, tmp_path / "a", sha256=None, max_bytes=3)
    with pytest.raises(DataError, match="expected sha256:0000"):
        fetch_file(page.url, tmp_path / "a", sha256=WRONG)
    with pytest.raises(UsageError):
        fetch_file(page.url, tmp_path / "a", sha256="md5:0")
    with pytest.raises(UsageError):
        fetch_file("file:///etc/passwd", tmp_path / "a", sha256=None)
    assert names(tmp_path) == [".a.lock"]


def test_importing_is_cheap():
    script = "import sys, vpr_bench.download; print({'requests', 'pooch', 'filelock'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"
