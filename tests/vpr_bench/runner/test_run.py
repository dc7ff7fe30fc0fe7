import json
import threading

import numpy as np
import pytest

from vpr_bench.errors import DataError, UsageError, VprBenchError
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import StoredRun, StoreWarning
from vpr_bench.timing import stage
from vpr_bench.types.match import Match


def test_answers_every_query_with_its_place(case, store, built, mean_colour):
    stored = run(case, built(mean_colour()), store)
    assert stored.indices[:, 0].tolist() == list(range(len(case.queries)))
    assert stored.record.n_queries == len(case.queries)
    assert not stored.record.partial
    assert stored.record.key.k == len(case.references)  # the default of 20 is cut to the map
    assert {"decode", "encode", "match", "total"} <= stored.seconds.keys()
    assert all(len(column) == len(case.queries) for column in stored.seconds.values())
    assert np.all(stored.seconds["total"] >= stored.seconds["encode"])
    assert stored.record.peak_memory["fit"] > 1_000_000


def test_same_run_is_not_run_again(case, store, built, mean_colour):
    first, second = mean_colour(), mean_colour()
    run(case, built(first), store)
    run(case, built(second), store)
    assert (first.fits, second.fits) == (1, 0)


def test_another_radius_is_the_same_run(case, store, built, mean_colour):
    from dataclasses import replace

    first = run(case, built(mean_colour()), store)
    second = mean_colour()
    again = run(replace(case, protocol=case.protocol.with_radius(3)), built(second), store)
    assert second.fits == 0
    assert again.folder == first.folder


@pytest.mark.parametrize("change", [{"seed": 1}, {"k": 3}, {"limit": 4}, {"threads": 1}])
def test_whatever_changes_answers_or_times_is_another_run(case, store, built, mean_colour, change):
    ours = {"threads": 2}
    first = run(case, built(mean_colour()), store, RunOptions(**ours))
    second = run(case, built(mean_colour()), store, RunOptions(**(ours | change)))
    assert first.folder != second.folder


def test_parameters_and_images_make_another_run(case, store, built, mean_colour):
    from dataclasses import replace

    folders = {
        run(case, built(mean_colour()), store).folder,
        run(case, built(mean_colour(), size=2), store).folder,
        run(replace(case, digest="sha256:" + "1" * 64), built(mean_colour()), store).folder,
    }
    assert len(folders) == 3


def test_same_seed_gives_the_same_bytes(case, store, built, mean_colour):
    first = run(case, built(mean_colour()), store).folder.joinpath("matches.npz").read_bytes()
    again = run(case, built(mean_colour()), store, RunOptions(overwrite="always"))
    assert again.folder.joinpath("matches.npz").read_bytes() == first


def test_order_of_queries_leaves_no_trace_in_the_answers(case, store, built, mean_colour):
    first, second = (run(case, built(mean_colour()), store, RunOptions(seed=seed)) for seed in (0, 1))
    assert first.folder != second.folder
    assert (first.folder / "matches.npz").read_bytes() == (second.folder / "matches.npz").read_bytes()


def test_queries_come_in_a_shuffled_order(case, store, built):
    seen = []

    class Counter:
        def fit(self, references):
            seen.clear()

        def match(self, image, k):
            seen.append(int(image[0, 0, 0]))
            return Match(range(k), np.zeros(k))

    run(case, built(Counter()), store)
    asked = seen[-len(case.queries) :]
    in_order = [int(image[0, 0, 0]) for image in case.queries]
    assert asked != in_order
    assert sorted(asked) == sorted(in_order)


def test_step_counter_scores_no_better_than_chance(case, store, built):
    """A method that ignores the image and counts must not profit from frames being aligned."""

    class Counter:
        def fit(self, references):
            self.step = -3  # it even knows how long the warm-up is

        def match(self, image, k):
            self.step += 1
            return Match((np.arange(k) + max(self.step - 1, 0)) % 12, np.zeros(k))

    stored = run(case, built(Counter()), store)
    assert np.mean(stored.indices[:, 0] == np.arange(len(case.queries))) < 0.5


def test_warm_up_shows_a_reference_and_no_query(case, store, built):
    seen = []

    class Watcher:
        def fit(self, references):
            pass

        def match(self, image, k):
            seen.append(image.copy())
            return Match(range(k), np.zeros(k))

    run(case, built(Watcher()), store)
    warm_up = len(seen) - len(case.queries)
    assert warm_up > 0
    assert all(np.array_equal(image, case.references[0]) for image in seen[:warm_up])


