import csv
import io
import json
import shutil
from contextlib import contextmanager
from pathlib import Path

import pytest

from vpr_bench.leaderboard import renewal
from vpr_bench.runner.record import read_record

LOCK = renewal.LOCK
SMALL = ("--param", "width=32", "--param", "height=32", "--param", "cell=8")
HOG = ("run", "--method", "hog", *SMALL, "--dataset", "tiny")
BOARD = ("leaderboard", "--no-page")
RESULTS = Path("leaderboards/results.csv")
TABLE = Path("leaderboards/tiny/day_left-day_right@1f.md")


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Where the runs are kept that the first test has made."""
    return tmp_path_factory.mktemp("kept") / "runs"


@pytest.fixture
def runs(vpr_bench, tiny_dataset, kept):
    """Two methods on one protocol, in the folder ``runs``."""
    if not kept.exists():
        assert vpr_bench(*HOG).code == 0
        assert vpr_bench("run", "--method", "random", "--dataset", "tiny").code == 0
        shutil.copytree("runs", kept)
    shutil.rmtree("runs", ignore_errors=True)
    shutil.copytree(kept, "runs")


def everything(folder="leaderboards"):
    return {path: path.read_bytes() for path in Path(folder).rglob("*") if path.is_file() and path.name != LOCK}


def run_folder(method):
    return next(Path("runs").rglob(f"{method}/*/run.json")).parent


def test_makes_the_rows_and_the_tables_and_prints_the_overview(vpr_bench, runs):
    done = vpr_bench(*BOARD)
    assert done.code == 0
    assert set(everything()) == {RESULTS, Path("leaderboards/README.md"), TABLE}
    assert "hog(width=32, height=32, cell=8)" in TABLE.read_text("utf-8")
    assert "Real images: recall@1" in done.out
    assert "new: random on tiny/day_left-day_right@1f" in done.err


def test_a_second_time_changes_nothing(vpr_bench, runs):
    vpr_bench(*BOARD)
    before = {path: path.stat().st_mtime_ns for path in everything()}
    done = vpr_bench(*BOARD)
    assert "0 rows new, 0 replaced, 2 unchanged. Tables: leaderboards" in done.err
    assert "new:" not in done.err
    assert {path: path.stat().st_mtime_ns for path in everything()} == before


def test_every_format(vpr_bench, runs):
    done = vpr_bench(*BOARD, "--format", "json")
    assert [row["partial"] for row in json.loads(done.out)] == [False, False]
    done = vpr_bench(*BOARD, "--format", "csv")
    assert done.out == RESULTS.read_text("utf-8")
    assert len(list(csv.DictReader(io.StringIO(done.out)))) == 2
    done = vpr_bench(*BOARD, "--format", "markdown")
    assert done.out == Path("leaderboards/README.md").read_text("utf-8")


def test_named_runs_only(vpr_bench, runs):
    done = vpr_bench(*BOARD, run_folder("hog").name[:8], "--format", "json")
    assert [row["run"] for row in json.loads(done.out)] == [run_folder("hog").name]


def test_a_named_run_that_is_older_than_its_row_is_passed_over_with_a_word(vpr_bench, runs):
    older = run_folder("random")
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny", "--seed", "1").code == 0
    record = older / "run.json"
    text = record.read_text("utf-8")
    record.write_text(text.replace(json.loads(text)["created"], "2001-01-01T00:00:00+00:00"), "utf-8")
    done = vpr_bench(*BOARD, "--format", "json")
    assert [row["seed"] for row in json.loads(done.out) if row["method"] == "random"] == [1]
    assert f"passed over: {older}" in vpr_bench(*BOARD, str(older)).err


def test_rows_stay_when_their_runs_are_gone(vpr_bench, runs):
    vpr_bench(*BOARD)
    shutil.rmtree(run_folder("random"))
    assert "2 unchanged" in vpr_bench(*BOARD).err
    shutil.rmtree("runs")
    before = everything()
    shutil.rmtree("leaderboards/tiny")
    assert vpr_bench(*BOARD).code == 0
    assert everything() == before


def test_simulated_images_have_a_section_of_their_own(vpr_bench, runs):
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny:simulated").code == 0
    done = vpr_bench(*BOARD)
    assert "Simulated images: recall@1" in done.out
    assert Path("leaderboards/tiny.simulated/day_left-day_right@1f.md").is_file()


def test_a_partial_run_is_listed_without_numbers(vpr_bench, tiny_dataset):
    assert vpr_bench("run", "--method", "random", "--dataset", "tiny", "--limit", "5").code == 0
    assert vpr_bench(*BOARD).code == 0
    assert "|  | random (partial: 5 of 12 queries) |  |" in TABLE.read_text("utf-8")


def test_check_passes_and_writes_nothing(vpr_bench, runs):
    vpr_bench(*BOARD)
    before = {path: path.stat().st_mtime_ns for path in everything()}
    done = vpr_bench("leaderboard", "--check")
    assert done.code == 0
    assert "up to date" in done.err
    assert {path: path.stat().st_mtime_ns for path in everything()} == before


def test_check_finds_what_is_stale_and_names_the_command(vpr_bench, runs):
    assert vpr_bench("leaderboard", "--check").code == 1
    assert not Path("leaderboards").exists()
    vpr_bench(*BOARD)
    with TABLE.open("a") as table:
        table.write("edited")
    before = everything()
    done = vpr_bench("leaderboard", "--check")
    assert done.code == 1
    assert f"not up to date: {TABLE}" in done.err
    assert "vpr-bench leaderboard --output leaderboards" in done.err
    hog = run_folder("hog").name
    done = vpr_bench("leaderboard", hog, "--runs", "runs", "--check")
    assert f"vpr-bench leaderboard {hog} --runs runs --output leaderboards" in done.err
    assert everything() == before


def test_check_says_what_stands_in_the_way_of_the_tables(vpr_bench, runs):
    vpr_bench(*BOARD)
    Path("leaderboards/README.md").write_text("mine")
    done = vpr_bench("leaderboard", "--check")
    assert done.code == 3
    assert "leaderboards/README.md was not made by `vpr-bench leaderboard`" in done.err
    assert "Renew with" not in done.err


@pytest.mark.parametrize("option", [(), ("--check",), ("--runs", "runs")])
def test_tables_do_not_go_among_runs(vpr_bench, runs, option):
    before = everything("runs")
    done = vpr_bench(*BOARD, "--output", "runs", *option)
    assert done.code == 2
    assert "runs holds runs" in done.err and "--runs runs" in done.err
    assert everything("runs") == before


def test_a_folder_in_the_place_of_the_rows_is_called_one(vpr_bench, runs):
    RESULTS.mkdir(parents=True)
    done = vpr_bench(*BOARD)
    assert done.code == 3
    assert f"{RESULTS} is a folder" in done.err
    assert everything() == {}


def test_check_sees_runs_that_are_not_in_the_rows(vpr_bench, runs):
    vpr_bench(*BOARD, run_folder("hog").name)
    done = vpr_bench("leaderboard", "--check")
    assert done.code == 1
    assert f"not up to date: {RESULTS}" in done.err


def test_check_without_runs_compares_the_tables_with_the_rows(vpr_bench, runs):
    vpr_bench(*BOARD)
    shutil.rmtree("runs")
    assert vpr_bench("leaderboard", "--check").code == 0
    TABLE.unlink()
    assert vpr_bench("leaderboard", "--check").code == 1


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        ((), 3, "There are no runs under runs"),
        (("--runs", "nowhere"), 3, "There are no runs under nowhere"),
        (("--check",), 3, "There are no runs under runs"),
        (("zzz",), 2, "neither a run's folder nor"),
        (("0123",), 2, "no run begins with"),
        (("--format", "xml"), 2, "xml"),
    ],
)
def test_nothing_to_rank(vpr_bench, words, code, said):
    done = vpr_bench(*BOARD, *words)
    assert done.code == code
    assert said in " ".join(done.err.split())
    assert not Path("leaderboards").exists()


def test_a_mistyped_folder_of_runs_is_an_error_even_where_rows_are(vpr_bench, runs):
    vpr_bench(*BOARD)
    assert vpr_bench(*BOARD, "--runs", "rnus").code == 3


def test_a_damaged_run_is_left_out_and_a_named_one_refused(vpr_bench, runs):
    vpr_bench(*BOARD)
    before = everything()
    broken = run_folder("random")
    (broken / "labels.npz").write_bytes(b"nothing")
    done = vpr_bench(*BOARD, str(broken))
    assert done.code == 3
    assert "labels.npz is damaged" in done.err
    assert everything() == before
    done = vpr_bench(*BOARD)
    assert done.code == 0
    assert "labels.npz is damaged" in done.err


def test_a_run_that_cannot_be_scored_is_left_out_and_a_named_one_refused(vpr_bench, runs):
    record = run_folder("random") / "run.json"
    record.write_text(record.read_text("utf-8").replace("@1f", "@100f"), "utf-8")
    assert vpr_bench(*BOARD, str(record.parent)).code == 2
    assert everything() == {}
    done = vpr_bench(*BOARD, "--format", "json")
    assert [row["method"][:3] for row in json.loads(done.out)] == ["hog"]
    assert "It is left out." in done.err
    shutil.rmtree("leaderboards")
    shutil.rmtree(run_folder("hog"))
    done = vpr_bench(*BOARD)
    assert done.code == 3
    assert "no run could be scored" in done.err


def test_other_images_are_refused_unless_all_rows_are_replaced(vpr_bench, runs):
    vpr_bench(*BOARD)
    before = everything()
    for method in ("hog", "random"):
        record = run_folder(method) / "run.json"
        text = record.read_text("utf-8")
        digest = json.loads(text)["key"]["dataset_digest"]
        newer = text.replace(json.loads(text)["created"], "2999-01-01T00:00:00+00:00")
        record.write_text(newer.replace(digest, "sha256:" + "f" * 64), "utf-8")
        record.parent.rename(record.parent.with_name(read_record(record).key.digest()))
    done = vpr_bench(*BOARD, str(run_folder("hog")))
    assert done.code == 3
    assert digest in done.err
    assert "sha256:ffff" in done.err
    assert everything() == before
    done = vpr_bench(*BOARD)
    assert done.code == 0
    assert done.err.count("replaced:") == 2


@pytest.mark.parametrize("option", [(), ("--check",)])
def test_damaged_rows_are_refused_and_nothing_is_overwritten(vpr_bench, runs, option):
    vpr_bench(*BOARD)
    RESULTS.write_text(RESULTS.read_text("utf-8").replace("random", "perfect"), "utf-8")
    before = everything()
    done = vpr_bench(*BOARD, *option)
    assert done.code == 3
    assert "results.csv, line 3" in done.err
    assert "was changed after it was written" in done.err
    assert everything() == before


def test_what_others_wrote_is_not_written_over(vpr_bench, runs):
    Path("leaderboards").mkdir()
    Path("leaderboards/README.md").write_text("mine")
    done = vpr_bench(*BOARD)
    assert done.code == 3
    assert "was not made by `vpr-bench leaderboard`" in done.err
    assert everything() == {Path("leaderboards/README.md"): b"mine"}


def test_nothing_is_written_where_the_page_would_go_over_that_of_somebody_else(vpr_bench, runs):
    site = Path("docs/index.html")
    site.parent.mkdir()
    site.write_text("<!doctype html><title>mine</title>")
    done = vpr_bench("leaderboard", "--output", "docs")
    assert done.code == 3
    assert "docs/index.html was not made by `vpr-bench leaderboard`" in done.err
    assert list(everything("docs")) == [site]
    assert vpr_bench(*BOARD, "--output", "docs").code == 0
    assert site.read_text() == "<!doctype html><title>mine</title>"


def test_rows_that_another_process_writes_meanwhile_are_kept(vpr_bench, runs, monkeypatch):
    vpr_bench(*BOARD, run_folder("hog").name)
    theirs = RESULTS.read_bytes()
    shutil.rmtree("leaderboards")

    @contextmanager
    def held_after_them(lock, waiting):
        RESULTS.parent.mkdir()
        RESULTS.write_bytes(theirs)
        yield

    monkeypatch.setattr(renewal, "held", held_after_them)
    done = vpr_bench(*BOARD, run_folder("random").name, "--format", "json")
    assert [row["method"][:3] for row in json.loads(done.out)] == ["hog", "ran"]


def test_the_page_is_made_beside_the_tables_and_is_no_part_of_the_check(vpr_bench, runs):
    done = vpr_bench("leaderboard", run_folder("hog").name)
    assert done.code == 0
    page = Path("leaderboards/index.html")
    assert "hog(width=32, height=32, cell=8)" in page.read_text("utf-8")
    page.write_text("edited")
    assert vpr_bench("leaderboard", run_folder("hog").name, "--check").code == 0
