import pytest

from vpr_bench.errors import DataError
from vpr_bench.files.images import listed, some_listed


def test_images_come_in_natural_order_and_nothing_else_does(tmp_path):
    for name in ("img10.jpg", "img2.JPG", "img2.png", "notes.txt", "._img2.jpg", "movie.gif"):
        (tmp_path / name).touch()
    (tmp_path / "folder.jpg").mkdir()
    assert [file.name for file in listed(tmp_path)] == ["img2.JPG", "img2.png", "img10.jpg"]


def test_a_folder_without_images_and_none_at_all(tmp_path):
    assert listed(tmp_path) == []
    with pytest.raises(DataError, match="holds no images"):
        some_listed(tmp_path)
    with pytest.raises(DataError, match="is missing"):
        some_listed(tmp_path / "nowhere")