def test_limit_asks_the_first_of_the_order_and_marks_the_run(case, store, built, mean_colour):
    few = run(case, built(mean_colour()), store, RunOptions(limit=4))
    more = run(case, built(mean_colour()), store, RunOptions(limit=7))
    assert few.record.partial
    assert len(few.queries) == 4
    assert set(few.queries) < set(more.queries)
    assert len(few.places.queries) == 4
    assert few.indices[:, 0].tolist() == few.queries.tolist()


def test_limit_beyond_the_queries_is_no_limit(case, store, built, mean_colour):
    assert not run(case, built(mean_colour()), store, RunOptions(limit=1000)).record.partial


@pytest.mark.parametrize("options", [{"k": 0}, {"k": 13}, {"limit": 0}, {"limit": -2}])
def test_numbers_out_of_range_are_refused(case, store, built, mean_colour, options):
    with pytest.raises(UsageError, match=rf"Got {next(iter(options.values()))}"):
        run(case, built(mean_colour()), store, RunOptions(**options))


def test_interrupted_run_is_continued(case, store, built, mean_colour):
    first = mean_colour(fail_after=8, error=KeyboardInterrupt)
    with pytest.raises(KeyboardInterrupt):
        run(case, built(first), store)
    second = mean_colour()
    stored = run(case, built(second), store)
    assert second.fits == 0  # the fitted map was kept
    assert first.matches + second.matches == len(case.queries) + 2 * 3  # every query once, and two warm-ups
    assert stored.record.resumed
    assert stored.record.provenance.elsewhere is None  # nobody knows for the first process
    assert stored.indices[:, 0].tolist() == list(range(len(case.queries)))


def test_interruption_changes_no_answer(case, store, built, mean_colour, tmp_path):
    whole = run(case, built(mean_colour()), store).folder.joinpath("matches.npz").read_bytes()
    other = type(store)(tmp_path / "other")
    with pytest.raises(KeyboardInterrupt):
        run(case, built(mean_colour(fail_after=6, error=KeyboardInterrupt)), other)
    assert run(case, built(mean_colour()), other).folder.joinpath("matches.npz").read_bytes() == whole


def test_damaged_checkpoint_is_asked_again(case, store, built, mean_colour):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(mean_colour(fail_after=8, error=KeyboardInterrupt)), store)
    checkpoint = next(store.root.rglob("answers.npz"))
    checkpoint.write_bytes(checkpoint.read_bytes()[:100])
    with pytest.warns(StoreWarning, match="asked again"):
        stored = run(case, built(mean_colour()), store)
    assert len(stored.queries) == len(case.queries)


@pytest.mark.parametrize("name", ["matches.npz", "timings.npz", "labels.npz", "run.json"])
@pytest.mark.parametrize("damage", ["cut", "gone"])
def test_damaged_run_is_put_aside_and_redone(case, store, built, mean_colour, name, damage):
    folder = run(case, built(mean_colour()), store).folder
    good = (folder / "matches.npz").read_bytes()
    if damage == "cut":
        (folder / name).write_bytes((folder / name).read_bytes()[:20])
    else:
        (folder / name).unlink()
    with pytest.warns(StoreWarning, match="put aside"):
        run(case, built(mean_colour()), store)
    assert (folder / "matches.npz").read_bytes() == good
    assert folder.with_name(folder.name + ".damaged").is_dir()


def test_never_touches_what_is_there(case, store, built, mean_colour):
    folder = run(case, built(mean_colour()), store).folder
    (folder / "matches.npz").write_bytes(b"")
    with pytest.raises(DataError, match="damaged"):
        run(case, built(mean_colour()), store, RunOptions(overwrite="never"))
    assert (folder / "matches.npz").read_bytes() == b""


def test_never_does_not_continue(case, store, built, mean_colour):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(mean_colour(fail_after=8, error=KeyboardInterrupt)), store)
    with pytest.raises(DataError, match="unfinished"):
        run(case, built(mean_colour()), store, RunOptions(overwrite="never"))


def test_always_runs_again(case, store, built, mean_colour):
    run(case, built(mean_colour()), store)
    again = mean_colour()
    run(case, built(again), store, RunOptions(overwrite="always"))
    assert again.fits == 1


def test_always_keeps_the_old_run_until_the_new_one_is_whole(case, store, built, mean_colour):
    folder = run(case, built(mean_colour()), store).folder
    with pytest.raises(KeyboardInterrupt):
        run(
            case,
            built(mean_colour(fail_after=5, error=KeyboardInterrupt)),
            store,
            RunOptions(overwrite="always"),
        )
    assert StoredRun.open(folder).record.n_queries == len(case.queries)


def test_method_that_raises_is_named_with_the_query(case, store, built, mean_colour):
    with pytest.raises(VprBenchError, match=r"'mean-colour' failed while answering winter\[\d+\]: RuntimeError"):
        run(case, built(mean_colour(fail_after=5)), store)


