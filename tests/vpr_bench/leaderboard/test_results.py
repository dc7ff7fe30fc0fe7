import csv
import dataclasses
import io
import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vpr_bench.errors import DataError
from vpr_bench.leaderboard.columns import HEADER, digest_of, pack, unpack
from vpr_bench.leaderboard.entry import METRICS, STAGES
from vpr_bench.leaderboard.results import is_written, read_results, to_csv, to_json, write_results
from vpr_bench.metrics.bootstrap import Interval

HOSTILE = [
    "a|b",
    "two\nlines",
    'say "hello", twice',
    "<script>alert(1)</script>",
    "\u202egnp.exe",
    "=HYPERLINK(0)",
    "+1",
    "-1",
    "@SUM",
    "'=1",
    "\t=1",
    " =1",
    "\r\n=1",
    "\r",
    "x\ry",
    "\uff1d1",
    "<<<<<<< HEAD",
    "x\n<<<<<<< HEAD\n=======",
    "",
    "\x00",
    "\u2028",
]
RISKY = "=+-@\t\r\n \uff1d\uff0b\uff0d\uff20"
foreign = st.text(max_size=20) | st.sampled_from(HOSTILE)
shares = st.floats(0, 1) | st.just(math.nan)
numbers = st.floats(0, 1e300, allow_nan=False)


@st.composite
def intervals(draw):
    low, high = sorted((draw(st.floats(0, 1)), draw(st.floats(0, 1))))
    return Interval(draw(shares), *draw(st.sampled_from([(low, high), (math.nan, math.nan)])))


def same(first, second):
    return np.array_equal(first.right, second.right) and all(
        repr(getattr(first, field.name)) == repr(getattr(second, field.name))
        for field in dataclasses.fields(first)
        if field.name != "right"
    )


@given(st.data())
def test_rows_are_read_back_exactly(make_entry, tmp_path_factory, data):
    right = data.draw(st.lists(st.booleans(), max_size=40))
    recall = float(np.mean(right)) if right else math.nan
    metrics = {name: data.draw(intervals()) for name in METRICS}
    metrics["recall@1"] = dataclasses.replace(metrics["recall@1"], value=recall)
    entry = make_entry(
        method=data.draw(foreign),
        right=right,
        n_available=len(right) + data.draw(st.integers(0, 9)),
        metrics=metrics,
        latency={f"latency_{stage}_p50": data.draw(numbers) for stage in data.draw(st.sets(st.sampled_from(STAGES)))},
        elsewhere=data.draw(st.none() | st.floats(0, 1)),
        fit_seconds=data.draw(numbers),
        machine_about=data.draw(foreign),
        weights=data.draw(st.none() | foreign),
        version=data.draw(foreign),
        seed=data.draw(st.integers(0, 2**70)),
        commit=data.draw(st.none() | foreign),
        changed=data.draw(st.none() | st.booleans()),
    )
    entry = dataclasses.replace(
        entry,
        latency={f"latency_{s}_p50": v for s in STAGES if (v := entry.latency.get(f"latency_{s}_p50")) is not None},
    )
    path = tmp_path_factory.mktemp("csv") / "results.csv"
    write_results(path, [entry])
    (read,) = read_results(path)
    assert same(read, entry)
    assert is_written(path, [read])


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_are_read_back_exactly(make_entry, tmp_path, name):
    path = tmp_path / "results.csv"
    write_results(path, [make_entry(name, version=name), make_entry("hog")])
    assert sorted(entry.method for entry in read_results(path)) == sorted([name, "hog"])
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            assert row["method"][0] not in RISKY


@given(st.lists(st.booleans()))
def test_truth_values_are_packed_and_unpacked(flags):
    text = pack(np.array(flags, bool))
    assert unpack(text, len(flags)).tolist() == flags
    assert "=" not in text


@pytest.mark.parametrize(("text", "count"), [("", 1), ("gA", 9), ("g", 1), ("gA", 0), ("gB", 1), ("é", 1), ("g A", 8)])
def test_other_text_holds_no_truth_values(text, count):
    with pytest.raises(ValueError, match="truth values"):
        unpack(text, count)


def test_rows_stand_in_one_order_whatever_order_they_came_in(make_entry):
    entries = [
        make_entry("b"),
        make_entry("a"),
        make_entry("a", machine="00000000"),
        make_entry("c", protocol="a/b-c@1f"),
    ]
    assert to_csv(entries) == to_csv(entries[::-1])
    assert [row["method"] for row in csv.DictReader(io.StringIO(to_csv(entries)))] == ["c", "a", "a", "b"]


def test_as_json_undefined_is_null(make_entry):
    entry = make_entry(metrics=dict.fromkeys(METRICS, Interval(math.nan, math.nan, math.nan)), right=[], weights=None)
    (row,) = json.loads(to_json([entry]))
    assert row["recall@1"] is None
    assert row["weights"] is None
    assert row["latency_encode_p50"] is None
    assert row["protocol"] == str(entry.protocol)


@pytest.fixture
def file(make_entry, tmp_path):
    path = tmp_path / "results.csv"
    write_results(path, [make_entry("hog"), make_entry("sift", 7)])
    return path


