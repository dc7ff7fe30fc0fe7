import pytest


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
    made.given = {"lists": [[one] for one in range(10)], "warning": ""}
    made.options["day"] = {"warning": ""}
    (made.folder / "day" / "truth.mat").touch()
    source = made.source()
    loader = source.card.loader.model_copy(update={"options": {"files": [{"truth": "day/truth.mat"}]}})
    from vpr_bench.dataset.lint.junk import find_junk

    assert len(find_junk(source.card, made.folder, {"day": _none()})) == 1
    assert find_junk(source.card.model_copy(update={"loader": loader}), made.folder, {"day": _none()}) == []


def _none():
    from vpr_bench.dataset.recording import Recording
    from vpr_bench.types.traverse import Traverse

    return Recording(Traverse("day", []))


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
