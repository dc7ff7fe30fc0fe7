import dataclasses

import numpy as np
import pytest

from vpr_bench.dataset.load import load_case
from vpr_bench.report.pictures import RunPictures


@pytest.fixture
def run(tiny_dataset, stored):
    """A stored run that says it is about the tiny dataset's images."""

    def make(protocol="tiny/day_left-day_right@1f", **changes):
        of_tiny = stored(protocol, folder=f"run{len(changes)}")
        digest = load_case("tiny", "day_left-day_right").digest
        key = of_tiny.record.key.model_copy(update={"dataset_digest": digest, **changes})
        return dataclasses.replace(of_tiny, record=of_tiny.record.model_copy(update={"key": key}))

    return make


def test_images_are_found_again(run, tiny_dataset):
    said = []
    pictures = RunPictures(run(), said.append)
    case = load_case("tiny", "day_left-day_right")
    assert np.array_equal(pictures.query_image(3), case.queries[3])
    assert np.array_equal(pictures.reference_image(5), case.references[5])
    assert pictures.query_name(3) == "day_right/Image003.jpg"
    assert pictures.reference_name(5) == "day_left/Image005.jpg"
    assert said == []


def test_nothing_is_looked_for_before_it_is_asked_for(run, tiny_dataset):
    said = []
    of_tiny = run()
    tiny_dataset.without_images()
    RunPictures(of_tiny, said.append)
    assert said == []


def test_what_is_not_here_has_a_number_and_one_warning(run, tiny_dataset):
    said = []
    pictures = RunPictures(run(source="tiny:real"), said.append)
    tiny_dataset.without_images()
    assert pictures.query_image(3) is None and pictures.reference_image(5) is None
    assert (pictures.query_name(3), pictures.reference_name(5)) == ("query 3", "reference 5")
    assert len(said) == 1 and "cannot be shown" in said[0]


def test_nothing_is_rendered_for_names_alone(run, tiny_dataset):
    said = []
    simulated = run("tiny:simulated/day_left-day_right@1f")
    pictures = RunPictures(simulated, said.append, render=False)
    assert pictures.query_name(3) == "query 3" and tiny_dataset.rendered == []
    assert len(said) == 1 and "have not been rendered on this machine" in said[0]
    digest = load_case("tiny:simulated", "day_left-day_right").digest
    rendered = run("tiny:simulated/day_left-day_right@1f", dataset_digest=digest)
    assert RunPictures(rendered, said.append, render=False).query_name(3) == "day_right/Image003.jpg"


def test_the_policy_of_a_run_is_kept(run):
    pictures = RunPictures(run("tiny/day_left-day_right@1f~reject"), print, "tiny")
    assert pictures.case is not None and pictures.case.protocol.unmatched == "reject"


def test_other_images_are_not_taken_for_those_of_the_run(run):
    said = []
    pictures = RunPictures(run(dataset_digest="sha256:" + "0" * 64), said.append)
    assert pictures.query_image(0) is None
    assert len(said) == 1 and "they are not those of the run: sha256:00000000… then" in said[0]


def test_a_dataset_that_is_gone(run):
    said = []
    pictures = RunPictures(run("nowhere/day_left-day_right@1f"), said.append)
    assert pictures.case is None and len(said) == 1 and "nowhere" in said[0]


def test_a_folder_of_ones_own_is_named(run, tiny_dataset):
    said = []
    of_tiny = run("mine/day_left-day_right@1f")
    assert RunPictures(of_tiny, said.append, "tiny").query_name(0) == "day_right/Image000.jpg"
    assert RunPictures(of_tiny, said.append, "/no/such/folder").case is None
    assert len(said) == 1 and "/no/such/folder" in said[0]


def test_an_image_that_cannot_be_decoded_leaves_the_others(run, tiny_dataset, monkeypatch):
    said = []
    pictures = RunPictures(run(), said.append)
    assert pictures.case is not None
    (tiny_dataset.folder / "day_right" / "Image003.jpg").write_bytes(b"no image")
    assert pictures.query_image(3) is None and pictures.query_image(4) is not None
    assert len(said) == 1 and "Image003.jpg" in said[0]