def refused(path, *said):
    before = path.read_bytes()
    with pytest.raises(DataError) as error:
        read_results(path)
    for words in (str(path), *said):
        assert words in str(error.value)
    assert path.read_bytes() == before


@pytest.mark.parametrize("column", HEADER[1:])
def test_an_edited_cell_is_found(file, column):
    rows = list(csv.reader(io.StringIO(file.read_text("utf-8"))))
    place = HEADER.index(column)
    cell = rows[1][place]
    rows[1][place] = {"true": "false", "false": "true"}.get(cell, cell[:-1] + ("2" if cell.endswith("1") else "1"))
    write_cells(file, rows)
    refused(file, "line 2")


def write_cells(file, rows):
    written = io.StringIO()
    csv.writer(written, lineterminator="\n").writerows(rows)
    file.write_text(written.getvalue(), "utf-8")


def rewritten(file, column, text):
    """Change a cell and put the digest right: the content itself must be refused."""
    rows = list(csv.reader(io.StringIO(file.read_text("utf-8"))))
    rows[2][HEADER.index(column)] = text
    rows[2][-1] = digest_of(rows[2][:-1])
    write_cells(file, rows)


@pytest.mark.parametrize(
    ("column", "text", "said"),
    [
        ("schema", "2", "schema '2'; this vpr-bench reads 1"),
        ("schema", "", "schema ''"),
        ("protocol", "gardens", "is not a protocol id"),
        ("protocol", "gardens/a-b@2.0f", "would be written 'gardens/a-b@2f'"),
        ("partial", "True", "neither true nor false"),
        ("n_queries", "010", "not a whole number"),
        ("n_queries", "-1", "not a whole number"),
        ("n_queries", "٣", "not a whole number"),
        ("n_queries", "11", "n_available"),
        ("recall@1", "0.8", "recall@1 is 0.8, and right gives 0.7"),
        ("recall@1", "nan", "not a number"),
        ("recall@1", "", "right gives 0.7"),
        ("recall@5", "1.5", "between 0 and 1"),
        ("recall@5", "inf", "not a number"),
        ("recall@5", "0.50", "would be written '0.5'"),
        ("recall@5", "half", "recall@5 is 'half'"),
        ("recall@5_low", "0.9", "no interval"),
        ("recall@5_low", "", "no interval"),
        ("latency_total_p50", "-1.0", "not a number of at least 0"),
        ("elsewhere", "2.0", "between 0 and 1"),
        ("fit_seconds", "", "fit_seconds is ''"),
        ("machine", "xyz", "8 hexadecimal digits"),
        ("run", "0123456789AB", "12 hexadecimal digits"),
        ("created", "yesterday", "created is 'yesterday'"),
        ("right", "AAAA", "truth values"),
        ("method", "=1", 'would be written "\'=1"'),
        ("method", "hog", "stands in line 2 already"),
    ],
)
def test_nonsense_is_refused_with_its_line(file, column, text, said):
    rewritten(file, column, text)
    refused(file, "line 3", said)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda text: "", "line 1: the first column is ''"),
        (lambda text: "method,protocol\nhog,x\n", "this is no file of a leaderboard"),
        (lambda text: "\ufeff" + text, "this is no file of a leaderboard"),
        (lambda text: text.replace("n_queries", "n_query", 1), "unknown column 'n_query'. Did you mean 'n_queries'?"),
        (lambda text: text.replace(",package,", ",", 1), "no column 'package'"),
        (lambda text: text.replace("recall@1,", "recall@5,", 1), "no column 'recall@1'"),
        (lambda text: text.replace("seed,k,", "k,seed,", 1), "another order"),
        (lambda text: text.rstrip("\n") + ",more\n", "line 3: 69 cells instead of 68"),
        (lambda text: text[:-30], "line 3"),
        (lambda text: text + "\n", "line 4: schema ''"),
        (lambda text: text + text.splitlines()[1] + "\n", "line 4: hog on streets"),
        (lambda text: "<<<<<<< ours\n" + text, "line 1: '<<<<<<< ours' is the mark of a merge conflict"),
        (lambda text: text + "=======\n", "line 4: '=======' is the mark of a merge conflict"),
        (lambda text: text + '1,"hog\n', "line 4: not CSV"),
    ],
)
def test_a_file_that_was_not_written_so_is_refused(file, change, said):
    file.write_text(change(file.read_text("utf-8")), "utf-8")
    refused(file, said)


def test_other_encodings_are_refused_with_their_line(file):
    file.write_bytes(file.read_bytes() + b"1,h\xe9g\n")
    refused(file, "line 4: not UTF-8")


def test_a_missing_file_says_how_it_is_made(tmp_path):
    with pytest.raises(DataError, match="`vpr-bench leaderboard` makes it"):
        read_results(tmp_path / "results.csv")


def test_line_ends_of_version_control_do_not_matter(file):
    file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    entries = read_results(file)
    assert [entry.method for entry in entries] == ["hog", "sift"]
    assert is_written(file, entries)
