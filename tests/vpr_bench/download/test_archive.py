import bz2
import gzip
import io
import lzma
import os
import shutil
import stat
import struct
import tarfile
import warnings
import zipfile
from contextlib import contextmanager, nullcontext
from pathlib import Path

import pytest

from vpr_bench.download import DiskError, Limits, extract_archive
from vpr_bench.download.members import Member
from vpr_bench.errors import DataError
from vpr_bench.progress import listen

FILES = {
    "gardens/day_left/Image000.jpg": b"\xff\xd8" * 4000,
    "gardens/notes.txt": b"hello",
    "gardens/empty": b"",
}
TAR_MODES = ["w", "w:gz", "w:bz2", "w:xz"]


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.fixture
def refused(tmp_path):
    """Return a check that an archive is refused with certain words, and that nothing is written anywhere."""

    def check(data, words, **options):
        archive = tmp_path / "inner" / "archive"
        archive.parent.mkdir(exist_ok=True)
        archive.write_bytes(data)
        before = sorted(tmp_path.rglob("*"))
        with pytest.raises(DataError, match=words) as raised:
            extract_archive(archive, tmp_path / "inner" / "out", **options)
        assert sorted(tmp_path.rglob("*")) == before
        assert raised.value.exit_code == 3
        assert str(raised.value).count("\n") <= 1
        assert len(str(raised.value)) < 500

    return check


@pytest.mark.parametrize("mode", ["zip", *TAR_MODES])
def test_every_format(tmp_path, make_zip, make_tar, mode):
    data = make_zip(FILES) if mode == "zip" else make_tar(FILES, mode)
    (tmp_path / "archive").write_bytes(data)
    assert extract_archive(tmp_path / "archive", tmp_path / "new" / "out") == tmp_path / "new" / "out"
    assert contents(tmp_path / "new" / "out") == FILES
    assert [path.name for path in (tmp_path / "new").iterdir()] == ["out"]


def test_folders_dots_and_repeated_folders_are_fine(tmp_path, make_tar):
    folder = {"type": tarfile.DIRTYPE, "mode": 0}
    data = make_tar({".": folder, "./a": folder, "a/": folder, "./a/b": b"x", "c": folder})
    (tmp_path / "archive").write_bytes(data)
    out = extract_archive(tmp_path / "archive", tmp_path / "out")
    assert contents(out) == {"a/b": b"x"}
    assert (out / "c").is_dir()


def test_what_macos_adds_is_left_out(tmp_path, make_zip):
    junk = {"__MACOSX/gardens/._a": b"x", "gardens/.DS_Store": b"x", "gardens/._a": b"x"}
    (tmp_path / "archive").write_bytes(make_zip({**junk, "gardens/a": b"y"}))
    assert contents(extract_archive(tmp_path / "archive", tmp_path / "out")) == {"gardens/a": b"y"}


def test_modes_are_not_taken_from_the_archive(tmp_path, make_tar):
    with tarfile.open(tmp_path / "archive", "w") as archive:
        info = tarfile.TarInfo("tool")
        info.mode = 0o6777
        archive.addfile(info)
    out = extract_archive(tmp_path / "archive", tmp_path / "out")
    (tmp_path / "plain").touch()
    assert (out / "tool").stat().st_mode == (tmp_path / "plain").stat().st_mode


NAMES = {
    "/etc/evil": "an absolute path",
    "//evil": "an absolute path",
    "C:evil": "an absolute path",
    "c:/evil": "an absolute path",
    "../evil": "leads out",
    "a/../../evil": "leads out",
    "a/..": "leads out",
    ".": "a file without a name",
    "..\\evil": "a backslash",
    "a\\b": "a backslash",
    "__MACOSX/../../evil": "leads out",
    "x" * 5000: "an unusable name",
    "\x1b[31m/../evil": r"leads out of its folder, '\\x1b",
}


@pytest.mark.parametrize(("name", "words"), NAMES.items(), ids=range(len(NAMES)))
def test_names_that_lead_elsewhere(refused, make_zip, make_tar, name, words):
    refused(make_zip({"fine": b"x", name: b"evil"}), words)
    refused(make_tar({"fine": b"x", name: b"evil"}), words)


