import os

import numpy as np
import pytest

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.maps.map import load_map
from vpr_bench.maps.state import check_state, describe_state


@pytest.fixture
def state(tiny_map, place):
    return place / "state"


def flip(file):
    content = bytearray(file.read_bytes())
    content[-1] ^= 1
    file.write_bytes(content)


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (lambda file: file.write_bytes(file.read_bytes()[:-5]), "bytes were written, .* are there"),
        (lambda file: file.write_bytes(b""), "0 are there"),
        (lambda file: file.unlink(), "is missing"),
        (flip, "it is not what was written"),
        (lambda file: file.with_name("more.npy").touch(), "more.npy is no part of the map"),
    ],
)
def test_damage_is_seen_when_the_map_is_opened(state, place, damage, said):
    damage(state / "map.npy")
    with pytest.raises(DamagedError, match=said):
        load_map(place)


def test_a_folder_in_place_of_a_file(state, place):
    (state / "map.npy").unlink()
    (state / "map.npy").mkdir()
    with pytest.raises(DamagedError, match="is missing"):
        load_map(place)


def test_what_a_system_leaves_in_folders_is_no_damage(state, place):
    (state / ".DS_Store").touch()
    (place / "notes.txt").touch()
    load_map(place)


def test_a_large_state_is_read_again_only_if_it_was_touched(tmp_path, data_folder, monkeypatch):
    monkeypatch.setattr("vpr_bench.maps.state.SMALL", 10)
    file = tmp_path / "state" / "big"
    file.parent.mkdir()
    file.write_bytes(b"x" * 100)
    os.utime(file, ns=(1, 1))
    files = describe_state(file.parent)
    check_state(file.parent, files)
    flip(file)
    os.utime(file, ns=(1, 1))  # as only somebody who hides an edit does
    check_state(file.parent, files)
    with pytest.raises(DamagedError, match="not what was written"):
        check_state(file.parent, files, verify=True)
    os.utime(file, ns=(2, 2))
    with pytest.raises(DamagedError, match="not what was written"):
        check_state(file.parent, files)


def test_folders_in_the_state(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "a").write_text("a")
    files = describe_state(tmp_path)
    assert list(files) == ["inner/a"]
    check_state(tmp_path, files)


def test_a_state_that_the_method_cannot_read(tiny_map, place, edit):
    """It is what its digest says, and yet no array: whoever made it wrote something else."""
    file = place / "state" / "map.npy"
    for content in (b"nonsense", b"\x93NUMPY\x01\x00" + b"\xff" * 90):
        file.write_bytes(content)
        facts = describe_state(place / "state")["map.npy"].model_dump()
        edit(lambda content, facts=facts: content["files"].update({"map.npy": facts}))
        with pytest.raises(DataError, match="cannot be read"):
            load_map(place).locate(np.zeros((8, 8, 3), np.uint8))


def test_a_pickle_is_not_run(tiny_map, place, edit, tmp_path):
    class Evil:
        def __reduce__(self):
            return (open, (str(tmp_path / "ran"), "w"))

    file = place / "state" / "map.npy"
    np.save(file, np.array([Evil()], dtype=object), allow_pickle=True)
    edit(lambda content: content["files"].update({"map.npy": describe_state(file.parent)["map.npy"].model_dump()}))
    with pytest.raises(DataError, match="cannot be read"):
        load_map(place).locate(np.zeros((8, 8, 3), np.uint8))
    assert not (tmp_path / "ran").exists()
