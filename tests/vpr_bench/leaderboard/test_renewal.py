import threading
from contextlib import contextmanager

import pytest

from vpr_bench.errors import DataError
from vpr_bench.leaderboard.renewal import LOCK, claimed, renewal
from vpr_bench.leaderboard.results import read_results, write_results
from vpr_bench.progress import listen


def test_what_is_stale_is_what_would_be_written(make_run, tmp_path):
    root = tmp_path / "boards"
    made = renewal(root, [make_run()])
    assert not root.exists()
    root.mkdir()
    stale = set(made.stale())
    made.write()
    assert stale == {path for path in root.rglob("*") if path.is_file()}
    assert renewal(root, []).stale() == []


def test_nothing_is_written_where_a_file_of_somebody_else_is_in_the_way(make_run, tmp_path):
    root = tmp_path / "boards"
    root.mkdir()
    (root / "README.md").write_text("mine")
    with pytest.raises(DataError, match="was not made by"):
        renewal(root, [make_run()]).write()
    assert [path.name for path in root.iterdir()] == ["README.md"]


def test_without_rows_there_is_nothing_to_rank(tmp_path):
    with pytest.raises(DataError, match="nothing to rank"):
        renewal(tmp_path, [])


def test_a_second_process_waits_and_keeps_the_rows_of_the_first(make_run, make_entry, tmp_path):
    run, waits = make_run("hog"), threading.Event()

    @contextmanager
    def heard(description, total):
        waits.set()
        yield lambda steps: None

    def second():
        with listen(heard), claimed(tmp_path):
            renewal(tmp_path, [run]).write()

    other = threading.Thread(target=second)
    with claimed(tmp_path):
        other.start()
        assert waits.wait(30)
        write_results(tmp_path / "results.csv", [make_entry("sift")])
    other.join()
    assert [entry.method for entry in read_results(tmp_path / "results.csv")] == ["hog", "sift"]
    assert (tmp_path / LOCK).exists()
