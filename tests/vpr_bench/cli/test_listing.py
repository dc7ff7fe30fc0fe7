import json

import pytest


def test_list_names_everything_and_its_origin(vpr_bench):
    done = vpr_bench("list")
    assert done.code == 0
    for name in ("hog", "twostage", "gardens", "pr_auc_matched", "vpr-bench 0"):
        assert name in done.out


def test_list_json(vpr_bench):
    listed = json.loads(vpr_bench("list", "methods", "--format", "json").out)
    assert {"hog", "twostage"} <= {one["name"] for one in listed["methods"]}
    assert all(one["what"] for one in listed["methods"])


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("gardens", "gardens/day_left-night_right@2f"),
        ("hog", "parameter: width · default: 512"),
        ("hog", "parameter: metric · default: 'cosine'"),
        ("hog", "preset: hog:thesis · width: 64 · height: 128"),
        ("hog:thesis", "parameter: width · default: 64"),
        ("pr_auc", "area under precision-recall"),
    ],
)
def test_info(vpr_bench, name, said):
    done = vpr_bench("info", name)
    assert done.code == 0
    assert said in done.out


def test_presets_are_listed_and_a_wrong_one_is_refused(vpr_bench):
    assert "hog:thesis, hog:vpr-bench" in {
        one["presets"] for one in json.loads(vpr_bench("list", "methods", "--format", "json").out)["methods"]
    }
    done = vpr_bench("info", "hog:thesi")
    assert done.code == 2 and "The method 'hog' has no preset 'thesi'. Did you mean 'thesis'?" in done.err


def test_info_json(vpr_bench):
    facts = json.loads(vpr_bench("info", "gardens", "--format", "json").out)
    assert len(facts["protocols"]) == 3
    assert facts["licence"]


def test_info_of_nothing(vpr_bench):
    done = vpr_bench("info", "gardes")
    assert done.code == 2
    assert "Did you mean 'gardens'?" in done.err


def test_version(vpr_bench):
    assert vpr_bench("--version").out.startswith("vpr-bench 0.")


@pytest.mark.parametrize("command", ["run", "list", "info", "show", "score"])
def test_help_shows_examples(vpr_bench, command):
    done = vpr_bench(command, "--help")
    assert done.code == 0
    assert f"vpr-bench {command}" in done.out.replace("\n", " ").partition("Examples")[2]


def test_unknown_command(vpr_bench):
    assert vpr_bench("runn").code == 2


def test_usage_errors_are_one_line(vpr_bench):
    for words in (("runn",), ("run", "--method", "hog"), ("run", "--k", "many"), ("list", "colours")):
        done = vpr_bench(*words)
        assert done.code == 2
        assert done.err.startswith("error: ")
        assert done.err.count("\n") == 1


def test_no_words_show_the_help(vpr_bench):
    done = vpr_bench()
    assert done.code == 2
    assert "Usage: vpr-bench" in done.out + done.err
    assert "error" not in done.err


def test_what_was_not_foreseen_is_no_traceback(vpr_bench, monkeypatch):
    def fail(*words):
        raise RuntimeError("surprise")

    monkeypatch.setattr("vpr_bench.cli.listing.show", fail)
    done = vpr_bench("list")
    assert done.code == 1
    assert "unforeseen RuntimeError: surprise" in done.err
    assert "Traceback" not in done.err
