import pytest

from vpr_bench.errors import UsageError
from vpr_bench.gate.selection import Selection, Subject
from vpr_bench.types.protocol import Protocol


def subject(label="hog(cell=8)", protocol="gardens:simulated/day_left-night_right@2f"):
    return Subject(label, label.partition("(")[0], Protocol.parse(protocol))


@pytest.mark.parametrize(
    ("selection", "wanted"),
    [
        ({}, True),
        ({"methods": ["hog"]}, True),
        ({"methods": ["hog(cell=8)"]}, True),
        ({"methods": ["hog(cell=9)", "sad"]}, False),
        ({"datasets": ["gardens"]}, True),
        ({"datasets": ["gardens:simulated"]}, True),
        ({"datasets": ["gardens:real"]}, False),
        ({"datasets": ["gardens/day_left-night_right"]}, True),
        ({"datasets": ["gardens/day_left-day_right"]}, False),
        ({"datasets": ["nordland"]}, False),
        ({"protocols": ["day_left-night_right"]}, True),
        ({"protocols": ["day_left-night_right@2f"]}, True),
        ({"protocols": ["day_left-night_right@5f"]}, False),
        ({"protocols": ["day_left-night_right@2f~reject"]}, False),
        ({"datasets": ["gardens:simulated/day_left-night_right@2f"]}, True),
        ({"datasets": ["gardens:simulated/day_left-night_right@2f~miss"]}, False),
        ({"datasets": ["gardens/day_left-night_right@2f"]}, False),
        ({"methods": ["hog"], "protocols": ["day_left-day_right"]}, False),
    ],
    ids=str,
)
def test_what_is_asked_about(selection, wanted):
    assert Selection(**selection).wants(subject()) is wanted


@pytest.mark.parametrize(
    ("selection", "said"),
    [
        ({"methods": ["hogg"]}, "method 'hogg'. Did you mean 'hog'"),
        ({"datasets": ["nordland"]}, "dataset 'nordland'"),
        ({"protocols": ["day_left-day_right"]}, "Did you mean 'day_left-night_right'"),
    ],
)
def test_a_name_that_means_nothing_is_refused(selection, said):
    with pytest.raises(UsageError, match=said):
        Selection(**selection).check([subject()])


@pytest.mark.parametrize("name", ["day_left-night_right@", "day_left-night_right@5x", "day_left@5f"])
def test_a_protocol_that_cannot_be_read_is_refused(name):
    with pytest.raises(UsageError, match=r"is no protocol\. Write it like"):
        Selection(protocols=[name])


def test_a_run_is_asked_about_on_each_protocol_that_is_named(store):
    def protocols(**selection):
        run = store(protocol="gardens/day_left-day_right@2f~miss", label=f"m{len(list(tmp))}")
        tmp.append(run)
        return [one.record.protocol.partition("@")[2] for one in Selection(**selection).asked_of(run)]

    tmp = []
    assert protocols() == ["2f~miss"]
    assert protocols(protocols=["day_left-day_right"]) == ["2f~miss"]
    assert protocols(protocols=["day_left-day_right@5f"]) == ["5f~miss"]
    assert protocols(protocols=["day_left-day_right@5f", "day_left-day_right@2f~reject"]) == ["5f~miss", "2f~reject"]
    assert protocols(datasets=["gardens/day_left-day_right@7f"]) == ["7f"]
    assert protocols(datasets=["gardens"], protocols=["day_left-night_right@5f"]) == []


def test_a_method_that_is_not_installed_is_meant_inside_others_too(tmp_path):
    (tmp_path / "mine.py").write_text("class Mine: ...")
    around = Subject("seqslam(inner=mine.py:Mine)", "seqslam", subject().protocol, frozenset({"mine.py:Mine", "hog"}))
    assert Selection(methods=[f"{tmp_path}/mine.py:Mine"]).wants(around)
    assert not Selection(methods=["hog"]).wants(around)


def test_two_methods_of_one_name_are_refused(tmp_path):
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "mine.py").write_text("class Mine: ...")
    with pytest.raises(UsageError, match=r"are both called 'mine\.py:Mine'"):
        Selection(methods=[f"{tmp_path}/{folder}/mine.py:Mine" for folder in ("a", "b")])


def test_a_file_is_a_method_by_its_name_without_folders(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text("class Mine: ...")
    selection = Selection(methods=[f"{file}:Mine"])
    assert selection.wants(subject("mine.py:Mine(size=3)".replace("(size=3)", "")))
    assert selection.sources.methods == {"mine.py:Mine": f"{file}:Mine"}


def test_what_is_trusted_chooses_nothing(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text("class Mine: ...")
    selection = Selection(trusted=[f"{file}:Mine"])
    assert selection.sources.methods == {"mine.py:Mine": f"{file}:Mine"}
    assert selection.wants(subject())
    selection.check([subject()])
    with pytest.raises(UsageError, match="no method 'mine'"):
        Selection(trusted=["mine"])


def test_a_folder_of_ones_own_is_a_dataset_by_its_id(tmp_path, tiny_images):
    selection = Selection(datasets=[str(tiny_images)])
    (dataset,) = selection.sources.folders
    assert selection.wants(subject(protocol=f"{dataset}/day_left-day_right@1f"))
    assert not selection.wants(subject())
