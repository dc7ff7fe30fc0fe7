import warnings

import numpy as np
import pytest
from hypothesis import given as forall
from hypothesis import strategies as st

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.load import DatasetWarning, load_case
from vpr_bench.errors import DataError
from vpr_datasets.layouts.vpr_bench_folders import LAYOUT, given, load, recognise


def write(folder, references, queries, rows=None, file="ground_truth_new.npy"):
    """A dataset of VPR-Bench, with empty images: nothing decodes them."""
    for name, count in (("ref", references), ("query", queries)):
        (folder / name).mkdir(parents=True)
        for number in range(count):
            (folder / name / f"{number:07d}.jpg").write_bytes(b"x")
    if rows is not None:
        np.save(folder / file, table(rows))
    return folder


def table(rows):
    array = np.empty((len(rows), 2), dtype=object)
    for number, row in enumerate(rows):
        array[number, 0], array[number, 1] = number, row
    return array


def recordings(folder):
    return [load(folder / name, TraverseCard(name=name)) for name in ("ref", "query")]


def truth(folder, **options):
    read = given(folder, *recordings(folder), **options)
    return [read[query].tolist() for query in range(read.n_queries)]


def refused(folder, **options):
    with pytest.raises(DataError) as raised:
        truth(folder, **options)
    assert str(folder) in str(raised.value) and "\n" not in str(raised.value)
    return str(raised.value)


@pytest.fixture(autouse=True)
def _strict():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def test_images_come_in_the_order_of_their_numbers(tmp_path):
    write(tmp_path, 12, 3)
    references, _ = recordings(tmp_path)
    assert [file.name for file in references.traverse.sources][9:11] == ["0000009.jpg", "0000010.jpg"]
    assert references.labels is None and len(references) == 12


def test_numbers_without_zeros_in_front_count_as_numbers(tmp_path):
    for number in range(12):
        (tmp_path / f"{number}.png").write_bytes(b"x")
    assert [int(file.stem) for file in load(tmp_path, TraverseCard(name="ref")).traverse.sources] == list(range(12))


def test_other_names_come_in_natural_order(tmp_path):
    for name in ("b2.jpg", "b10.jpg", "a.png", "7.jpg"):
        (tmp_path / name).write_bytes(b"x")
    names = [file.name for file in load(tmp_path, TraverseCard(name="ref")).traverse.sources]
    assert names == ["7.jpg", "a.png", "b2.jpg", "b10.jpg"]


@pytest.mark.parametrize("lost", [0, 4])
def test_a_gap_is_named_because_it_would_move_all_places_behind_it(tmp_path, lost):
    write(tmp_path, 8, 1)
    (tmp_path / f"ref/{lost:07d}.jpg").unlink()
    message = f"{lost:07d}.jpg is missing, {lost + 1:07d}.jpg is in its place"
    with pytest.raises(DataError, match=message):
        load(tmp_path / "ref", TraverseCard(name="ref"))


def test_missing_images_are_counted(tmp_path):
    write(tmp_path, 8, 1)
    with pytest.raises(DataError, match="must hold the 9 images of ref: found 8"):
        load(tmp_path / "ref", TraverseCard(name="ref", images=9))
    with pytest.raises(DataError, match="is missing"):
        load(tmp_path / "reference", TraverseCard(name="ref"))


def test_an_empty_list_and_minus_one_mean_that_the_place_is_not_on_the_map(tmp_path):
    assert truth(write(tmp_path, 4, 4, [[0, 1], [-1], [], [3]])) == [[0, 1], [], [], [3]]


@pytest.mark.parametrize(
    "rows",
    [
        [[2, 3], [0, 1]],
        [(2, 3), np.array([1, 0])],
        [np.array([2.0, 3.0]), [np.int64(0), 1, 1]],
        [np.array([2, 3], dtype=object), range(2)],
    ],
)
def test_lists_may_be_of_any_kind(tmp_path, rows):
    rows = [list(row) if isinstance(row, range) else row for row in rows]
    assert truth(write(tmp_path, 4, 2, rows)) == [[2, 3], [0, 1]]


@pytest.mark.parametrize(
    "array",
    [
        np.array([[0, [3]], [1, [2]]], dtype=object),  # equal lengths: numpy may see more dimensions
        np.array([[0, 3], [1, 2]]),
        np.array([[[0], [3]], [[1], [2]]]),
        np.array([[[0], [3]], [[1], [2]]], dtype=object),
    ],
)
def test_lists_of_equal_length_make_arrays_of_other_shapes(tmp_path, array):
    write(tmp_path, 4, 2)
    np.save(tmp_path / "ground_truth_new.npy", array)
    assert truth(tmp_path) == [[3], [2]]


def test_references_beyond_the_end_are_left_out_and_named(tmp_path):
    # As in the corridor of VPR-Bench, which has 111 images and a list of neighbours that does not know it.
    write(tmp_path, 111, 111, [[query + step for step in range(3)] for query in range(111)])
    with pytest.warns(DatasetWarning, match=r"references 111, 112 do not exist, as there are 111; 3 of 333 pairs are"):
        read = truth(tmp_path)
    assert read[110] == [110] and read[109] == [109, 110] and read[50] == [50, 51, 52]


