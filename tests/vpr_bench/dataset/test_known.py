import shutil
import warnings

import pytest

from vpr_bench.dataset.acquire import accept_images, verify_images
from vpr_bench.dataset.known import known_digest, remember_digest
from vpr_bench.dataset.load import DatasetWarning, load_case
from vpr_bench.errors import DataError


@pytest.fixture
def unvouched(tiny_dataset, monkeypatch):
    """Make the tiny dataset one whose card knows no digests."""
    import tiny_plugin

    bare = [one.model_copy(update={"digest": None}) for one in tiny_dataset.card.traverses]
    monkeypatch.setattr(tiny_plugin, "card", tiny_dataset.card.model_copy(update={"traverses": bare}))
    return tiny_plugin.card


def touch(folder):
    path = folder / "day_left" / "Image003.jpg"
    path.write_bytes(path.read_bytes() + b"\0")


def test_what_is_met_first_is_recorded_and_what_comes_then_is_compared(unvouched, tiny_dataset):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        load_case("tiny")
        load_case("tiny")
    touch(tiny_dataset.folder)
    with pytest.warns(DatasetWarning, match="not the copy that was met here first.*`vpr-bench data verify tiny`"):
        load_case("tiny")


def test_another_copy_can_be_accepted(unvouched, tiny_dataset):
    load_case("tiny")
    touch(tiny_dataset.folder)
    (fault,) = verify_images(unvouched, tiny_dataset.folder, "tiny")
    assert "was met here first" in str(fault)
    accept_images(unvouched, tiny_dataset.folder, "tiny")
    assert verify_images(unvouched, tiny_dataset.folder, "tiny") == []


def test_neither_simulated_images_nor_the_users_own_are_held_against_a_record(unvouched, tiny_dataset, tmp_path):
    own = shutil.copytree(tiny_dataset.folder, tmp_path / "mine")
    shutil.rmtree(own / "night_right")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name in ("tiny:simulated", str(own)):
            touch(load_case(name).folder)
            load_case(name)


def test_a_record_is_replaced_and_the_others_stay(data_folder, tmp_path):
    assert known_digest("a/b") is None
    remember_digest("a/b", "sha256:1", tmp_path)
    remember_digest("a/c", "sha256:2", tmp_path)
    remember_digest("a/b", "sha256:3", tmp_path)
    assert (known_digest("a/b"), known_digest("a/c")) == ("sha256:3", "sha256:2")


def test_a_damaged_record_is_a_data_error(data_folder, tmp_path):
    remember_digest("a/b", "sha256:1", tmp_path)
    file = next((tmp_path / "state").rglob("known_digests.json"))
    file.write_text("[1")
    with pytest.raises(DataError, match="is damaged; delete it"):
        known_digest("a/b")
