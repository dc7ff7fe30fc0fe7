import csv
import io
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

SMALL = ("--param", "width=32", "--param", "height=32", "--param", "cell=8")
TINY = ("run", "--method", "hog", *SMALL, "--dataset", "tiny")


def test_prints_one_row_and_stores_the_run(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY)
    assert done.code == 0, done.err
    assert "tiny/day_left-day_right@1f" in done.out
    assert "hog(width=32, height=32, cell=8)" in done.out
    assert "real images in" in done.err
    folder = next(Path("runs").rglob("run.json")).parent
    assert {file.name for file in folder.iterdir()} == {
        "run.json",
        "matches.npz",
        "timings.npz",
        "labels.npz",
        "precision_recall.png",
        "precision_recall.svg",
    }


def test_second_time_only_shows(vpr_bench, tiny_dataset):
    first, second = vpr_bench(*TINY), vpr_bench(*TINY)
    assert first.out == second.out
    assert "stored already" in second.err


def test_json_has_everything_and_stdout_nothing_else(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY, "--format", "json", "--radius", "0,2", "--bootstrap", "50")
    rows = json.loads(done.out)
    assert [row["protocol"] for row in rows] == ["tiny/day_left-day_right@0f", "tiny/day_left-day_right@2f"]
    assert rows[0]["metrics"]["recall@1"] <= rows[1]["metrics"]["recall@1"]
    assert rows[0]["intervals"].keys() == rows[0]["metrics"].keys()
    assert rows[0]["latency_ms"]["latency_total_p95"] > 0
    assert len(list(Path("runs").rglob("run.json"))) == 1  # the radius is not part of a run


def test_csv(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY, "--format", "csv", "--metric", "recall@3")
    assert 0 <= float(next(csv.DictReader(io.StringIO(done.out)))["recall@3"]) <= 1


def test_several_protocols(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY, "--protocol", "all")
    assert "tiny/day_left-day_right@1f" in done.out
    assert "tiny/day_left-night_right@1f~miss" in done.out


def test_whole_protocol_id(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY[:-1], "tiny/day_left-night_right@3f~reject")
    assert "tiny/day_left-night_right@3f~reject" in done.out


def test_parameter_of_one_of_several_methods(vpr_bench, tiny_dataset):
    words = ("run", "--method", "hog", "--method", "vpr_baselines.hog:Hog", "--dataset", "tiny")
    done = vpr_bench(*words, *SMALL, "--param", "hog.bins=6", "--format", "json")
    assert [row["method"] for row in json.loads(done.out)] == [
        "hog(width=32, height=32, cell=8, bins=6)",
        "vpr_baselines.hog:Hog(width=32, height=32, cell=8)",
    ]


def test_simulated_images_are_announced(vpr_bench, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench(*TINY)
    assert "SIMULATED" in done.err
    assert "vpr-bench data fetch tiny" in done.err
    assert "tiny:simulated/day_left-day_right@1f" in done.out


def test_limit_is_marked(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY, "--limit", "3")
    assert "3 queries (partial)" in done.out


def test_all_pairs_with_the_whole_ranking(vpr_bench, tiny_dataset):
    done = vpr_bench(*TINY, "--k", "12", "--metric", "pr_auc_pairs", "--format", "json")
    assert json.loads(done.out)[0]["metrics"]["pr_auc_pairs"] > 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--method", "hgo"), "Did you mean 'hog'?"),
        (("--dataset", "tinyy"), "Did you mean 'tiny'?"),
        (("--protocol", "day_left-day_rihgt"), "Did you mean 'day_left-day_right'?"),
        (("--param", "cel=3"), "Did you mean 'cell'?"),
        (("--param", "cell=many"), "Got 'many'"),
        (("--param", "cell"), "name=value"),
        (("--param", "sift.cell=3"), "'sift', which is not run"),
        (("--radius", "-1"), "Got '-1'"),
        (("--radius", "nan"), "Got 'nan'"),
        (("--radius", "wide"), "Got 'wide'"),
        (("--radius", "1,500"), "reaches over the whole map"),
        (("--k", "13"), "Got 13"),
        (("--k", "0"), "Got 0"),
        (("--limit", "0"), "Got 0"),
        (("--metric", "recal@1"), "Did you mean 'recall@1'?"),
        (("--edition", "photo"), "photo"),
        (("--threads", "0"), "greater than or equal to 1"),
        (("--overwrite", "perhaps"), "perhaps"),
        (("--unmatched", "ignore"), "ignore"),
        (("--method", "vpr_baselines.hog:Hgo"), "cannot be loaded"),
    ],
)
def test_usage_errors(vpr_bench, tiny_dataset, words, said):
    done = vpr_bench("run", "--method", "hog", "--dataset", "tiny", *words)
    assert done.code == 2
    assert said in done.err
    assert "Traceback" not in done.err
    assert not list(Path().rglob("run.json"))


def test_damaged_image(vpr_bench, tiny_dataset):
    image = tiny_dataset.folder / "day_right" / "Image005.jpg"
    image.write_bytes(image.read_bytes()[:200])
    done = vpr_bench(*TINY)
    assert done.code == 3
    assert "Image005.jpg cannot be decoded" in done.err


