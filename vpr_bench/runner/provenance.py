"""How a run came about: which code, which command, and what else the machine was doing."""

import json
import os
import shutil
import subprocess
import sys
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from pydantic import BaseModel, ConfigDict, Field

import vpr_bench

NO_ARGV = "VPR_BENCH_NO_ARGV"
"""Environment variable that, set to anything, keeps the command out of what is noted."""

_OURSELVES = "vpr-bench"
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
    method_source : SourceState
        Of the file that the method's class stands in, where a repository knows that file, or its distribution was
        installed from one.
    started : str
        UTC time at which fitting began, ISO 8601; of a run that was continued, at which it went on.
    elsewhere : float
        Share of the machine's processor time that other processes took while queries were asked, in [0, 1]. Where it
        is not near 0, times say little. None for a run that was continued.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    argv: list[str] | None = None
    source: SourceState | None = None
    origin: str | None = None
    method_source: SourceState | None = None
    started: str | None = None
    elsewhere: float | None = Field(default=None, ge=0, le=1)


def begin(method: object, origin: str) -> Provenance:
    """Note, when a run begins, how it comes about.

    Parameters
    ----------
    method : object
        An instance of its class.
    origin : str
        The distribution that brings it, with its version, or ``not installed``.
    """
    file = getattr(sys.modules.get(type(method).__module__), "__file__", None)
    return Provenance(
        argv=command_line(),
        source=source_state(),
        origin=origin,
        method_source=_state(Path(file), origin.rpartition(" ")[0]) if file else None,
        started=utc_now(),
    )


def utc_now() -> str:
    """Return the time in UTC, ISO 8601, to the second."""
    return datetime.now(UTC).isoformat(timespec="seconds")


def command_line() -> list[str] | None:
    """Return the words of this process's command, the first one without its folder.

    Returns
    -------
    list of str or None
        None where ``VPR_BENCH_NO_ARGV`` is set: a command may hold what is nobody else's business.
    """
    if os.environ.get(NO_ARGV) or not sys.argv:
        return None
    return [Path(sys.argv[0]).name, *sys.argv[1:]]


@cache
def source_state() -> SourceState | None:
    """Find out which commit this vpr-bench is: from the repository that it lies in, else from how it was installed.

    Returns
    -------
    SourceState or None
        None where neither says.
    """
    return _state(Path(vpr_bench.__file__), _OURSELVES)


def _state(file: Path, name: str) -> SourceState | None:
    """Return the state of a source file, else that from which the distribution ``name`` was installed."""
    return _of_repository(file) or _of_installation(name)


def _of_repository(file: Path) -> SourceState | None:
    git = shutil.which("git")
    if git is None or _git(git, file.parent, "ls-files", "--error-unmatch", file.name) is None:
        return None  # a repository may lie around a virtual environment, and know nothing of what is in it
    commit = _git(git, file.parent, "rev-parse", "HEAD")
    changes = _git(git, file.parent, "status", "--porcelain", "--untracked-files=no")
    return SourceState(commit=commit, changed=None if changes is None else bool(changes)) if commit else None


def _git(git: str, folder: Path, *words: str) -> str | None:
    """Return what git prints, None if it fails; nothing in the repository is touched."""
    command = [git, "--no-optional-locks", "-C", str(folder), *words]
    # Inside a hook of git, variables say that the repository is the one that the hook is for.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    try:
        done = subprocess.run(  # noqa: S603
            command, env=environment, capture_output=True, text=True, timeout=_PATIENCE, check=True
        )
    except (OSError, subprocess.SubprocessError, UnicodeDecodeError):
        return None
    return done.stdout.strip()


def _of_installation(name: str) -> SourceState | None:
    try:
        noted = distribution(name).read_text("direct_url.json")
        commit = json.loads(noted)["vcs_info"]["commit_id"] if noted else None
    except (PackageNotFoundError, ValueError, KeyError, TypeError):
        return None
    return SourceState(commit=commit, changed=None) if isinstance(commit, str) else None
