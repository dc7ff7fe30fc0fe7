"""A map.json may be damaged, edited by hand, or made by somebody with bad intentions."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.maps.map import load_map
from vpr_bench.maps.record import _inside


def refused(place, said, kind=DataError):
    with pytest.raises(kind, match=said) as caught:
        load_map(place)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 1500


def test_there_is_none(place, tmp_path):
    refused(place, "There is no map .*tiny.map. Make one with `vpr-bench fit")
    place.mkdir()
    refused(place, "is not a map: it has no map.json")
    (tmp_path / "file").touch()
    refused(tmp_path / "file", "is not a map")


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b"\xff\xfe",
        b"[" * 100_000,
        b'{"schema_version": 1e999}',
        b'{"schema_version": ' + b"9" * 5000 + b"}",
        b'{"schema_version": true}',
        b'{"schema_version": 1}',
        b'{"schema_version": "1", "digest": {}}',
    ],
)
def test_nonsense(place, content):
    place.mkdir()
    (place / "map.json").write_bytes(content)
    refused(place, "map.json (is damaged|was changed)", DamagedError)


def test_truncated(tiny_map, place):
    content = (place / "map.json").read_bytes()
    (place / "map.json").write_bytes(content[: len(content) // 2])
    refused(place, "is damaged: .* Fit it again with: vpr-bench fit", DamagedError)


def test_edited_by_hand(tiny_map, place, edit):
    edit(lambda content: content["method"]["parameters"].update(cells=2), sealed=False)
    refused(
        place,
        "was changed after it was written. Fit it again with: vpr-bench fit --method colours --dataset tiny "
        "--references day_left -o .*tiny.map --overwrite",
        DamagedError,
    )


@pytest.mark.parametrize("found", [0, 2, -1, 10**30])
def test_another_schema(place, edit, tiny_map, found):
    edit(lambda content: content.update(schema_version=found, package="9.9", news={"of": "tomorrow"}), sealed=False)
    refused(place, r"was made by vpr-bench 9.9 in another format.*Fit it again with: vpr-bench fit --method colours")


def test_another_schema_that_tells_nothing(place):
    place.mkdir()
    (place / "map.json").write_text('{"schema_version": 2, "parts": {}, "method": [1]}')
    refused(place, "Fit it again with: vpr-bench fit --method … --dataset … -o")


def test_words_of_others_cannot_move_the_cursor_or_end_a_command(place, edit, tiny_map):
    evil = "hog; rm -rf ~ \x1b[2J\n"
    edit(lambda content: content.update(schema_version=2, package=evil, method={"id": evil}), sealed=False)
    with pytest.raises(DataError) as caught:
        load_map(place)
    assert "\x1b" not in str(caught.value)
    assert "--method 'hog; rm -rf ~ [2J'" in str(caught.value)


HOSTILE = {
    "files that lead out": lambda c: c.update(files={"../../etc/passwd": next(iter(c["files"].values()))}),
    "files from the root": lambda c: c.update(files={"/etc/passwd": next(iter(c["files"].values()))}),
    "files on a drive": lambda c: c.update(files={"C:\\x": next(iter(c["files"].values()))}),
    "files that lead out on Windows": lambda c: c.update(files={"..\\x": next(iter(c["files"].values()))}),
    "no digest": lambda c: c["files"]["map.npy"].update(digest="sha256:short"),
    "no size": lambda c: c["files"]["map.npy"].update(size=-1),
    "a size beyond all": lambda c: c["files"]["map.npy"].update(size=10**400),
    "images that lead out": lambda c: c["parts"][0]["names"].__setitem__(0, "../secret.jpg"),
    "images from the root": lambda c: c["parts"][0]["names"].__setitem__(0, "/secret.jpg"),
    "an image without a name": lambda c: c["parts"][0]["names"].__setitem__(0, ""),
    "no images": lambda c: c["parts"][0].update(names=[], places=[]),
    "no parts": lambda c: c.update(parts=[]),
    "places of too few": lambda c: c["parts"][0].update(places=[1.0]),
    "places nowhere": lambda c: c["parts"][0]["places"].__setitem__(0, float("nan")),
    "a dataset that is a path": lambda c: c["parts"][0].update(dataset="../mine"),
    "from nowhere": lambda c: c["parts"][0].update(dataset=None),
    "something else": lambda c: c.update(run="rm -rf ~"),
    "a method that is none": lambda c: c.update(method="hog"),
    "a number for a name": lambda c: c["method"].update(id=7),
    "time that ran backwards": lambda c: c.update(fit_seconds=-1.0),
    "a novel": lambda c: c["method"].update(id="x" * 5000),
}


@pytest.mark.parametrize("change", HOSTILE.values(), ids=HOSTILE)
def test_hostile_content(tiny_map, place, edit, change):
    edit(change)
    refused(place, "map.json is (refused|damaged)", DamagedError)


def test_a_record_beyond_all_size_is_not_read(tiny_map, place, monkeypatch):
    monkeypatch.setattr("vpr_bench.maps.record.LIMIT", 100)
    refused(place, "more than 100 B")


@given(st.text(max_size=30))
def test_names_stay_inside(name):
    try:
        inside = _inside(name)
    except ValueError:
        return
    from pathlib import PurePosixPath, PureWindowsPath

    for kind in (PurePosixPath, PureWindowsPath):
        joined = kind("/folder") / inside
        assert joined.parts[:2] == kind("/folder").parts[:2]
        assert ".." not in joined.parts


def test_what_was_written_is_read(tiny_map, place):
    assert load_map(place).record == tiny_map.record
    assert json.loads((place / "map.json").read_text())["digest"].startswith("sha256:")


def test_a_map_made_before_memory_and_blas_were_noted(tiny_map, place, edit):
    def forget(content):
        content["machine"].pop("memory_bytes")
        content["machine"].pop("blas")

    edit(forget)
    machine = load_map(place).record.machine
    assert (machine.memory_bytes, machine.blas) == (None, None)
    assert machine.processor == tiny_map.record.machine.processor
