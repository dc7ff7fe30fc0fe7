import pytest

BY_ORDER = [[one] for one in range(10)]


@pytest.mark.parametrize(
    ("unmatched", "severity", "fate"),
    [("exclude", "warning", "left out"), ("miss", "note", "as a miss"), ("reject", "note", "low score")],
)
def test_queries_without_a_match(made, unmatched, severity, fate):
    made.protocols = [{"references": "day", "queries": "night", "unit": "given", "unmatched": unmatched}]
    made.write("night", [f"walk{letter}.png" for letter in "abcdefghij"], 100)
    made.given = {"lists": [[], [], [], [], *BY_ORDER[4:9], [0, 1, 2, 3, 9]]}
    finding = made.only()
    assert (finding.check, finding.severity) == ("query-without-match", severity)
    assert "4 of 10 queries" in finding.message and fate in finding.message
    assert finding.message.endswith("night/walka.png, night/walkb.png, night/walkc.png and 1 more")


def test_references_that_are_never_right(made):
    made.options["night"] = {"labels": [0, 0, 0, 1, 1, 1, 2, 2, 2, 3]}
    made.write("night", [f"walk{letter}.png" for letter in "abcdefghij"], 100)
    finding = made.only()
    assert (finding.check, finding.severity) == ("reference-never-matched", "note")
    assert finding.message.endswith("5 of 10 references: day/05.png, day/06.png, day/07.png and 2 more")


def test_a_ground_truth_that_holds_one_way_only(made):
    made.protocols = [{"references": "day", "queries": "night", "unit": "given"}]
    made.given = {"lists": [[0, 1], *BY_ORDER[1:]]}
    finding = made.only()
    assert (finding.check, finding.severity, finding.where) == ("asymmetric", "warning", "day-night@given")
    assert "1 of 11 pairs: query night/00.png has reference day/01.png, but night/01.png has not day/00.png" in (
        finding.message
    )


def test_a_symmetric_one(made):
    made.protocols = [{"references": "day", "queries": "night", "unit": "given"}]
    made.given = {"lists": [[0, 1], [0, 1], *BY_ORDER[2:]]}
    assert made.lint() == []


@pytest.mark.parametrize("names", [[f"{index + 5:02d}.png" for index in range(10)], [f"{i:02d}.png" for i in range(9)]])
def test_one_way_is_fine_where_images_do_not_correspond(made, names):
    made.protocols = [{"references": "day", "queries": "night", "unit": "given"}]
    made.write("night", names, 100)
    made.options = {"day": {"labels": []}, "night": {"labels": []}}
    made.given = {"lists": [[0, 1], *BY_ORDER[1:8], [8, 9], [9]][: len(names)]}
    assert made.lint() == []