def test_name_with_nul(refused, make_zip):
    refused(make_zip({"fine": b"x", "a_b": b"evil"}).replace(b"a_b", b"a\0b"), r"an unusable name, 'a\\x00b'")


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ({"type": tarfile.SYMTYPE, "linkname": "/etc"}, "a symbolic link"),
        ({"type": tarfile.SYMTYPE, "linkname": "a"}, "a symbolic link"),
        ({"type": tarfile.LNKTYPE, "linkname": "a"}, "a hard link"),
        ({"type": tarfile.FIFOTYPE}, "a special file"),
        ({"type": tarfile.CHRTYPE, "devmajor": 1, "devminor": 3}, "a special file"),
    ],
)
def test_what_is_neither_file_nor_folder_in_a_tar(refused, make_tar, entry, words):
    refused(make_tar({"a": b"x", "evil": entry, "evil/b": b"x"}), words)


@pytest.mark.parametrize(("kind", "words"), [(stat.S_IFLNK, "a symbolic link"), (stat.S_IFIFO, "a special file")])
def test_what_is_neither_file_nor_folder_in_a_zip(refused, kind, words):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        info = zipfile.ZipInfo("evil")
        info.external_attr = (kind | 0o777) << 16
        archive.writestr(info, "/etc")
    refused(buffer.getvalue(), words)


@pytest.mark.parametrize(
    "names",
    [["a", "a"], ["a", "A"], ["a", "./a"], ["a/b", "A/c"], ["a", "a/b"], ["a/b", "a"], ["é", "e\u0301"]],
    ids=str,
)
def test_names_that_collide(refused, names):
    zipped, tarred = io.BytesIO(), io.BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(zipped, "w") as archive:
        warnings.simplefilter("ignore", UserWarning)
        for name in names:
            archive.writestr(name, "x")
    with tarfile.open(fileobj=tarred, mode="w") as archive:
        for name in names:
            archive.addfile(tarfile.TarInfo(name))
    refused(zipped.getvalue(), "names that collide")
    refused(tarred.getvalue(), "names that collide")


def test_bombs(refused, make_zip, make_tar):
    zeros = {"a": bytes(2_000_000), "b": bytes(2_000_000)}
    few = Limits(max_files=1)
    small = Limits(max_bytes=3_000_000)
    tight = Limits(max_ratio=100, harmless_bytes=1_000_000)
    for data in (make_zip(zeros), make_tar(zeros, "w:gz")):
        refused(data, "more than 1 files", limits=few)
        refused(data, r"unpacks to more than 3\.0 MB", limits=small)
        refused(data, "decompression bomb", limits=tight)


def test_tar_bomb_is_noticed_before_it_is_read(refused):
    info = tarfile.TarInfo("a")
    info.size = 10**12
    refused(info.tobuf() + bytes(1024), "unpacks to more than")


def test_tar_with_an_absurd_header_is_not_read_into_memory(refused):
    info = tarfile.TarInfo("a")
    info.size, info.type = 10**12, tarfile.XHDTYPE
    refused(info.tobuf(tarfile.GNU_FORMAT) + bytes(1024), r"damaged.*a header of")


@pytest.mark.parametrize("claimed", [10, 10_000_000])
def test_zip_that_lies_about_a_size(refused, make_zip, claimed):
    data = bytearray(make_zip({"a": bytes(1_000_000)}))
    for signature, offset in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        struct.pack_into("<I", data, data.index(signature) + offset, claimed)
    refused(bytes(data), "damaged")


def test_content_longer_than_stated_is_never_written_whole(refused, monkeypatch):
    endless = Member("a", 10, "file", lambda: io.BytesIO(bytes(5_000_000)))
    monkeypatch.setattr("vpr_bench.download.archive.open_archive", lambda path: nullcontext(iter([endless])))
    refused(b"", "'a' has not the stated size")


def test_tar_with_a_negative_size(refused):
    info = tarfile.TarInfo("a")
    info.size = -512
    refused(info.tobuf(tarfile.GNU_FORMAT) + bytes(1024), "the size -512|damaged")


def test_encrypted_zip(refused, make_zip):
    data = bytearray(make_zip({"a": b"x"}))
    for signature, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        data[data.index(signature) + offset] |= 1
    refused(bytes(data), "encrypted")


def test_unknown_compression(refused, make_zip):
    data = bytearray(make_zip({"a": b"x"}))
    for signature, offset in ((b"PK\x03\x04", 8), (b"PK\x01\x02", 10)):
        struct.pack_into("<H", data, data.index(signature) + offset, 99)
    refused(bytes(data), r"damaged.*compression")


@pytest.mark.parametrize("mode", ["zip", *TAR_MODES])
def test_truncated_archive(refused, make_zip, make_tar, mode):
    files = {f"{n}.bin": bytes(range(n, 256)) * 20 for n in range(20)}
    data = make_zip(files) if mode == "zip" else make_tar(files, mode)
    for share in (0.02, 0.5, 0.9):
        refused(data[: int(len(data) * share)], "damaged, incomplete")


