import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.describe_own import describe_own
from vpr_bench.errors import DataError
from vpr_datasets.layouts.csv_table import load, recognise

CARD = TraverseCard(name="day", folder=".")
ROWS = ["day/1.jpg,0,0", "day/2.jpg,0,5", "night/1.jpg,1,0"]


def write(folder, rows=ROWS, header="image,x,y", name="images.csv", images=None):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("\n".join([header, *rows]) + "\n", "utf-8")
    for image in ["day/1.jpg", "day/2.jpg", "night/1.jpg"] if images is None else images:
        (folder / image).parent.mkdir(parents=True, exist_ok=True)
        (folder / image).write_bytes(b"x")
    return folder


def refused(folder, card=CARD, **options):
    with pytest.raises(DataError) as caught:
        load(folder, card, **options)
    message = str(caught.value)
    assert message.count("\n") <= 1 and len(message) < 600
    return message


def sources(recording, folder):
    return [source.relative_to(folder).as_posix() for source in recording.traverse.sources]


def test_the_first_folder_is_the_traverse(tmp_path):
    recording = load(write(tmp_path), CARD, traverse="day")
    assert sources(recording, tmp_path) == ["day/1.jpg", "day/2.jpg"]
    assert recording.labels.tolist() == [[0, 0], [0, 5]] and recording.labels.dtype == np.float64
    assert recording.compass is None


def test_without_a_traverse_all_images_are_one(tmp_path):
    assert len(load(write(tmp_path), CARD)) == 3


@pytest.mark.parametrize("column", ["traverse", "Split", "role", "SET"])
def test_a_column_may_name_the_traverse(tmp_path, column):
    rows = ["Map A,day/1.jpg,0,0", "q,day/2.jpg,0,5", "Map A,night/1.jpg,1,0"]
    write(tmp_path, rows, f"{column},image,x,y")
    assert sources(load(tmp_path, CARD, traverse="Map A"), tmp_path) == ["day/1.jpg", "night/1.jpg"]
    card = describe_own(tmp_path, "csv").card
    assert [(one.name, one.folder, one.images) for one in card.traverses] == [("map_a", ".", 2), ("q", ".", 1)]
    assert len(load(tmp_path / card.traverses[0].path, CARD, **card.loader.options, **card.traverses[0].options)) == 2


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_separators_marks_and_ends_of_lines(tmp_path, separator, mark, end):
    write(tmp_path)
    lines = ["Image,X,Y", *ROWS, "", " "]
    (tmp_path / "images.csv").write_text(mark + end.join(lines).replace(",", separator), "utf-8", newline="")
    assert load(tmp_path, CARD, traverse="day").labels.tolist() == [[0, 0], [0, 5]]


@pytest.mark.parametrize("name", ["my day/a b.jpg", "day/a, b.jpg", 'day/a "b".jpg', "day/größe.jpg", "day/a\nb.jpg"])
def test_names_may_hold_anything_in_quotes(tmp_path, name):
    quoted = name.replace('"', '""')
    write(tmp_path, [f'"{quoted}",1,2'], images=[name])
    recording = load(tmp_path, CARD)
    assert sources(recording, tmp_path) == [name] and recording.labels.tolist() == [[1, 2]]


def test_paths_of_windows_are_understood(tmp_path):
    assert sources(load(write(tmp_path, [r".\day\1.jpg,1,2"]), CARD), tmp_path) == ["day/1.jpg"]


@pytest.mark.parametrize(
    "header",
    [
        "image,x,y",
        "file,easting,northing",
        "filename,utm_east,utm_north",
        "path,X,Y",
        "id,image,x,y",
        "image,x,y,lat,lon",
    ],
)
def test_columns_go_by_many_names(tmp_path, header):
    cells = {"id": "7", "lat": "0", "lon": "0"}
    values = iter(["day/1.jpg", "3", "4"])
    row = ",".join(cells.get(name) or next(values) for name in header.split(","))
    assert load(write(tmp_path, [row], header), CARD).labels.tolist() == [[3, 4]]


@pytest.mark.parametrize("header", ["image,lat,lon,heading", "image,latitude,longitude,CA", "file,lat,lon,compass"])
def test_degrees_become_metres(tmp_path, header):
    write(tmp_path, ["day/1.jpg,52.489175,13.298339,-90"], header)
    recording = load(tmp_path, CARD, zone="33U")
    np.testing.assert_allclose(recording.labels, [[384462.04, 5816809.06]], atol=0.01)
    assert recording.compass.tolist() == [270]
    assert "which UTM zone" in refused(tmp_path)


@given(st.integers(0, 2**32))
def test_the_order_of_lines_changes_no_images_label(tmp_path_factory, seed):
    folder = tmp_path_factory.mktemp("data")
    rows = [f"day/{index}.jpg,{index},{index * 2}" for index in range(5)]
    random.Random(seed).shuffle(rows)  # noqa: S311 - no secret
    recording = load(write(folder, rows, images=[row.partition(",")[0] for row in rows]), CARD)
    assert recording.labels.tolist() == [[int(s.stem), 2 * int(s.stem)] for s in recording.traverse.sources]
    assert sources(recording, folder) == [row.partition(",")[0] for row in rows]  # a table is in its own order


