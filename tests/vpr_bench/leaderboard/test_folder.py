import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_bench.leaderboard.entry import METRICS
from vpr_bench.leaderboard.folder import MADE_BY_US, stale_tables, table_name, tables, write_tables
from vpr_bench.leaderboard.overview import overview_grids
from vpr_bench.leaderboard.standing import boards
from vpr_bench.metrics.bootstrap import Interval
from vpr_bench.types.protocol import Protocol

REAL, SIMULATED = "gardens/day_left-night_right@2f", "gardens:simulated/day_left-night_right@2f"
TABLE = "gardens/day_left-night_right@2f.md"


def made(*entries):
    return tables(boards(entries))


def cells(text):
    """Return the table of a page, row by row."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in (lines[0], *lines[2:])]


def test_a_table_per_protocol_and_an_overview_that_links_to_them(make_entry):
    files = made(make_entry(protocol=REAL), make_entry(protocol=SIMULATED))
    assert set(files) == {"README.md", TABLE, "gardens.simulated/day_left-night_right@2f.md"}
    assert "(gardens/day_left-night_right%402f.md)" in files["README.md"]
    assert all(text.startswith(MADE_BY_US) for text in files.values())


def test_the_same_rows_give_the_same_bytes(make_entry):
    entries = [make_entry("a", 3), make_entry("b", 7), make_entry("a", protocol=SIMULATED)]
    assert made(*entries) == made(*entries[::-1])


def test_what_is_simulated_says_so_in_every_title(make_entry):
    files = made(make_entry(protocol=REAL), make_entry(protocol=SIMULATED))
    title = files["gardens.simulated/day_left-night_right@2f.md"].splitlines()[2]
    assert title == f"# Simulated images: `{SIMULATED}`"
    overview = files["README.md"]
    real, simulated = overview.split("## Simulated images")
    assert SIMULATED in simulated
    assert SIMULATED not in real
    assert "simulated" not in made(make_entry(protocol=REAL))[TABLE].lower()


def test_a_row_of_the_table(make_entry):
    files = made(make_entry("hog", 5, protocol=REAL, total=12.34))
    head, row, *published = cells(files[TABLE])
    assert head[:3] == ["rank", "method", "recall@1"]
    assert row == [
        "1",
        "hog",
        "0.500 (.000–1.00)",
        "0.500 (.250–.750)",
        "0.500 (.000–1.00)",
        "0.500 (.250–.750)",
        "12.3",
        "24.7",
        "A",
    ]
    assert len(published) == 4
    assert all(one[0] == "" and one[1].startswith("*") for one in published)
    assert "thesis, ch. 4.6.2, radius not stated" in files[TABLE]


def test_marks_are_explained_where_they_occur_and_only_there(make_entry):
    plain = made(make_entry())["streets/day-night@0f.md"]
    assert not {"†", "‡", "`=`"} & set(plain.split())
    marked = made(
        make_entry("best", 9),
        make_entry("close", 8, sequential=True, elsewhere=0.5),
        make_entry("ahead", 1, sequential=True, future=5),
    )["streets/day-night@0f.md"]
    _, best, close, ahead = cells(marked)
    assert [best[0], close[0], ahead[0]] == ["1", "2 =", "3"]
    assert [close[1], ahead[1]] == ["close †", "ahead †+5"]
    assert close[6:] == ["", "", "A ‡"]
    for mark in ("`=`", "`†`", "`†+N`", "`‡`"):
        assert mark in marked


def test_partial_rows_are_blank_and_last(make_entry):
    entries = [make_entry("a", [True] * 4, partial=True, n_available=10), make_entry("b", 1)]
    files = made(*entries)
    _, whole, partial = cells(files["streets/day-night@0f.md"])
    assert whole[1] == "b"
    assert partial == ["", "a (partial: 4 of 10 queries)", *[""] * 6, "A"]
    _, first, second = cells(files["README.md"])
    assert first == ["a", ""]
    assert second == ["b", "**0.100**"]


def test_what_is_undefined_is_a_dash(make_entry):
    metrics = dict.fromkeys(METRICS, Interval(math.nan, math.nan, math.nan))
    files = made(make_entry(right=[], metrics=metrics))
    assert cells(files["streets/day-night@0f.md"])[1][:3] == ["", "hog", "–"]


def test_machines_have_letters_with_a_legend(make_entry):
    other = make_entry("b", machine="ffffffff", machine_about="Another", created="2027-01-01T00:00:00Z")
    files = made(make_entry("a"), other)
    page = files["streets/day-night@0f.md"]
    assert {row[1]: row[8] for row in cells(page)[1:]} == {"a": "A", "b": "B"}
    assert "Machine B: Another." in page
    assert "- B: Another (`ffffffff`)" in files["README.md"]


def test_overview_marks_the_best_and_what_is_tied_and_holds_no_average(make_entry):
    entries = [make_entry("a", 9), make_entry("b", 8), make_entry("c", 0), make_entry("c", 1, protocol=SIMULATED)]
    overview = made(*entries)["README.md"]
    assert cells(overview.split("## Simulated")[0])[1:] == [["a", "**0.900**"], ["b", "**0.800**"], ["c", "0.000"]]
    real, simulated = overview_grids(boards(entries))
    assert [list(row) for row in real.rows] == [["a", "0.900 ="], ["b", "0.800 ="], ["c", "0.000"]]
    assert simulated.title.startswith("Simulated images")


def test_overview_marks_what_sees_more_than_one_image(make_entry):
    entries = [make_entry("a"), make_entry("b", sequential=True)]
    overview = made(*entries)["README.md"]
    assert [row[0] for row in cells(overview)[1:]] == ["a", "b †"]
    assert "`†` uses the queries before" in overview
    (grid,) = overview_grids(boards(entries))
    assert "† uses the queries before" in grid.note


def test_the_overview_of_a_terminal_fits_its_window(make_entry):
    protocols = [f"a-dataset-with-a-name:simulated/some_{n}-other_{n}@25m~reject" for n in range(9)]
    grids = overview_grids(boards([make_entry(protocol=protocol) for protocol in protocols]))
    heads = [head for grid in grids for head in grid.head[1:]]
    assert [head.replace("\n", "") for head in heads] == [protocol.replace("/", "") for protocol in protocols]
    assert [grid.title for grid in grids] == [f"Simulated images: recall@1 ({n} of 5)" for n in range(1, 6)]
    for grid in grids:
        assert sum(max(map(len, head.splitlines())) + 2 for head in grid.head[1:]) <= 56


def test_a_method_on_two_machines_has_one_line_in_the_overview(make_entry):
    newer = make_entry("a", 3, machine="ffffffff", created="2027-01-01T00:00:00Z")
    assert cells(made(make_entry("a", 9), newer)["README.md"])[1:] == [["a", "**0.300**"]]


@pytest.mark.parametrize(
    "name",
    ["a|b", "<script>alert(1)</script>", "[x](http://evil)", "`code`", "two\nlines", "\u202egnp", "&amp;", "**", "\\|"],
)
def test_hostile_names_are_text_in_one_cell(make_entry, name):
    files = made(make_entry(name, machine_about=name))
    for text in files.values():
        assert "<script" not in text
        assert not re.search(r"(?<!\\)\]\(http", text)
        assert "\u202e" not in text
    assert [len(row) for row in cells(files["streets/day-night@0f.md"])] == [9, 9]
    assert [len(row) for row in cells(files["README.md"])] == [2, 2]


def test_a_very_long_label_loses_its_middle_in_every_table(make_entry):
    label = f"hog({'x' * 3000})"
    entries = [make_entry(label), make_entry(label, right=3, protocol=SIMULATED)]
    for text in made(*entries).values():
        assert "hog(x" in text and "x)" in text
        assert "x" * 80 not in text
    names = [row[0] for grid in overview_grids(boards(entries)) for row in grid.rows]
    assert {len(name) for name in names} == {80}


@given(st.from_regex(r"[a-z0-9][a-z0-9._]{0,200}", fullmatch=True))
def test_names_of_files_are_short_and_apart(name):
    protocols = [Protocol("a", name, "q", 1, "f", edition) for edition in ("real", "b")]
    protocols.append(Protocol("a", name + "z", "q", 1, "f"))
    names = [table_name(protocol) for protocol in protocols]
    assert len(set(names)) == 3
    assert max(len(part) for one in names for part in one.split("/")) < 200


def test_writes_what_differs_and_removes_what_has_no_rows(make_entry, tmp_path):
    both, one = made(make_entry(), make_entry(protocol=SIMULATED)), made(make_entry())
    write_tables(tmp_path, both)
    assert stale_tables(tmp_path, both) == []
    stale = {path.relative_to(tmp_path).as_posix() for path in stale_tables(tmp_path, one)}
    assert stale == {"README.md", "gardens.simulated/day_left-night_right@2f.md"}
    write_tables(tmp_path, one)
    assert {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.md")} == set(one)
    assert not (tmp_path / "gardens.simulated").exists()


def test_the_overview_of_a_leaderboard_in_a_folder_below_is_no_leftover(make_entry, tmp_path):
    write_tables(tmp_path / "boards", made(make_entry()))
    before = {path: path.read_bytes() for path in (tmp_path / "boards").rglob("*.md")}
    files = made(make_entry())
    write_tables(tmp_path, files)
    assert {path: path.read_bytes() for path in (tmp_path / "boards").rglob("*.md")} == before
    assert stale_tables(tmp_path, files) == []


def test_a_table_with_a_long_name_is_removed_as_well(make_entry, tmp_path):
    write_tables(tmp_path, made(make_entry(protocol=f"a/{'b' * 200}-c@1f")))
    write_tables(tmp_path, made(make_entry()))
    assert not (tmp_path / "a").exists()


def test_files_of_others_are_neither_removed_nor_written_over(make_entry, tmp_path):
    (tmp_path / "notes").mkdir()
    note = tmp_path / "notes" / "mine.md"
    note.write_text("mine")
    write_tables(tmp_path, made(make_entry()))
    assert note.read_text() == "mine"
    (tmp_path / "README.md").write_text("mine")
    before = {path: path.read_bytes() for path in tmp_path.rglob("*.md")}
    with pytest.raises(DataError, match=r"README.md was not made by `vpr-bench leaderboard`"):
        write_tables(tmp_path, made(make_entry(right=9)))
    assert {path: path.read_bytes() for path in tmp_path.rglob("*.md")} == before


def test_line_ends_of_version_control_do_not_matter(make_entry, tmp_path):
    files = made(make_entry())
    write_tables(tmp_path, files)
    readme = tmp_path / "README.md"
    readme.write_bytes(readme.read_bytes().replace(b"\n", b"\r\n"))
    assert stale_tables(tmp_path, files) == []
