"""Runs that former versions wrote, kept as they were written, are still what they were."""

import copy
import json
import shutil
from pathlib import Path

import pytest

from vpr_bench.errors import DamagedError, DataError
from vpr_bench.files.migrations import migrated
from vpr_bench.metrics.definitions import METRICS
from vpr_bench.report.rows import score_run
from vpr_bench.runner.agreement import agreement
from vpr_bench.runner.migrations import SCHEMA_VERSION, STEPS
from vpr_bench.runner.provenance import Provenance
from vpr_bench.runner.record import RunRecord
from vpr_bench.runner.select import select_run
from vpr_bench.runner.store import RunStore, StoredRun

STORED = Path(__file__).parent / "stored"
VERSIONS = range(1, SCHEMA_VERSION + 1)
FOLDERS = sorted(file.parent for file in STORED.rglob("run.json"))


def named(folder):
    return str(folder.relative_to(STORED).as_posix())


def content_of(folder):
    return json.loads((folder / "run.json").read_text())


@pytest.fixture
def old(tmp_path):
    """Return a copy of a run of schema 1 that may be spoilt."""
    return Path(shutil.copytree(select_run("83288172c0ed", STORED / "v1").folder, tmp_path / "old"))


def spoil(folder, change):
    content = content_of(folder)
    change(content)
    (folder / "run.json").write_text(json.dumps(content))


@pytest.mark.parametrize("version", VERSIONS)
def test_every_schema_version_is_kept(version):
    runs = RunStore(STORED / f"v{version}").runs()
    assert len(runs) >= 2
    assert any(run.survivors for run in runs)
    assert {content_of(run.folder)["schema_version"] for run in runs} == {version}


@pytest.mark.parametrize("folder", FOLDERS, ids=named)
def test_opens_and_scores(folder):
    run = StoredRun.open(folder)
    assert run.record.key.digest() == folder.name
    assert RunRecord.model_validate_json(run.record.model_dump_json()) == run.record
    row = score_run(run, list(METRICS))
    assert 0 <= row.metrics["recall@1"] <= 1 and row.latency["latency_total_p50"] > 0
    assert len(row.steps) == 2 * bool(run.survivors)


@pytest.mark.parametrize("folder", FOLDERS, ids=named)
def test_nothing_on_disk_is_changed(folder):
    before = (folder / "run.json").read_bytes()
    StoredRun.open(folder)
    assert (folder / "run.json").read_bytes() == before


@pytest.mark.parametrize("folder", FOLDERS, ids=named)
def test_what_is_given_is_not_changed(folder):
    content = content_of(folder)
    before = copy.deepcopy(content)
    assert migrated(content, STEPS, SCHEMA_VERSION)["schema_version"] == SCHEMA_VERSION
    assert content == before


def test_the_same_command_gave_the_same_answers_in_every_version():
    first, *others = (select_run("83288172c0ed", STORED / f"v{version}") for version in VERSIONS)
    assert others
    assert all(agreement(first, other).identical for other in others)


def test_what_version_1_did_not_note_is_unknown(old):
    record = StoredRun.open(old).record
    assert record.provenance == Provenance()
    assert (record.machine.memory_bytes, record.machine.blas) == (None, None)


def test_a_newer_schema_is_refused(old):
    spoil(old, lambda content: content.update(schema_version=SCHEMA_VERSION + 1))
    with pytest.raises(DataError, match=f"reads 1 to {SCHEMA_VERSION}. Update vpr-bench"):
        StoredRun.open(old)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda content: content.pop("label"), "label: Field required"),
        (lambda content: content["key"].pop("method"), "key.method: Field required"),
        (lambda content: content.update(machine=None), "machine"),
        (lambda content: content.update(schema_version=0), "schema version 0"),
        (lambda content: content.update(future="soon"), "future"),
    ],
)
def test_a_spoilt_old_run_is_refused(old, change, said):
    spoil(old, change)
    with pytest.raises(DataError, match=said):
        StoredRun.open(old)


def test_a_missing_field_is_damage(old):
    spoil(old, lambda content: content.pop("label"))
    with pytest.raises(DamagedError):
        StoredRun.open(old)


@pytest.mark.parametrize("version", ["2", True, None, 2.0])
def test_a_schema_version_is_a_whole_number(old, version):
    spoil(old, lambda content: content.update(schema_version=version))
    with pytest.raises(DamagedError, match="states no schema version"):
        StoredRun.open(old)


def test_a_record_nested_too_deeply_is_damaged(old):
    (old / "run.json").write_text('{"schema_version": 2, "key": ' + "[" * 200_000)
    with pytest.raises(DamagedError, match="is damaged"):
        StoredRun.open(old)


def test_a_key_that_is_not_the_one_of_its_folder_was_edited(old):
    spoil(old, lambda content: content["key"].update(seed=7))
    assert StoredRun.open(old).record.key.seed == 7  # a folder of any other name says nothing
    with pytest.raises(DamagedError, match="was edited: the hash of its key is"):
        StoredRun.open(old.rename(old.with_name("83288172c0ed")))