def test_one_reference_beyond_the_end(tmp_path):
    write(tmp_path, 3, 2, [[0, -2], [1]])
    with pytest.warns(DatasetWarning, match="reference -2 does not exist"):
        assert truth(tmp_path) == [[0], [1]]


def test_a_list_that_is_all_beyond_the_end_is_refused(tmp_path):
    assert "names none of the 3 references" in refused(write(tmp_path, 3, 2, [[5], [6]]))


def test_rows_count_not_the_numbers_in_them(tmp_path):
    array = table([[0], [1], [2]])
    array[:, 0] = [0, 2, 1]
    write(tmp_path, 3, 3)
    np.save(tmp_path / "ground_truth_new.npy", array)
    with pytest.warns(DatasetWarning, match="row 1 says that it is about query 2. As in VPR-Bench the position"):
        assert truth(tmp_path) == [[0], [1], [2]]
    array[:, 0] = "name"
    np.save(tmp_path / "ground_truth_new.npy", array)
    with pytest.warns(DatasetWarning, match="row 0 does not say which query it is about"):
        assert truth(tmp_path) == [[0], [1], [2]]


@pytest.mark.parametrize("count", [0, 2, 4])
def test_there_must_be_a_row_for_each_query(tmp_path, count):
    write(tmp_path, 4, 3, [[0]] * count)
    assert f"lists {count} queries, and query has 3 images" in refused(tmp_path)


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (["1"], "row 1 is not .*: str in place of a number"),
        ([None], "NoneType in place of a number"),
        ([[1]], "list in place of a number"),
        ([True], "bool in place of a number"),
        ([0.5], "0.5 in place of a whole number"),
        ([float("nan")], "row 1"),
        ([float("inf")], "row 1"),
        (np.eye(2), "an array of"),
        ("ab", "str in place of a number"),
    ],
)
def test_a_row_that_is_none_is_named(tmp_path, row, words):
    write(tmp_path, 4, 3, [[0], row, [2]])
    with pytest.raises(DataError, match=words):
        truth(tmp_path)


def test_lists_within_themselves_or_of_vast_size_are_refused(tmp_path):
    bomb: list = [0]
    for _ in range(64):
        bomb = [bomb, bomb]
    ring: list = []
    ring.append(ring)
    write(tmp_path, 4, 3)
    for row in (bomb, ring):
        np.save(tmp_path / "ground_truth_new.npy", table([[0], row, [2]]))
        assert "row 1" in refused(tmp_path)


def test_one_list_shared_by_all_rows_is_no_bomb(tmp_path, monkeypatch):
    monkeypatch.setattr("vpr_datasets.layouts.vpr_bench_folders._MOST", 1000)
    write(tmp_path, 4, 30, [[0] * 50] * 30)
    assert "lists more than 1,000 pairs" in refused(tmp_path)


def test_the_file_can_be_named_but_lies_in_the_folder(tmp_path):
    write(tmp_path, 2, 2, [[0], [1]], file="ground_truth.npy")
    assert truth(tmp_path, file="ground_truth.npy") == [[0], [1]]
    assert "ground_truth_new.npy is missing" in refused(tmp_path)
    assert "no file in" in refused(tmp_path, file="../ground_truth.npy")


rows = st.lists(st.one_of(st.just([-1]), st.lists(st.integers(-3, 9), max_size=5)), min_size=1, max_size=6)


@forall(rows, st.integers(1, 8))
def test_any_lists_read_as_they_are_meant(tmp_path_factory, rows, n_references):
    folder = write(tmp_path_factory.mktemp("any"), n_references, len(rows), rows)
    expected = [sorted({one for one in row if 0 <= one < n_references}) for row in rows]
    lost = any(row != [-1] and not set(row) <= set(range(n_references)) for row in rows)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        if lost and not any(expected):
            refused(folder)
        else:
            assert truth(folder) == expected
            assert bool(caught) == lost


@pytest.mark.parametrize("file", ["ground_truth_new.npy", "ground_truth.npy"])
def test_it_is_recognised_and_its_first_protocol_loads(tmp_path, file):
    write(tmp_path, 4, 3, [[0], [1], [2]], file=file)
    said = recognise(tmp_path)
    assert said.found.startswith("VPR-Bench folders: 4 references, 3 queries") and file in said.found
    case = load_case(str(tmp_path))
    assert str(case.protocol).endswith("/ref-query@given")
    assert [case.ground_truth[query].tolist() for query in range(3)] == [[0], [1], [2]]


def test_other_folders_are_not(tmp_path):
    assert recognise(tmp_path) is None and recognise(tmp_path / "none") is None
    write(tmp_path, 4, 3)
    assert recognise(tmp_path) is None
    np.save(tmp_path / "ground_truth_new.npy", table([[0]]))
    (tmp_path / "ref").rename(tmp_path / "map")
    assert recognise(tmp_path) is None
    assert LAYOUT.rank == 90
