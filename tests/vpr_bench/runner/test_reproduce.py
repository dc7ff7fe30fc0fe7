"""Runs done again: what must be the same, what is refused, and what is said of the answers."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from vpr_bench.dataset.load import load_case
from vpr_bench.errors import DataError, UsageError
from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.files.digest import sha256_of_file
from vpr_bench.method.build import build_method
from vpr_bench.runner.agreement import agreement
from vpr_bench.runner.environment import differences, environment
from vpr_bench.runner.reproduce import rebuild, reproduce
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore, StoredRun

HOG = {"width": 32, "height": 32, "cell": 8}
METHOD = """
from pathlib import Path

import numpy as np

from vpr_bench.shortlist import shortlist
from vpr_bench.types.match import Match

HERE = Path(__file__).parent


class Mean:
    version = "1"

    def __init__(self, size: int = 1) -> None:
        self.size = size

    def weights_digest(self):
        return (HERE / "weights.txt").read_text()

    def fit(self, references):
        self.database_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def match(self, image, k):
        offset = float((HERE / "offset.txt").read_text())
        if offset == 99:
            raise KeyboardInterrupt
        shortlist("half", np.arange(len(self.database_)))
        return Match.from_scores(offset - np.linalg.norm(self.database_ - image.mean(axis=(0, 1)), axis=1), k)
