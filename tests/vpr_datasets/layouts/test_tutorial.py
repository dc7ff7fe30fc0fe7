import numpy as np
import pytest
from hypothesis import given as forall
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from PIL import Image

from vpr_bench.dataset.card import TraverseCard
from vpr_bench.dataset.load import load_case
from vpr_bench.dataset.recording import Recording
from vpr_bench.errors import DataError
from vpr_bench.types.traverse import Traverse
from vpr_datasets.layouts.bayer import Bayer
from vpr_datasets.layouts.tutorial import LAYOUT, given, load, recognise

IMAGE = np.zeros((4, 4, 3), np.uint8)


def recording(name, count):
    return Recording(Traverse(name, [IMAGE] * count))


def dense(truth):
    table = np.zeros((truth.n_references, truth.n_queries), dtype=bool)
    table[truth.references, truth.query_of_pair] = True
    return table


def truth(folder, hard, references=None, queries=None, **soft):
    np.savez(folder / "GT.npz", GThard=hard, **soft)
    shape = np.shape(hard)
    return given(folder, recording("map", references or shape[0]), recording("walk", queries or shape[1]))


def write(folder, **counts):
    for name, count in counts.items():
        (folder / name).mkdir()
        for number in range(count):
            (folder / name / f"image{number:03d}.jpg").write_bytes(b"x")


@forall(st.data(), array_shapes(min_dims=2, max_dims=2, max_side=6), st.sampled_from(["?", "u1", "i8", "f4", "f8"]))
def test_any_matrices_read_as_they_are_meant(tmp_path_factory, data, shape, kind):
    folder = tmp_path_factory.getbasetemp()
    hard, soft = (data.draw(arrays(bool, shape)) for _ in range(2))
    read = truth(folder, hard.astype(kind), GTsoft=soft.astype(kind))
    for reference in range(shape[0]):
        for query in range(shape[1]):
            assert (reference in read[query]) == hard[reference, query]
            assert (reference in read.soft[query]) == (soft[reference, query] and not hard[reference, query])
    assert np.array_equal(dense(read), hard) and np.array_equal(dense(read.soft), soft & ~hard)


def test_without_soft_matches_there_are_none(tmp_path):
    assert truth(tmp_path, np.eye(3, 4)).soft is None


def test_a_matrix_that_lies_on_its_side_is_refused_not_turned(tmp_path):
    with pytest.raises(DataError) as raised:
        truth(tmp_path, np.zeros((9, 12), bool), references=12, queries=9)
    assert "is 9 × 12; it must have a row for each of the 12 images of map" in str(raised.value)
    assert "It fits the other way round: swap references and queries" in str(raised.value)


@pytest.mark.parametrize("shape", [(12, 8), (12,), (12, 9, 1), ()])
def test_a_matrix_that_does_not_fit_is_refused(tmp_path, shape):
    with pytest.raises(DataError, match="must have a row for each") as raised:
        truth(tmp_path, np.zeros(shape, bool), references=12, queries=9)
    assert "other way" not in str(raised.value)


def test_soft_matches_must_fit_too(tmp_path):
    with pytest.raises(DataError, match=r"GTsoft in .* is 4 × 3"):
        truth(tmp_path, np.eye(3, 4), GTsoft=np.eye(4, 3))


@pytest.mark.parametrize("odd", [2, -1, 0.5, np.nan, 255])
def test_other_values_than_0_and_1_are_refused(tmp_path, odd):
    with pytest.raises(DataError, match=f"GThard in .* holds {odd}.*; it must hold 0 and 1"):
        truth(tmp_path, np.full((3, 4), odd))


@pytest.mark.parametrize("odd", [np.full((3, 4), "1"), np.full((3, 4), 1j), np.full((3, 4), None)])
def test_other_kinds_of_arrays_are_refused(tmp_path, odd):
    with pytest.raises(DataError, match=r"GT\.npz"):
        truth(tmp_path, odd)


def test_a_file_without_the_matrix_is_refused(tmp_path):
    np.savez(tmp_path / "GT.npz", other=np.eye(3))
    with pytest.raises(DataError, match=r"holds no array GThard\. Found 'other.npy'"):
        given(tmp_path, recording("map", 3), recording("walk", 3))


def test_the_file_can_be_named_but_lies_in_the_folder(tmp_path):
    np.savez(tmp_path / "other.npz", GThard=np.eye(3))
    maps = recording("map", 3), recording("walk", 3)
    assert given(tmp_path, *maps, file="other.npz").n_queries == 3
    with pytest.raises(DataError, match=r"GT\.npz is missing"):
        given(tmp_path, *maps)
    with pytest.raises(DataError, match="is no file in"):
        given(tmp_path / "in", *maps, file="../other.npz")


