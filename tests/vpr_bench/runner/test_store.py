import json

import numpy as np
import pytest

from vpr_bench.errors import DataError
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.store import RunStore, StoredRun, StoreWarning
from vpr_bench.types.ground_truth import GroundTruth


def test_folder_says_what_it_is(case, store, built, mean_colour):
    stored = run(case, built(mean_colour()), store)
    assert stored.folder.relative_to(store.root).parts[:-1] == ("tiny", "summer-winter", "mean-colour")
    assert stored.folder.name == stored.record.key.digest()


def test_no_colon_in_paths(case, store, built, mean_colour):
    from dataclasses import replace

    simulated = replace(case, protocol=replace(case.protocol, edition="simulated"))
    stored = run(simulated, built(mean_colour()), store)
    assert ":" not in str(stored.folder.relative_to(store.root))
    assert str(stored.protocol) == "tiny:simulated/summer-winter@1f"


def test_runs_lists_whole_runs_and_warns_of_damaged_ones(case, store, built, mean_colour):
    good = run(case, built(mean_colour()), store)
    bad = run(case, built(mean_colour()), store, RunOptions(seed=1))
    (bad.folder / "matches.npz").write_bytes(b"x")
    with pytest.raises(KeyboardInterrupt):
        run(
            case,
            built(mean_colour(fail_after=5, error=KeyboardInterrupt)),
            store,
            RunOptions(seed=2),
        )
    with pytest.warns(StoreWarning, match="damaged"):
        assert [found.folder for found in store.runs()] == [good.folder]


def test_empty_store(tmp_path):
    assert RunStore(tmp_path / "none").runs() == []


def test_ground_truth_at_any_radius(case, store, built, mean_colour):
    stored = run(case, built(mean_colour()), store)
    truths = [stored.places.ground_truth(stored.protocol.with_radius(radius)) for radius in (0, 2)]
    assert [truth[3].tolist() for truth in truths] == [[3], [1, 2, 3, 4, 5]]


def test_what_the_dataset_lists_is_stored_with_the_run(case, store, built, mean_colour):
    from dataclasses import replace

    soft = GroundTruth.from_lists([[1], *[[]] * 11], 12)
    given = GroundTruth.from_lists([[0, 4], *[[place] for place in range(1, 12)]], 12).with_soft(soft)
    listed = replace(
        case, places=replace(case.places, given=given), protocol=replace(case.protocol, unit="given", radius=0)
    )
    stored = StoredRun.open(run(listed, built(mean_colour()), store, RunOptions(limit=5)).folder)
    assert stored.places.ground_truth(stored.protocol) == given.take(stored.queries)
    assert stored.places.given.soft is not None


def test_killed_between_the_two_renames(case, store, built, mean_colour):
    folder = run(case, built(mean_colour()), store).folder
    former = folder.with_name(folder.name + ".former")
    folder.rename(former)  # as left by a process that was killed before the new run was in place
    again = mean_colour()
    run(case, built(again), store)
    assert again.fits == 0
    assert not former.exists()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"schema_version": 99}, "schema version 99"),
        ({"surprise": 1}, "surprise"),
        ({"n_queries": "many"}, "n_queries"),
    ],
)
def test_foreign_record_is_refused(case, store, built, mean_colour, change, said):
    folder = run(case, built(mean_colour()), store).folder
    record = json.loads((folder / "run.json").read_text())
    (folder / "run.json").write_text(json.dumps(record | change))
    with pytest.raises(DataError, match=said):
        StoredRun.open(folder)


def test_object_arrays_are_not_unpickled(case, store, built, mean_colour):
    from vpr_bench.files.digest import sha256_of_file

    stored = run(case, built(mean_colour()), store)
    np.savez(stored.folder / "labels.npz", queries=np.array([print], dtype=object), references=np.zeros(1))
    record = json.loads((stored.folder / "run.json").read_text())
    record["files"]["labels.npz"] = sha256_of_file(stored.folder / "labels.npz")
    (stored.folder / "run.json").write_text(json.dumps(record))
    with pytest.raises(DataError, match="damaged"):
        StoredRun.open(stored.folder).places.take([0])


@pytest.mark.parametrize("name", ["/etc/evil", "../../up", "hloc/netvlad", "a:b", ".."])
def test_a_method_may_be_called_anything(case, store, built, mean_colour, name):
    from dataclasses import replace

    stored = run(case, replace(built(mean_colour()), id=name), store)
    assert stored.folder.resolve().is_relative_to(store.root.resolve())
    assert [found.folder for found in store.runs()] == [stored.folder]
