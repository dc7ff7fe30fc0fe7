import pytest

from vpr_bench.dataset.lint.junk import find_junk
from vpr_bench.dataset.recording import Recording
from vpr_bench.types.traverse import Traverse


@pytest.mark.parametrize("name", [".DS_Store", "._00.png", "Thumbs.db", "desktop.ini", "DESKTOP.INI"])
@pytest.mark.parametrize("folder", [".", "day"])
def test_litter_of_operating_systems(made, name, folder):
    (made.folder / folder / name).touch()
    finding = made.only()
    assert (finding.check, finding.severity) == ("junk-files", "note")
    assert finding.where == ("day" if folder == "day" else str(made.folder))
    assert finding.message == f"1 file of an operating system, passed by: {name}"


def test_folders_that_an_archiver_leaves(made):
    (made.folder / "__MACOSX").mkdir()
    assert made.only().check == "junk-files"


@pytest.mark.parametrize("name", ["places.pkl", "places.p", "places.PICKLE"])
def test_pickles_are_never_read(made, name):
    (made.folder / "night" / name).write_bytes(b"cos\nsystem\n(S'exit 1'\ntR.")
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("junk-files", "warning", "night")
    assert name in finding.message


def test_matlab_files(made):
    (made.folder / "day" / "truth.mat").touch()
    finding = made.only()
    assert (finding.check, finding.severity) == ("junk-files", "note")
    assert "1 MATLAB file that nothing here names: truth.mat" in finding.message


def test_files_that_the_card_names_are_not_junk(made):
    (made.folder / "day" / "truth.mat").touch()
    card, day = made.source().card, {"day": Recording(Traverse("day", []))}
    assert len(find_junk(card, made.folder, day)) == 1
    named = card.loader.model_copy(update={"options": {"files": [{"truth": "day/truth.mat"}]}})
    assert find_junk(card.model_copy(update={"loader": named}), made.folder, day) == []


def test_folders_of_images_deeper_down(made):
    inner = made.folder / "day" / "left"
    inner.mkdir()
    (inner / "Thumbs.db").touch()
    recording = Recording(Traverse("day", [inner / "0.png", inner / "1.png"]))
    (finding,) = find_junk(made.source().card, made.folder, {"day": recording})
    assert finding.where == "day/left"


@pytest.mark.parametrize("name", ["gps.csv", "README.txt", "labels.npy", ".hidden", "truth.p.txt"])
def test_other_files_are_left_alone(made, name):
    (made.folder / "day" / name).touch()
    assert made.lint() == []


def test_many_are_counted(made):
    for index in range(10):
        (made.folder / "day" / f"._{index:02d}.png").touch()
    assert made.only().message.endswith(
        "10 files of an operating system, passed by: ._00.png, ._01.png, ._02.png and 7 more"
    )
