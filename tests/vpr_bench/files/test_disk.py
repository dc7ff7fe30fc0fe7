import errno
from pathlib import Path

import pytest

from vpr_bench.files.disk import DiskError, disk_errors


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (errno.ENOSPC, "Cannot write data: the disk is full. Free some space, or choose another folder"),
        (errno.EDQUOT, "the disk is full"),
        (errno.EACCES, "Change the permissions, or choose another"),
        (errno.EROFS, "Change the permissions, or choose another"),
        (errno.ENOTDIR, "Cannot write data: here is in the way. Move it, or choose another"),
        (errno.EIO, "Cannot write data: words of the system."),
    ],
)
def test_every_message_says_what_to_do(number, words):
    with pytest.raises(DiskError) as raised, disk_errors(Path("data")):
        raise OSError(number, "words of the system", "here")
    assert words in str(raised.value)
    assert raised.value.exit_code == 3


def test_errors_that_are_not_the_disks_pass_through():
    with pytest.raises(OSError, match="Invalid data stream"), disk_errors(Path("data")):
        raise OSError("Invalid data stream")


@pytest.mark.parametrize("below", ["", "/folder", "/folder/inner"])
def test_the_file_in_the_way_is_named_not_what_should_be_below_it(tmp_path, below):
    file = tmp_path / "file"
    file.write_text("x")
    folder = Path(f"{file}{below}")
    with pytest.raises(DiskError, match=rf"^Cannot write {folder}: {file} is in the way"), disk_errors(folder):
        folder.mkdir(parents=True)


def test_a_folder_in_the_way_of_a_file_is_named(tmp_path):
    with pytest.raises(DiskError, match=f"{tmp_path} is in the way"), disk_errors(tmp_path):
        tmp_path.write_text("x")
