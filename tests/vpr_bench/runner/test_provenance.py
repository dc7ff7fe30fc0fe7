import json
import shutil
import subprocess
import sys
from importlib import metadata

import pytest
from pydantic import ValidationError

from vpr_bench.runner import provenance
from vpr_bench.runner.provenance import Provenance, SourceState, begin, command_line, source_state

needs_git = pytest.mark.skipif(shutil.which("git") is None, reason="there is no git here")


@pytest.fixture
def repository(tmp_path):
    """Return a repository with one committed file, and a function that calls git in it."""

    def git(*words):
        who = ("-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false")
        command = ["git", "-C", str(tmp_path / "there"), *who, *words]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()

    (tmp_path / "there" / "package").mkdir(parents=True)
    file = tmp_path / "there" / "package" / "__init__.py"
    file.write_text("A = 1\n")
    git("init", "--quiet")
    git("add", ".")
    git("commit", "--quiet", "--message", "first")
    return file, git


@needs_git
def test_a_file_of_a_repository(repository):
    file, git = repository
    assert provenance._state(file, "no-such-distribution") == SourceState(
        commit=git("rev-parse", "HEAD"), changed=False
    )
    file.write_text("A = 2\n")
    state = provenance._state(file, "no-such-distribution")
    assert state.changed is True
    assert str(state) == git("rev-parse", "HEAD")[:12] + ", changed since"


@needs_git
def test_what_lies_in_somebodys_repository_and_is_none_of_it(repository):
    file, _ = repository
    other = file.parent.parent / "environment" / "other.py"
    other.parent.mkdir()
    other.touch()
    assert provenance._state(other, "no-such-distribution") is None


@needs_git
def test_untracked_files_are_no_change(repository):
    file, _ = repository
    (file.parent.parent / "notes.txt").touch()
    assert provenance._state(file, "no-such-distribution").changed is False


@needs_git
def test_inside_a_hook_of_another_repository(repository, monkeypatch, tmp_path):
    file, git = repository
    commit = git("rev-parse", "HEAD")
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "elsewhere"))
    assert provenance._state(file, "no-such-distribution").commit == commit


def test_no_repository(tmp_path):
    assert provenance._state(tmp_path / "file.py", "no-such-distribution") is None


def test_no_git(monkeypatch, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert provenance._state(tmp_path / "file.py", "no-such-distribution") is None


def test_git_that_fails(monkeypatch, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda name: str(tmp_path / "no-such-git"))
    assert provenance._state(tmp_path / "file.py", "no-such-distribution") is None


@pytest.mark.parametrize(
    ("noted", "commit"),
    [
        ({"url": "https://example.org/a.git", "vcs_info": {"vcs": "git", "commit_id": "c0ffee"}}, "c0ffee"),
        ({"url": "file:///a", "dir_info": {"editable": True}}, None),
        ({"vcs_info": {"commit_id": 7}}, None),
        ([], None),
        (None, None),
    ],
)
def test_installed_from_a_repository(monkeypatch, tmp_path, noted, commit):
    folder = tmp_path / "made_up-1.0.dist-info"
    folder.mkdir()
    (folder / "METADATA").write_text("Metadata-Version: 2.1\nName: made-up\nVersion: 1.0\n")
    if noted is not None:
        (folder / "direct_url.json").write_text(json.dumps(noted))
    monkeypatch.syspath_prepend(tmp_path)
    assert metadata.version("made-up") == "1.0"
    state = provenance._state(tmp_path / "made_up.py", "made-up")
    assert (state.commit if state else None) == commit
    assert state is None or str(state) == f"{commit}, perhaps changed"


def test_damaged_note_of_the_installation(monkeypatch, tmp_path):
    folder = tmp_path / "made_up-1.0.dist-info"
    folder.mkdir()
    (folder / "METADATA").write_text("Metadata-Version: 2.1\nName: made-up\nVersion: 1.0\n")
    (folder / "direct_url.json").write_text("{")
    monkeypatch.syspath_prepend(tmp_path)
    assert provenance._state(tmp_path / "made_up.py", "made-up") is None


def test_command_without_its_folder(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["/somewhere/bin/vpr-bench", "run", "--method", "hog"])
    assert command_line() == ["vpr-bench", "run", "--method", "hog"]
    monkeypatch.setattr(sys, "argv", [])
    assert command_line() is None


def test_command_can_be_left_out(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["vpr-bench", "run", "--dataset", "secret"])
    monkeypatch.setenv("VPR_BENCH_NO_ARGV", "1")
    assert command_line() is None
    assert begin(object(), "not installed").argv is None


@needs_git
def test_a_method_of_another_repository(repository, monkeypatch):
    file, git = repository
    monkeypatch.syspath_prepend(file.parent.parent)
    monkeypatch.delitem(sys.modules, "package", raising=False)
    file.write_text("class Method:\n    pass\n")
    git("commit", "--all", "--quiet", "--message", "second")
    import package

    noted = begin(package.Method(), "not installed")
    monkeypatch.delitem(sys.modules, "package")
    assert noted.method_source == SourceState(commit=git("rev-parse", "HEAD"), changed=False)
    assert noted.source == source_state() != noted.method_source
    assert noted.origin == "not installed" and noted.started.endswith("+00:00")


def test_a_method_without_a_file():
    made = type("Made", (), {"__module__": "nowhere"})
    assert begin(made(), "not installed").method_source is None


@pytest.mark.parametrize("share", [-0.1, 1.1, float("nan")])
def test_a_share_is_between_0_and_1(share):
    with pytest.raises(ValidationError):
        Provenance(elsewhere=share)