def test_images_come_in_the_order_of_their_names(tmp_path):
    write(tmp_path, walk=3)
    (tmp_path / "walk/image0005.jpg").write_bytes(b"x")
    read = load(tmp_path / "walk", TraverseCard(name="walk", images=4))
    # As the tutorial sorts them, and so as its matrices count them.
    assert [file.name[5:-4] for file in read.traverse.sources] == ["000", "0005", "001", "002"]
    assert read.labels is None
    with pytest.raises(DataError, match="must hold the 5 images of walk: found 4"):
        load(tmp_path / "walk", TraverseCard(name="walk", images=5))


def test_raw_images_are_decoded_in_colour(tmp_path):
    raw = np.array([[200, 120], [120, 30]] * 4, np.uint8)
    Image.fromarray(np.tile(raw, (1, 5))).save(tmp_path / "0.png")
    plain = load(tmp_path, TraverseCard(name="walk"))
    assert (plain.traverse[0][0, 0] == 200).all()
    coloured = load(tmp_path, TraverseCard(name="walk"), bayer="RGGB")
    assert (coloured.traverse[0] == (200, 120, 30)).all() and coloured.traverse.convert == Bayer("RGGB")
    with pytest.raises(DataError, match="must be one of RGGB"):
        load(tmp_path, TraverseCard(name="walk"), bayer="GR")


def test_positions_become_labels_where_there_are_any(tmp_path):
    write(tmp_path, walk=3)
    options = {"gps": "fGPS.txt", "zone": "56J", "flip_latitude": True}
    assert load(tmp_path / "walk", TraverseCard(name="walk"), **options).labels is None
    (tmp_path / "walk/fGPS.txt").write_text("27.5,153.0\n27.5001,153.0\n27.5,153.0001\n")
    labels = load(tmp_path / "walk", TraverseCard(name="walk"), **options).labels
    assert labels.shape == (3, 2)
    assert labels[1] - labels[0] == pytest.approx([0, -11.08], abs=0.1)  # metres, southwards
    assert labels[2] - labels[0] == pytest.approx([9.88, 0], abs=0.1)
    with pytest.raises(DataError, match="is no file in"):
        load(tmp_path / "walk", TraverseCard(name="walk"), **{**options, "gps": "../walk/fGPS.txt"})


def test_it_is_recognised_by_the_numbers_of_images(tmp_path):
    write(tmp_path, a=9, b=12)
    np.savez(tmp_path / "GT.npz", GThard=np.eye(12, 9))
    said = recognise(tmp_path)
    assert said.found == "VPR tutorial folders: references b (12), queries a (9), matches in GT.npz"
    assert said.given == [{"references": "b", "queries": "a"}]
    case = load_case(str(tmp_path))
    assert str(case.protocol).endswith("/b-a@given") and case.ground_truth[8].tolist() == [8]


def test_of_two_folders_of_one_size_the_first_by_name_is_the_map_and_it_says_so(tmp_path):
    write(tmp_path, dry=4, jan=4)
    np.savez(tmp_path / "GT.npz", GThard=np.eye(4))
    said = recognise(tmp_path)
    assert said.given == [{"references": "dry", "queries": "jan"}]
    assert said.found.endswith("; dry is taken for the references by its name, but jan-dry would fit too")


def test_names_that_say_which_is_the_map_are_believed(tmp_path):
    write(tmp_path, a=4, database=4)
    np.savez(tmp_path / "GT.npz", GThard=np.eye(4))
    assert recognise(tmp_path).given == [{"references": "database", "queries": "a"}]


def test_of_several_folders_those_that_fit_are_taken(tmp_path):
    write(tmp_path, a=4, b=5, c=6)
    np.savez(tmp_path / "GT.npz", GThard=np.eye(6, 5))
    assert recognise(tmp_path).given == [{"references": "c", "queries": "b"}]
    np.savez(tmp_path / "GT.npz", GThard=np.eye(7, 5))
    with pytest.raises(
        DataError, match=r"is 7 × 5, and no two folders beside it have as many images: a \(4\), b \(5\)"
    ):
        recognise(tmp_path)


def test_other_folders_are_not(tmp_path):
    assert recognise(tmp_path) is None and recognise(tmp_path / "none") is None
    write(tmp_path, a=4, b=5)
    assert recognise(tmp_path) is None
    np.savez(tmp_path / "GT.npz", other=np.eye(4, 5))
    assert recognise(tmp_path) is None
    (tmp_path / "GT.npz").write_bytes(b"PK")
    with pytest.raises(DataError, match="is damaged"):
        recognise(tmp_path)
    assert LAYOUT.rank == 80
