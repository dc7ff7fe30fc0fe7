"""How a run came about: which code, which command, and what else the machine was doing."""

import json
import shutil
import subprocess
import sys
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from pydantic import BaseModel, ConfigDict

import vpr_bench

_PATIENCE = 10.0  # seconds for git to answer


class SourceState(BaseModel):
    """Which state of the repository the code was in.

    Attributes
    ----------
    commit : str
        Full hash.
    changed : bool or None
        Files that git knows differed from that commit; None where that cannot be known.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    commit: str
    changed: bool | None

    def __str__(self) -> str:
        """Write the short hash, and whether the files were as committed."""
        return self.commit[:12] + {True: ", changed since", False: "", None: ", perhaps changed"}[self.changed]


class Provenance(BaseModel):
    """How a run came about; every part is None where it was not noted.

    Attributes
    ----------
    argv : list of str
        The command; its first word without the folder.
    source : SourceState
        Of vpr-bench, where it was run from a repository or installed from one.
    origin : str
        The distribution that brings the method, with its version; ``not installed`` if none does.
    started : str
        UTC time at which fitting began, ISO 8601.
    elsewhere : float
        Share of the machine's processor time that other processes took while queries were asked, in [0, 1]. Where it
        is not near 0, times say little.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    argv: list[str] | None = None
    source: SourceState | None = None
    origin: str | None = None
    started: str | None = None
    elsewhere: float | None = None


def command_line() -> list[str]:
    """Return the words of this process's command; the first one without its folder."""
    return [Path(sys.argv[0]).name, *sys.argv[1:]] if sys.argv else []


@cache
def source_state() -> SourceState | None:
    """Find out which commit this vpr-bench is: from the repository that it lies in, else from how it was installed.

    Returns
    -------
    SourceState or None
        None where neither says.
    """
    return _of_repository(Path(vpr_bench.__file__).parent) or _of_installation()


def _of_repository(package: Path) -> SourceState | None:
    git = shutil.which("git")
    if git is None or _git(git, package, "ls-files", "--error-unmatch", "__init__.py") is None:
        return None  # a repository may lie around a virtual environment, and know nothing of what is in it
    commit = _git(git, package, "rev-parse", "HEAD")
    changes = _git(git, package, "status", "--porcelain", "--untracked-files=no")
    return SourceState(commit=commit, changed=None if changes is None else bool(changes)) if commit else None


def _git(git: str, folder: Path, *words: str) -> str | None:
    """Return what git prints, None if it fails."""
    try:
        done = subprocess.run(  # noqa: S603
            [git, "-C", str(folder), *words], capture_output=True, text=True, timeout=_PATIENCE, check=True
        )
    except (OSError, subprocess.SubprocessError, UnicodeDecodeError):
        return None
    return done.stdout.strip()


def _of_installation() -> SourceState | None:
    try:
        noted = distribution("vpr-bench").read_text("direct_url.json")
        commit = json.loads(noted)["vcs_info"]["commit_id"] if noted else None
    except (PackageNotFoundError, ValueError, KeyError, TypeError):
        return None
    return SourceState(commit=commit, changed=None) if isinstance(commit, str) else None