@pytest.mark.parametrize(
    ("answer", "fault"),
    [
        (lambda k: Match([99], [1.0]), "reference 99 of a map of 12"),
        (lambda k: Match(range(k + 1), np.zeros(k + 1)), "references where 12 were asked for"),
        (lambda k: [1, 2], "a list instead of a Match"),
        (lambda k: Match([0, 0], [1.0, 1.0]), "unique"),
        (lambda k: Match([0], [float("nan")]), "finite"),
    ],
)
def test_answers_that_are_none_are_refused(case, store, built, answer, fault):
    class Wrong:
        def fit(self, references):
            pass

        def match(self, image, k):
            return answer(k)

    with pytest.raises(VprBenchError, match=fault):
        run(case, built(Wrong()), store)
    assert not list(store.root.rglob("run.json"))


def test_two_at_once_do_it_once(case, store, built, mean_colour):
    methods = [mean_colour(), mean_colour()]
    threads = [threading.Thread(target=run, args=(case, built(method), store)) for method in methods]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(method.fits for method in methods) == [0, 1]
    assert len(store.runs()) == 1


def test_unwritable_store(case, built, mean_colour, tmp_path):
    from vpr_bench.runner.store import RunStore

    (tmp_path / "file").touch()
    with pytest.raises(DataError, match="in the way"):
        run(case, built(mean_colour()), RunStore(tmp_path / "file"))


def test_record_says_how(case, store, built, mean_colour):
    stored = run(case, built(mean_colour()), store, RunOptions(threads=1, seed=3))
    record = json.loads((stored.folder / "run.json").read_text())
    assert record["protocol"] == "tiny/summer-winter@1f"
    assert record["key"]["seed"] == 3
    assert record["machine"]["threads"] == 1
    assert record["files"].keys() == {"matches.npz", "timings.npz", "labels.npz"}


def test_a_run_of_a_newer_version_is_left_alone(case, store, built, mean_colour):
    folder = run(case, built(mean_colour()), store).folder
    record = json.loads((folder / "run.json").read_text())
    (folder / "run.json").write_text(json.dumps(record | {"schema_version": 99}))
    with pytest.raises(DataError, match="schema version 99"):
        run(case, built(mean_colour()), store)
    assert json.loads((folder / "run.json").read_text())["schema_version"] == 99


def test_every_damaged_run_is_kept(case, store, built, mean_colour):
    with pytest.warns(StoreWarning):
        for _ in range(3):
            folder = run(case, built(mean_colour()), store).folder
            (folder / "matches.npz").write_bytes(b"")
        run(case, built(mean_colour()), store)
    assert len(list(folder.parent.glob("*.damaged*"))) == 3


def test_map_that_cannot_be_loaded_is_fitted_again(case, store, built, mean_colour):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(mean_colour(fail_after=8, error=KeyboardInterrupt)), store)
    next(store.root.rglob("database.npy")).write_bytes(b"")
    again = mean_colour()
    with pytest.warns(StoreWarning, match="fitted again"):
        run(case, built(again), store)
    assert again.fits == 1


def test_a_method_that_cannot_be_saved_is_named(case, store, built, mean_colour, monkeypatch):
    def fail(self, folder):
        raise TypeError("no way")

    monkeypatch.setattr(mean_colour, "save", fail)
    with pytest.raises(VprBenchError, match="'mean-colour' failed while saving its map"):
        run(case, built(mean_colour()), store)


def test_a_stage_may_be_called_anything(case, store, built):
    class Stages:
        def fit(self, references):
            pass

        def match(self, image, k):
            with stage("file"), stage("allow_pickle"):
                return Match(range(k), np.zeros(k))

    assert {"file", "allow_pickle", "total"} <= run(case, built(Stages()), store).seconds.keys()


def test_to_answer_nothing_is_an_answer_where_it_is_declared(case, store, built):
    class Silent:
        may_answer_fewer = "nothing is like anything"

        def fit(self, references):
            pass

        def match(self, image, k):
            return Match([], [])

    stored = run(case, built(Silent()), store)
    assert (stored.indices == -1).all()
    assert np.isneginf(stored.scores).all()


def test_libraries_loaded_while_fitting_are_held_to_the_threads_too(case, store, built, monkeypatch):
    import sys

    import torch

    before = torch.get_num_threads()
    torch.set_num_threads(2)
    seen = []

    class Late:
        def fit(self, references):
            monkeypatch.setitem(sys.modules, "torch", torch)

        def match(self, image, k):
            seen.append(torch.get_num_threads())
            return Match(range(k), np.zeros(k))

    monkeypatch.delitem(sys.modules, "torch")
    run(case, built(Late()), store, RunOptions(threads=1))
    torch.set_num_threads(before)
    assert set(seen) == {1}