"""


@pytest.fixture
def again(tmp_path):
    return RunStore(tmp_path / "reproduced")


@pytest.fixture
def hog(tiny_dataset, store):
    return run(load_case("tiny"), build_method("hog", HOG, 3), store, RunOptions(seed=3, k=4, limit=7, threads=1))


@pytest.fixture
def mine(tmp_path):
    """Return a method in a file, whose weights and answers hang on files beside it."""
    file = tmp_path / "methods" / "mine.py"
    file.parent.mkdir()
    file.write_text(METHOD)
    (file.parent / "weights.txt").write_text("sha256:one")
    (file.parent / "offset.txt").write_text("0")
    return f"{file}:Mean"


@pytest.fixture
def own(tiny_dataset, store, mine):
    return run(load_case("tiny"), build_method(mine), store, RunOptions(k=4, threads=1))


def beside(mine, name):
    return Path(mine.rpartition(":")[0]).parent / name


def edit(stored, change):
    """Change a run.json, as somebody might, in a folder whose name does not give it away."""
    content = json.loads((stored.folder / "run.json").read_text())
    change(content)
    folder = stored.folder.rename(stored.folder.with_name("mine"))
    (folder / "run.json").write_text(json.dumps(content))
    return StoredRun.open(folder)


def test_a_run_is_done_again_and_is_the_same(hog, again):
    before = {file.name: file.read_bytes() for file in hog.folder.iterdir()}
    second = reproduce(hog, again)
    assert second.folder != hog.folder and second.record.key == hog.record.key
    assert second.record.protocol == hog.record.protocol and second.record.partial
    agreed = agreement(hog, second)
    assert agreed.identical and agreed.same_file and agreed.queries == 7 and agreed.shortlists is None
    assert {file.name: file.read_bytes() for file in hog.folder.iterdir()} == before


def test_one_of_schema_1(hog, again):
    def age(content):
        content.pop("provenance")
        content["schema_version"] = 1
        content["machine"].pop("memory_bytes")
        content["machine"].pop("blas")

    old = edit(hog, age)
    second = reproduce(old, again)
    assert agreement(old, second).identical
    assert {"memory", "BLAS", "method from"} <= {one.what for one in differences(old.record, second.record)}


def test_radius_policy_and_time_out_are_those_of_the_run(tiny_dataset, store, again):
    case = load_case("tiny/day_left-night_right@3f~reject")
    stored = run(case, build_method("hog", HOG), store, RunOptions(timeout=60))
    record = reproduce(stored, again).record
    assert (record.protocol, record.timeout) == ("tiny/day_left-night_right@3f~reject", 60)


def test_methods_inside_are_built_again(tiny_dataset, store, again):
    given = {"past": 3, "inner": "hog", **{f"inner.{name}": value for name, value in HOG.items()}}
    stored = run(load_case("tiny"), build_method("seqslam", given), store)
    assert rebuild(stored.record).parameters == build_method("seqslam", given).parameters
    assert agreement(stored, reproduce(stored, again)).identical


def test_a_method_inside_from_a_file(tiny_dataset, store, again, mine):
    stored = run(load_case("tiny"), build_method("seqslam", {"past": 3, "inner": mine}), store)
    with pytest.raises(UsageError, match=r"not installed.*--method path/to/file.py:Class"):
        reproduce(stored, again)
    assert agreement(stored, reproduce(stored, again, [mine])).identical


def test_a_complete_one_is_done_anew(hog, again):
    first = reproduce(hog, again).record
    (again.folder(first.key) / "mark").touch()
    assert not (reproduce(hog, again).folder / "mark").exists()


def test_a_damaged_one_is_put_aside(hog, again):
    folder = reproduce(hog, again).folder
    (folder / "matches.npz").write_bytes(b"")
    with pytest.warns(UserWarning, match="put aside"):
        assert agreement(hog, reproduce(hog, again)).identical


def test_an_interrupted_one_goes_on(own, again, mine, monkeypatch):
    beside(mine, "offset.txt").write_text("99")
    with pytest.raises(KeyboardInterrupt):
        reproduce(own, again, [mine])
    beside(mine, "offset.txt").write_text("0")
    partial = again.folder(own.record.key).with_name(own.folder.name + ".partial")
    assert partial.is_dir()
    assert agreement(own, reproduce(own, again, [mine])).identical
    assert not partial.exists()


def test_a_run_cannot_name_a_file_to_be_executed(own, again, mine, monkeypatch):
    monkeypatch.chdir(beside(mine, ""))
    with pytest.raises(UsageError, match="not installed"):
        reproduce(own, again)


def test_a_method_that_the_run_does_not_have(hog, again, mine):
    with pytest.raises(UsageError, match=r"The run has no method 'mine.py:Mean'. Known: hog"):
        reproduce(hog, again, [mine])


def test_the_run_itself_is_never_overwritten(hog, store):
    before = (hog.folder / "run.json").stat().st_mtime_ns
    with pytest.raises(UsageError, match="would take the place"):
        reproduce(hog, RunStore(store.root / ".." / store.root.name))
    assert (hog.folder / "run.json").stat().st_mtime_ns == before


def test_another_version(hog, again, monkeypatch):
    monkeypatch.setattr("vpr_baselines.hog.Hog.version", "2")
    with pytest.raises(DataError, match=r"version of hog .* recorded was 1, found is 2.*\n.*made with: vpr-bench \d"):
        reproduce(hog, again)
    assert not again.root.exists()


def test_edited_source(tiny_dataset, store, again, mine):
    file = Path(mine.rpartition(":")[0])
    file.write_text(METHOD.replace('    version = "1"\n', ""))
    stored = run(load_case("tiny"), build_method(mine), store)
    file.write_text(file.read_text() + "\n")
    with pytest.raises(
        DataError, match=r"version of mine.py:Mean .* source:.* source:.*\n.*the file of its method as it was then"
    ):
        reproduce(stored, again, [mine])


def test_other_weights(own, again, mine):
    beside(mine, "weights.txt").write_text("sha256:two")
    with pytest.raises(DataError, match=r"weights of mine.py:Mean .* recorded was sha256:one, found is sha256:two"):
        reproduce(own, again, [mine])
    assert not again.root.exists()


def test_missing_weights(own, again, mine):
    beside(mine, "weights.txt").unlink()
    with pytest.raises(DataError, match=r"weights of .* cannot be found"):
        reproduce(own, again, [mine])


@pytest.mark.filterwarnings("ignore:.*is not the copy:UserWarning")
def test_other_images(hog, again, tiny_dataset):
    images = sorted((tiny_dataset.folder / "day_right").iterdir())
    shutil.copy(images[0], images[1])
    with pytest.raises(DataError, match=r"digest of the images .* recorded was sha256:.*\n.*data verify tiny"):
        reproduce(hog, again)
    assert not again.root.exists()


def test_an_own_folder_has_to_be_named(tiny_dataset, tmp_path, store, again):
    mine = tmp_path / "mine"
    for part in ("day_left", "day_right"):
        shutil.copytree(tiny_dataset.folder / part, mine / part)
    stored = run(load_case(str(mine), "day_left-day_right"), build_method("hog", HOG), store)
    with pytest.raises(DataError, match="say where with --dataset PATH"):
        reproduce(stored, again)
    second = reproduce(stored, again, dataset=str(mine.rename(tmp_path / "moved")))
    assert second.record.key == stored.record.key and agreement(stored, second).identical


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            lambda content: content["key"].update(k=5, pairing="day_left-night_right"),
            "The pairing in its key .* was day_left-night_right",
        ),
        (lambda content: content["key"].update(method="nothing"), "There is no method 'nothing'"),
        (lambda content: content["key"].update(method="os:system"), "not installed"),
        (lambda content: content["key"]["parameters"].update(colour="red"), "no parameter 'colour'"),
        (lambda content: content["key"]["parameters"].pop("cell"), "parameter cell .* recorded was none, found is 16"),
        (lambda content: content["key"].update(k=500), "k must lie between"),
        (lambda content: content.update(timeout=-1), "time-out must be positive"),
        (lambda content: content["key"].update(threads=0), "threads must lie between 1 and"),
        (lambda content: content["key"].update(threads=-1), "threads must lie between 1 and"),
        (lambda content: content["key"].update(threads=10**9), "threads must lie between 1 and"),
        (lambda content: content["key"].update(parameters={"inner": {"method": "hog", "parameters": 3}}), "inner"),
        (lambda content: content.update(protocol="other/a-b@1f"), "There is no dataset 'other'"),
    ],
)
def test_an_edited_run(hog, again, change, said):
    with pytest.raises((DataError, UsageError), match=said):
        reproduce(edit(hog, change), again)
    assert not again.root.exists()


def test_other_answers_are_counted(own, again, mine):
    beside(mine, "offset.txt").write_text("0.5")
    agreed = agreement(own, reproduce(own, again, [mine]))
    assert not agreed.identical and not agreed.same_file
    assert (agreed.best, agreed.ranking, agreed.scores) == (0, 0, 12)
    assert agreed.largest == pytest.approx(0.5, abs=1e-4)
    assert agreed.labels and agreed.shortlists


def tampered(stored, name, change):
    """Change an array file of a run, and its digest with it."""
    arrays = {key: array.copy() for key, array in read_arrays(stored.folder / name).items()}
    write_arrays(stored.folder / name, change(arrays) or arrays)
    return edit(stored, lambda content: content["files"].update({name: sha256_of_file(stored.folder / name)}))


def swap_last_two(arrays):
    arrays["indices"][2, -2:] = arrays["indices"][2, :-3:-1]


def swap_first_two(arrays):
    arrays["indices"][2, :2] = arrays["indices"][2, 1::-1]


@pytest.mark.parametrize(
    ("name", "change", "best", "ranking", "unpaired", "labels", "shortlists"),
    [
        ("matches.npz", swap_last_two, 0, 1, 0, True, True),
        ("matches.npz", swap_first_two, 1, 1, 0, True, True),
        ("matches.npz", lambda arrays: {key: array[1:] for key, array in arrays.items()}, 0, 0, 1, True, True),
        ("labels.npz", lambda arrays: arrays["references"].__setitem__(0, 9), 0, 0, 0, False, True),
        ("shortlists.npz", lambda arrays: dict(list(arrays.items())[:1]), 0, 0, 0, True, False),
    ],
)
def test_what_differs_is_told_apart(own, again, mine, name, change, best, ranking, unpaired, labels, shortlists):
    second = tampered(reproduce(own, again, [mine]), name, change)
    agreed = agreement(own, second)
    assert not agreed.identical
    assert (agreed.best, agreed.ranking, agreed.unpaired) == (best, ranking, unpaired)
    assert (agreed.labels, agreed.shortlists) == (labels, shortlists)
    assert (agreed.scores, agreed.largest) == (0, 0)


def test_a_file_packed_otherwise_is_the_same(own, again, mine):
    second = reproduce(own, again, [mine])
    np.savez_compressed(second.folder / "matches.npz", **read_arrays(second.folder / "matches.npz"))
    second = edit(
        second, lambda content: content["files"].update({"matches.npz": sha256_of_file(second.folder / "matches.npz")})
    )
    agreed = agreement(own, second)
    assert agreed.identical and not agreed.same_file


def test_different_runs_are_not_compared(hog, own):
    with pytest.raises(UsageError, match="not the same run"):
        agreement(hog, own)


def test_environments(hog):
    assert differences(hog.record, hog.record) == []
    machine = hog.record.machine
    other = hog.record.model_copy(
        update={
            "machine": machine.model_copy(
                update={"cores": machine.cores + 1, "libraries": machine.libraries | {"numpy": "9"}}
            )
        }
    )
    assert [one.what for one in differences(hog.record, other)] == ["cores", "numpy"]
    assert environment(other)["numpy"] == "9"
