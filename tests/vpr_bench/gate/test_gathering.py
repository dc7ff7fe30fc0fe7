import warnings
from dataclasses import replace

from vpr_bench.gate import Baseline, judge, record_cell
from vpr_bench.gate.gathering import gather, with_names
from vpr_bench.gate.rerun import Sources


def test_damaged_runs_are_errors_and_hide_no_other(store, tmp_path):
    good, bad = store(), store(label="bad")
    (bad.folder / "matches.npz").unlink()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        runs, errors = gather(tmp_path / "runs")
    assert [run.folder for run in runs] == [good.folder]
    assert [one.folder for one in errors] == [bad.folder]
    assert str(bad.folder) in str(errors[0].fault)


def test_a_run_of_another_schema_is_an_error(store, tmp_path):
    record = store().folder / "run.json"
    record.write_text(record.read_text().replace('"schema_version":2', '"schema_version":99'))
    assert "schema version 99" in str(gather(tmp_path / "runs")[1][0].fault)


def test_an_empty_folder_holds_nothing(tmp_path):
    assert gather(tmp_path / "nowhere") == ([], [])


def test_queries_have_no_names_where_the_images_are_not_here(store, made_up_answers, shift, data_folder):
    indices, scores = made_up_answers()
    old = store()
    new = store(shift(indices, [0, 1]), scores, version="2", protocol="nosuch/a-b@0f")
    cell = record_cell(old).model_copy(update={"protocol": "nosuch/a-b@0f"}).sealed()
    judgement = judge(Baseline().with_cells([cell]), [new])
    said = []
    doubled = replace(judgement, verdicts=[*judgement.verdicts, *judgement.verdicts])
    named = with_names(doubled, [new], Sources(), said.append)
    assert named.verdicts[0].name_of(1) == "query 1"
    assert len(said) == 1
    assert "cannot be shown" in said[0]
