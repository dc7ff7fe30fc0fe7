"""What a method does to the machine that it runs on."""

import os
from pathlib import Path
from typing import Any

from vpr_bench.check.listening import listening
from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.busy import Busiest, pool_threads
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import as_map, picture, revisited
from vpr_bench.check.outcome import Failed
from vpr_bench.check.suite import check
from vpr_bench.runner.resources import limit_threads

_LIMIT = 1
_HELPERS = 4
"""Threads and processes besides: some that wait for a disk do no harm."""


def _work(subject: Subject) -> None:
    """Fit a new method on a small map and ask it."""
    method = subject.make()
    fit(method, as_map([picture(0), picture(1)]))
    ask(method, revisited([0, 1]), 2)


@check("threads-respected", "answers-are-matches")
def threads_respected(subject: Subject) -> None:
    """Check that it starts no more threads than it may, and leaves the limits of numerical libraries alone."""
    _ = subject.usual_answers  # a limit reaches the libraries that are loaded when it is set
    with limit_threads(_LIMIT), Busiest() as busiest:
        _work(subject)
        raised = {name: threads for name, threads in pool_threads().items() if threads > _LIMIT}
    if raised:
        told = ", ".join(f"{name} to {threads}" for name, threads in raised.items())
        raise Failed(f"where {_LIMIT} thread is allowed, it raises the limit of {told}")
    if busiest.more > _LIMIT + _HELPERS:
        raise Failed(f"where {_LIMIT} thread is allowed, it starts {busiest.more} threads and processes")


@check("no-network", "answers-are-matches")
def no_network(subject: Subject) -> None:
    """Check that fitting and matching ask nothing of any network."""
    tried: list[str] = []

    def refuse(event: str, arguments: tuple[Any, ...]) -> None:
        address: Any = None
        if event in ("socket.connect", "socket.sendto", "socket.sendmsg"):
            address = arguments[1] if isinstance(arguments[1], tuple) else None  # else a socket of this machine
        elif event in ("socket.getaddrinfo", "socket.gethostbyname", "socket.gethostbyaddr"):
            address = arguments
        if address:
            tried.append(":".join(str(part) for part in address[:2]))
            raise ConnectionError("there is no network here: weights are fetched beforehand")

    error = None
    with listening(refuse):
        try:
            _work(subject)
        except Failed as failed:
            error = failed
    if tried:  # also where it caught our refusal and went on
        raise Failed(f"it asks for {tried[0]}, but there may be no network: fetch beforehand") from error
    if error is not None:
        raise error


@check("leaves-no-files", "answers-are-matches")
def leaves_no_files(subject: Subject) -> None:
    """Check that fitting and matching leave no files behind: only the folder that save is given is a method's."""
    written: dict[str, None] = {}

    def note(event: str, arguments: tuple[Any, ...]) -> None:
        path = _written(event, arguments)
        if isinstance(path, str | bytes | os.PathLike):
            written[os.path.abspath(os.fsdecode(path))] = None  # noqa: PTH100 - pathlib's opens nothing, but resolves

    _ = subject.usual_answers  # so that what is imported late has been compiled
    with listening(note):
        _work(subject)
    left = [path for path in map(Path, written) if path.exists() and path.parts[1:2] not in (("dev",), ("proc",))]
    left = [path for path in left if "__pycache__" not in path.parts]
    if left:
        more = f" and {len(left) - 1} more" if left[1:] else ""
        raise Failed(f"fit or match leaves {left[0]}{more} behind")


def _written(event: str, arguments: tuple[Any, ...]) -> Any:
    """Return the path that an event creates or writes to, None if it does neither."""
    if event == "open":
        path, mode, flags = arguments
        writes = set(mode) & set("wax+") if isinstance(mode, str) else flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT)
        return path if writes else None
    if event == "os.mkdir":
        return arguments[0]
    return arguments[1] if event in ("os.rename", "os.link", "os.symlink") else None


CHECKS = (threads_respected, no_network, leaves_no_files)
