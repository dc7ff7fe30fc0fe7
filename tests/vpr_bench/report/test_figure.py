from pathlib import Path

import pytest

from vpr_bench.errors import DataError, UsageError
from vpr_bench.report.figure import check_picture


@pytest.mark.parametrize("name", ["a.png", "A.SVG", "there/a.png"])
def test_what_can_be_written_passes(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    Path("there").mkdir()
    check_picture(Path(name))


@pytest.mark.parametrize("name", ["a.jpg", "a", ".", "png"])
def test_other_endings_are_refused(name):
    with pytest.raises(UsageError, match=r"must end in \.png or \.svg"):
        check_picture(Path(name))


def test_a_sheet_is_a_png_only():
    with pytest.raises(UsageError, match=r"must end in \.png\. Got 'a.svg'"):
        check_picture(Path("a.svg"), ["png"])


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("nowhere/a.png", "there is no folder"),
        ("file/a.png", "there is no folder"),
        ("folder.png", "it is a folder"),
        (f"{'x' * 300}/a.png", "Cannot write"),
    ],
)
def test_places_where_nothing_can_be_written_are_refused(tmp_path, name, said):
    (tmp_path / "file").touch()
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(DataError, match=said):
        check_picture(tmp_path / name)