@pytest.mark.parametrize("compress", [bytes, gzip.compress, bz2.compress, lzma.compress])
def test_tar_cut_between_two_files(refused, make_tar, compress):
    data = make_tar({"a": b"x", "b": b"y"})
    refused(compress(data[:1024]), "without an end mark")
    refused(compress(data[:1024] + b"?" * 512 + data[1024:]), "without an end mark")


@pytest.mark.parametrize("mode", ["zip", "w:gz", "w:bz2", "w:xz"])
def test_flipped_byte(refused, make_zip, make_tar, mode):
    files = {"a": os.urandom(20_000)}
    data = bytearray(make_zip(files) if mode == "zip" else make_tar(files, mode))
    data[10_000] ^= 0x55
    refused(bytes(data), "damaged")


def test_tar_followed_by_something_huge(refused, make_tar):
    refused(gzip.compress(make_tar({"a": b"x"}) + bytes(20_000_000)), "something follows its end")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "damaged"),
        (b"not an archive" * 100, "neither a zip nor a tar"),
        (b"\n<!DOCTYPE html><html>sign in</html>", "is a web page"),
        (bytes(10240), "holds no files"),
    ],
)
def test_what_is_not_an_archive(refused, data, words):
    refused(data, words)


def test_archive_of_folders_and_junk_only(refused, make_zip):
    refused(make_zip({"a/": b"", "a/.DS_Store": b"x"}), "holds no files")


def test_check_sees_the_files_and_can_refuse_them(refused, tmp_path, make_zip):
    seen = []

    def check(folder):
        seen.append(contents(folder))
        raise DataError("Image000.jpg is missing")

    refused(make_zip(FILES), "is missing", check=check)
    assert seen == [FILES]


def test_errors_of_a_check_are_not_called_damage(tmp_path, make_zip):
    def check(folder):
        raise ValueError("a mistake in the check")

    (tmp_path / "archive").write_bytes(make_zip(FILES))
    with pytest.raises(ValueError, match="a mistake"):
        extract_archive(tmp_path / "archive", tmp_path / "out", check=check)


def test_interruption_cleans_up(tmp_path, make_zip):
    @contextmanager
    def listener(description, total):
        def advance(steps):
            assert (tmp_path / ".out.unpacking").exists()
            raise KeyboardInterrupt

        yield advance

    (tmp_path / "archive").write_bytes(make_zip(FILES))
    with listen(listener), pytest.raises(KeyboardInterrupt):
        extract_archive(tmp_path / "archive", tmp_path / "out")
    assert [path.name for path in tmp_path.iterdir()] == ["archive"]


def test_folder_in_the_way_stays_as_it_is(tmp_path, make_zip):
    (tmp_path / "archive").write_bytes(make_zip(FILES))
    (tmp_path / "out").mkdir()
    extract_archive(tmp_path / "archive", tmp_path / "out")
    (tmp_path / "out" / "mine").touch()
    with pytest.raises(DataError, match="is in the way"):
        extract_archive(tmp_path / "archive", tmp_path / "out")
    assert (tmp_path / "out" / "mine").exists()


def test_missing_archive(tmp_path):
    with pytest.raises(DiskError, match=r"Cannot read .*archive: No such file"):
        extract_archive(tmp_path / "archive", tmp_path / "out")


def test_disk_too_small(tmp_path, make_zip, monkeypatch):
    usage = shutil.disk_usage(tmp_path)._replace(free=1)
    monkeypatch.setattr("shutil.disk_usage", lambda folder: usage)
    (tmp_path / "archive").write_bytes(make_zip(FILES))
    with pytest.raises(DiskError, match=r"8\.0 kB are needed"):
        extract_archive(tmp_path / "archive", tmp_path / "out")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_disk_that_fills_up(tmp_path, make_zip, monkeypatch):
    real = Path.open

    def open_full(path, mode="r", *args):
        return real(Path("/dev/full"), "wb") if mode == "xb" else real(path, mode, *args)

    monkeypatch.setattr(Path, "open", open_full)
    (tmp_path / "archive").write_bytes(make_zip(FILES))
    with pytest.raises(DiskError, match="the disk is full") as raised:
        extract_archive(tmp_path / "archive", tmp_path / "out")
    assert "VPR_BENCH_DATA" in str(raised.value)
    assert [path.name for path in tmp_path.iterdir()] == ["archive"]