@pytest.mark.parametrize(
    ("row", "why"),
    [
        ("night/9.jpg,0,0", "'night/9.jpg' does not exist"),
        ("night,0,0", "lies in no folder"),
        ("night/,0,0", "lies in no folder"),
        ("day/1.jpg,0,0", "'day/1.jpg' is in line 2 already"),
        ("./day//1.jpg,0,0", "is in line 2 already"),
        ("../day/1.jpg,0,0", "leads out of the folder"),
        ("day/../../x.jpg,0,0", "leads out of the folder"),
        ("/etc/passwd,0,0", "leads out of the folder"),
        (r"..\x.jpg,0,0", "leads out of the folder"),
        ("day/\0.jpg,0,0", "line"),
        ("night/2.jpg,a,0", "'a' is not a number"),
        ("night/2.jpg,nan,0", "'nan' is not a number"),
        ("night/2.jpg,inf,0", "'inf' is not a number"),
        ("night/2.jpg,,0", "'' is not a number"),
        ('night/2.jpg,"1,5",0', "'1,5' is not a number"),
        (",0,0", "the image is missing"),
        ("night/2.jpg,0", "found 2 cells, but the header has 3"),
        ("night/a, b.jpg,0,0", "found 4 cells, but the header has 3"),
        ('"night/2.jpg,0,0', "unexpected end of data"),
        ("night/notes.txt,0,0", "is not the name of an image"),
        ("x" * 200_000 + ",0,0", "field larger than field limit"),
    ],
)
def test_a_wrong_line_is_named(tmp_path, row, why):
    write(tmp_path, [*ROWS, row])
    (tmp_path / "night" / "notes.txt").write_text("x")
    message = refused(tmp_path)
    assert why in message and "line 5" in message and "images.csv" in message


def test_a_link_out_of_the_folder_is_refused(tmp_path):
    folder = write(tmp_path / "data")
    (tmp_path / "secret.jpg").write_bytes(b"x")
    (folder / "night" / "1.jpg").unlink()
    (folder / "night" / "1.jpg").symlink_to(tmp_path / "secret.jpg")
    assert "line 4: 'night/1.jpg' is a link out of the folder" in refused(folder)
    assert len(load(folder, CARD, traverse="day")) == 2


def test_positions_in_the_wrong_zone_are_named_with_their_line(tmp_path):
    write(tmp_path, ["day/1.jpg,52.5,13.3", "day/2.jpg,-52.5,13.3", "night/1.jpg,0,0"], "image,lat,lon")
    message = refused(tmp_path, zone="33U")
    assert "line 3: (-52.5, 13.3)" in message and "sign looks wrong" in message and "(and 1 more" in message


def test_missing_compass_and_traverse_cells_are_named(tmp_path):
    write(tmp_path, ["day/1.jpg,0,0,,a"], "image,x,y,heading,split")
    assert "line 2: '' is not a number" in refused(tmp_path)
    write(tmp_path, ["day/1.jpg,0,0,0,"], "image,x,y,heading,split")
    assert "line 2: the traverse is missing" in refused(tmp_path)


@pytest.mark.parametrize("header", ["", "image", "image,x", "name,x,y", "image|x|y", "image,x,y,x", '"image,x,y'])
def test_another_header_is_told(tmp_path, header):
    assert "must have a header with a column image" in refused(write(tmp_path, header=header))


def test_the_table_is_found_or_named(tmp_path):
    write(tmp_path)
    write(tmp_path, ["day/1.jpg,8,8"], name="other.csv", images=[])
    assert "must hold one table, *.csv: found 2" in refused(tmp_path)
    assert load(tmp_path, CARD, file="other.csv").labels.tolist() == [[8, 8]]
    assert "is missing" in refused(tmp_path, file="none.csv")
    for path in ("../images.csv", "/etc/passwd"):
        assert "is not in the folder" in refused(tmp_path / "day", file=path)


def test_unknown_traverses_and_other_counts_are_told(tmp_path):
    write(tmp_path)
    assert "no image of the traverse 'dya'. Did you mean 'day'?" in refused(tmp_path, traverse="dya")
    assert "found 3" in refused(tmp_path, TraverseCard(name="day", images=7))
    (tmp_path / "images.csv").write_text("image,x,y\n")
    assert "has a header and no images" in refused(tmp_path)


def test_a_table_with_degrees_is_recognised_with_its_zone(tmp_path):
    write(tmp_path, ["night/1.jpg;-27.5;153", "day/1.jpg;-27.5;153.01"], "image;lat;lon")
    card = describe_own(tmp_path, "csv").card
    assert card.loader.options == {"file": "images.csv", "zone": "56J"}
    assert [str(one) for one in card.listed_protocols()] == [f"{card.id}/night-day@25m"]
    assert load(tmp_path, CARD, **card.loader.options, traverse="day").labels.shape == (1, 2)


def test_a_table_with_a_wrong_line_is_told_and_not_passed_over(tmp_path):
    write(tmp_path, [*ROWS, "night/2.jpg,0,zero"])
    with pytest.raises(DataError, match="line 5: 'zero' is not a number"):
        recognise(tmp_path)


@pytest.mark.parametrize(
    ("header", "rows"),
    [
        ("query,ref_number,ref_index", ["1,2,3"]),
        ("image,x,y", ["a/no such.jpg,1,2"]),
        ("image,x,y", []),
        ("image,x,y", ["day/1.jpg,0,0"]),  # one traverse cannot be looked up in itself
    ],
)
def test_other_tables_are_not_recognised(tmp_path, header, rows):
    assert recognise(write(tmp_path, rows, header)) is None


def test_two_tables_and_none_are_not_recognised(tmp_path):
    assert recognise(tmp_path) is None
    assert recognise(tmp_path / "missing") is None
    write(tmp_path)
    write(tmp_path, name="other.csv")
    assert recognise(tmp_path) is None
