import threading

import numpy as np
import pytest

from vpr_bench.checkpoint import CheckpointWarning, checkpoints, kept, load_checkpoint, save_checkpoint


class Steps:
    """Computes arrays that tell how often something was computed."""

    def __init__(self):
        self.done = []

    def __call__(self, name):
        def compute():
            self.done.append(name)
            return {"n": np.array([len(self.done)]), "words": np.array(["grün", name])}

        return compute


@pytest.fixture
def steps():
    return Steps()


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "work" / "checkpoints"


def test_nothing_is_kept_when_nobody_listens(steps, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert [kept("a", steps("a"))["n"].item() for _ in range(2)] == [1, 2]
    save_checkpoint("b", {"x": np.zeros(2)})
    assert load_checkpoint("b") is None
    assert list(tmp_path.iterdir()) == []


def test_an_interrupted_fit_goes_on(steps, folder):
    def fit(fail=False):
        first = kept("first", steps("first"))
        if fail:
            raise KeyboardInterrupt
        return first["n"].item(), kept("second", steps("second"))["n"].item()

    with pytest.raises(KeyboardInterrupt), checkpoints(folder):
        fit(fail=True)
    with checkpoints(folder) as resumed:
        assert fit() == (1, 2)
    assert resumed.resumed
    assert steps.done == ["first", "second"]


def test_what_is_given_back_is_what_was_computed(folder):
    arrays = {
        "half": np.asfortranarray(np.arange(6, dtype=np.float16).reshape(2, 3)),
        "none": np.empty((0, 4), np.int8),
        "scalar": np.array(True),
        "text": np.array(["ä", "bc"]),
        "with.dot": np.arange(3, dtype=np.uint64),
    }
    for _ in range(2):
        with checkpoints(folder):
            found = kept("all", lambda: arrays)
        assert found.keys() == arrays.keys()
        for name, array in arrays.items():
            assert found[name].dtype == array.dtype
            np.testing.assert_array_equal(found[name], array)
            found[name].setflags(write=True)


def test_a_loop_goes_on_from_its_last_round(folder):
    def train(rounds):
        state = load_checkpoint("epochs")
        done = [] if state is None else state["done"].tolist()
        for number in range(len(done), rounds):
            done.append(number)
            save_checkpoint("epochs", {"done": np.array(done)})
        return done

    with checkpoints(folder):
        train(3)
    with checkpoints(folder):
        assert load_checkpoint("epochs")["done"].tolist() == [0, 1, 2]
    with checkpoints(folder):
        assert train(5) == [0, 1, 2, 3, 4]
    assert len(list(folder.iterdir())) == 1


def test_two_methods_inside_one_do_not_read_each_other(folder):
    def fit(value):
        descriptors = kept("descriptors", lambda: {"x": np.array([value])})["x"].item()
        state = load_checkpoint("epochs")
        save_checkpoint("epochs", {"x": np.array([value])})
        return descriptors, None if state is None else state["x"].item()

    with checkpoints(folder):
        assert [fit(value) for value in (1, 2, 3)] == [(1, None), (2, None), (3, None)]
    with checkpoints(folder):
        assert [fit(value) for value in (1, 2, 3)] == [(1, 1), (2, 2), (3, 3)]


def test_steps_inside_a_step_do_not_move_the_names_outside(steps, folder):
    """A step that is given back does not take its own steps again: later ones must find their names all the same."""

    def outer():
        return {"sum": kept("x", steps("inner x"))["n"] + 10}

    def fit(fail=False):
        first = kept("outer", outer)["sum"].item()
        if fail:
            raise RuntimeError
        return first, kept("x", steps("outer x"))["n"].item()

    with pytest.raises(RuntimeError), checkpoints(folder):
        fit(fail=True)
    assert sorted(path.name for path in folder.rglob("*")) == ["outer+1.npz"]  # what was inside has served
    with checkpoints(folder):
        assert fit() == (11, 2)
    assert steps.done == ["inner x", "outer x"]


def test_an_interrupted_step_keeps_its_own_steps(steps, folder):
    def outer():
        kept("x", steps("x"))
        if len(steps.done) == 1:
            steps("interruption")()
            raise KeyboardInterrupt
        return kept("y", steps("y"))

    with pytest.raises(KeyboardInterrupt), checkpoints(folder):
        kept("outer", outer)
    with checkpoints(folder) as resumed:
        kept("outer", outer)
    assert steps.done == ["x", "interruption", "y"]
    assert resumed.resumed


@pytest.mark.parametrize("name", ["../../escape", "/etc/passwd", "..", "a/b", "a b%2F", "über", "CON", ""])
def test_any_name_is_one_file_in_the_folder(name, folder):
    for value in (1, 2):
        with checkpoints(folder):
            assert kept(name, lambda value=value: {"x": np.array(value)})["x"] == 1
    assert [path.parent for path in folder.parents[1].rglob("*") if path.is_file()] == [folder]


@pytest.mark.filterwarnings("ignore:Cannot write")
@pytest.mark.parametrize("damage", ["truncated", "bytes", "empty", "pickle", "folder"])
def test_what_is_damaged_is_computed_again(steps, folder, damage):
    with checkpoints(folder):
        kept("a", steps("a"))
    (file,) = folder.iterdir()
    content = file.read_bytes()
    if damage == "truncated":
        file.write_bytes(content[: len(content) // 2])
    elif damage == "bytes":
        middle = content.index(b"NUMPY") + 130
        file.write_bytes(content[:middle] + bytes([content[middle] ^ 255]) + content[middle + 1 :])
    elif damage == "empty":
        file.write_bytes(b"")
    elif damage == "pickle":
        np.savez(file, n=np.array([{"an": "object"}]))
    else:
        file.unlink()
        file.mkdir()
    with pytest.warns(CheckpointWarning, match="It is computed again"), checkpoints(folder) as resumed:
        kept("a", steps("a"))
    assert steps.done == ["a", "a"]
    assert not resumed.resumed


def test_a_disk_that_refuses_does_not_stop_the_fit(steps, tmp_path):
    (tmp_path / "file").write_text("in the way")
    with pytest.warns(CheckpointWarning, match="in the way"), checkpoints(tmp_path / "file"):
        assert kept("a", steps("a"))["n"] == 1


def test_other_threads_keep_nothing(folder):
    with checkpoints(folder):
        thread = threading.Thread(target=save_checkpoint, args=("a", {"x": np.zeros(1)}))
        thread.start()
        thread.join()
    assert not folder.exists()


def test_a_failed_step_is_not_kept(steps, folder):
    def fail():
        raise ValueError("no")

    with pytest.raises(ValueError, match="no"), checkpoints(folder):
        kept("a", fail)
    with checkpoints(folder):
        assert kept("a", steps("a"))["n"] == 1
