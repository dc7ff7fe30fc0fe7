"""Calling the command line as a shell would, in this process."""

import sys
from collections.abc import Callable
from dataclasses import dataclass

import pytest

from vpr_bench.cli import main


@dataclass(frozen=True)
class Outcome:
    """What a command left: its exit code and what it printed."""

    code: int
    out: str
    err: str


@pytest.fixture
def vpr_bench(monkeypatch, capsys, tmp_path) -> Callable[..., Outcome]:
    """Run ``vpr-bench`` with the given words in an empty folder."""
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")

    def call(*words: str) -> Outcome:
        monkeypatch.setattr(sys, "argv", ["vpr-bench", *words])
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            main()
        printed = capsys.readouterr()
        return Outcome(ended.value.code or 0, printed.out, printed.err)

    return call
