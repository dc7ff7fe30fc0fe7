from dataclasses import replace

from vpr_bench.gate.markdown import to_markdown


def test_the_verdict_stands_first_and_flips_are_folded_away(failing):
    told = to_markdown(failing)
    assert told.startswith("**Accuracy gate failed**: 1 passed, 1 failed, 1 missing, 1 new")
    assert "| fails | fail | pr_auc |" in told
    assert "|  |  | recall@1 |" in told
    assert "<details open><summary>fails: fail</summary>" in told
    assert told.count("<details") == told.count("</details>") == 2


def test_every_row_of_a_table_is_as_long_as_its_head(failing, hostile):
    told = to_markdown(replace(failing, verdicts=[replace(one, label=hostile) for one in failing.verdicts]))
    rows = [line for line in told.splitlines() if line.startswith("|")]
    assert len({line.count("|") for line in rows}) == 1
    assert "<script" not in told
