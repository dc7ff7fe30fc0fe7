import pytest

from vpr_bench.files.swap import recover, swap_in


@pytest.fixture
def folders(tmp_path):
    for name in ("new", "place"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "what").write_text(name)
    return tmp_path / "new", tmp_path / "place"


def test_takes_the_place_of_another(folders):
    new, place = folders
    swap_in(new, place)
    assert (place / "what").read_text() == "new"
    assert [path.name for path in place.parent.iterdir()] == ["place"]


def test_takes_a_free_place(folders):
    new, place = folders
    place.replace(place.with_name("away"))
    swap_in(new, place)
    assert (place / "what").read_text() == "new"


def test_one_of_the_two_is_there_whenever_it_is_killed(folders, monkeypatch):
    new, place = folders
    rename = type(new).replace

    def killed(self, target):
        if self == new:
            raise KeyboardInterrupt
        return rename(self, target)

    monkeypatch.setattr(type(new), "replace", killed)
    with pytest.raises(KeyboardInterrupt):
        swap_in(new, place)
    monkeypatch.undo()
    recover(place)
    assert (place / "what").read_text() == "place"
    swap_in(new, place)
    former = place.with_name("place.former")
    former.mkdir()  # killed while it was deleted
    recover(place)
    assert not former.exists()
    assert (place / "what").read_text() == "new"