def test_missing_image(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_right" / "Image005.jpg").unlink()
    done = vpr_bench(*TINY)
    assert done.code == 3
    assert "found 11, Image005.jpg is missing" in done.err


def test_unwritable_output(vpr_bench, tiny_dataset):
    Path("taken").touch()
    done = vpr_bench(*TINY, "--output", "taken/runs")
    assert done.code == 3
    assert "in the way" in done.err


def test_a_failing_cell_does_not_stop_the_others(vpr_bench, tiny_dataset):
    words = ("run", "--method", "hog", "--method", "collections:Counter", "--dataset", "tiny")
    assert vpr_bench(*words).code == 2  # refused before anything is run
    image = tiny_dataset.folder / "night_right" / "Image005.jpg"
    image.write_bytes(b"no image")
    done = vpr_bench(*TINY, "--protocol", "all")
    assert done.code == 3
    assert "tiny/day_left-day_right@1f" in done.out


def test_ctrl_c_keeps_what_was_done(tmp_path):
    """In a process of its own, with a method slow enough to be interrupted in each phase."""
    (tmp_path / "slow.py").write_text(
        "import time\n"
        "from vpr_bench import Match\n"
        "class Slow:\n"
        "    def __init__(self, fit: float = 0, match: float = 0):\n"
        "        self.fit_seconds, self.match_seconds = fit, match\n"
        "    def fit(self, references):\n"
        "        print('fitting', flush=True)\n"
        "        time.sleep(self.fit_seconds)\n"
        "    def match(self, image, k):\n"
        "        print('matching', flush=True)\n"
        "        time.sleep(self.match_seconds)\n"
        "        return Match(range(k), [0.0] * k)\n"
    )
    (tmp_path / "tiny.py").write_text(
        "import sys\n"
        f"sys.path[:0] = [{str(tmp_path)!r}]\n"
        "import numpy as np\n"
        "from pathlib import Path\n"
        "from vpr_bench import Protocol, Traverse\n"
        "from vpr_bench.dataset.load import Case\n"
        "from vpr_bench.types.places import Places\n"
        "import vpr_bench.dataset.load as load\n"
        "import vpr_bench.dataset.card as card\n"
        "images = Traverse('a', [np.full((4, 4, 3), i, np.uint8) for i in range(9)])\n"
        "places = Places(np.arange(9.), np.arange(9.))\n"
        "case = Case(Protocol('tiny', 'a', 'b', 1, 'f'), images, images, places, 'x', Path())\n"
        "load.load_case = lambda *words, **named: case\n"
        "from vpr_bench.cli import main\n"
        "main()\n"
    )
    for phase, parameter in (("fitting", "fit=60"), ("matching", "match=60")):
        words = [
            sys.executable,
            "tiny.py",
            "run",
            "--method",
            "slow:Slow",
            "--param",
            parameter,
            "--dataset",
            "gardens",
        ]
        process = subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while phase not in process.stderr.readline():  # what a method prints is no result
            assert process.poll() is None, process.stderr.read()
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=20)
        assert process.returncode == 130
        assert "interrupted" in err
        assert "Traceback" not in err
        assert phase not in out
        assert not list((tmp_path / "runs").rglob("run.json"))


def test_rows_that_are_done_are_printed_when_interrupted(vpr_bench, tiny_dataset, monkeypatch):
    import vpr_baselines.hog

    stopped = ("--method", "vpr_baselines.hog:Hog", "--format", "json")
    assert vpr_bench(*TINY).code == 0
    monkeypatch.setattr(vpr_baselines.hog.Hog, "match", _interrupt)
    done = vpr_bench(*TINY, *stopped)
    assert done.code == 130
    assert len(json.loads(done.out)) == 1


def _interrupt(*words):
    raise KeyboardInterrupt


def test_method_that_exits_does_not_pass_for_success(vpr_bench, tiny_dataset, monkeypatch):
    import vpr_baselines.hog

    monkeypatch.setattr(vpr_baselines.hog.Hog, "match", lambda *words: sys.exit(0))
    done = vpr_bench(*TINY)
    assert done.code == 1
    assert "'hog' failed while warming up: SystemExit" in done.err


def test_what_a_method_prints_is_no_result(vpr_bench, tiny_dataset, monkeypatch):
    import vpr_baselines.hog

    fit = vpr_baselines.hog.Hog.fit
    monkeypatch.setattr(vpr_baselines.hog.Hog, "fit", lambda *words: (print("chatter"), fit(*words))[1])  # noqa: T201
    done = vpr_bench(*TINY, "--format", "json")
    assert len(json.loads(done.out)) == 1
    assert "chatter" in done.err


def test_a_picture_that_cannot_be_drawn_costs_no_result(vpr_bench, tiny_dataset, monkeypatch):
    from vpr_bench.errors import DataError
    from vpr_bench.report import curve

    def fail(*words):
        raise DataError("no paper")

    monkeypatch.setattr(curve, "draw_curve", fail)
    done = vpr_bench(*TINY)
    assert done.code == 0
    assert "there is no picture: no paper" in done.err
    assert "hog" in done.out
