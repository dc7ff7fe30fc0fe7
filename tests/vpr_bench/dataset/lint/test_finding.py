import json

from vpr_bench.dataset.lint import Finding


def test_a_finding_is_json():
    finding = Finding("dark", "warning", "day", "black")
    assert Finding(**json.loads(json.dumps(finding.as_dict()))) == finding


def test_foreign_names_cannot_move_the_cursor():
    finding = Finding("dark", "warning", "day\x1b[2J/\udcff", "black:\n a\x07.png")
    assert (finding.where, finding.message) == ("day[2J/", "black: a.png")
