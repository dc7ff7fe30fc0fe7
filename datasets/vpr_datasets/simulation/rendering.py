"""Rendering all images of a simulation with several processes."""

import os
import subprocess
import sys
from pathlib import Path
from queue import SimpleQueue
from threading import Thread

from vpr_bench.cores import available_cores
from vpr_bench.progress import task
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.job import Job
from vpr_datasets.simulation.spec import SimulationSpec
from vpr_datasets.simulation.worker import STEP

_MODULE = "vpr_datasets.simulation.worker"
_KEPT_LINES = 12
_MOST_WORKERS = 4  # each builds the scene for itself, which more of them would hardly repay


def render(spec: SimulationSpec, folder: Path, *, files: Files | None = None, workers: int | None = None) -> None:
    """Render every image of ``spec`` into ``folder``.

    The work is shared by processes that are started anew, not forked or re-imported from the caller's
    program, so that it makes no difference where this is called from.

    Parameters
    ----------
    spec
        What to render.
    folder
        Where to put the images; made when it is missing. Nothing is written elsewhere.
    files
        The names of the images below ``folder``; by default JPEGs in a folder for each traverse.
    workers
        Number of processes; by default one for each processor that this process may use, four at most.

    Raises
    ------
    ValueError
        If the number of workers is of no use.
    RuntimeError
        If a worker fails; the message ends with what it said last.
    """
    if workers is None:
        workers = min(available_cores(), _MOST_WORKERS)
    if workers < 1:
        raise ValueError(f"workers must be at least 1, got {workers}")
    total = sum(spec.frames_of(traverse) for traverse in spec.traverses)
    workers = min(workers, total)
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    processes: list[subprocess.Popen[str]] = []
    lines: SimpleQueue[tuple[int, str | None]] = SimpleQueue()
    try:
        for number in range(workers):
            job = Job(spec=spec, folder=folder, files=files or Files(), worker=number, workers=workers)
            processes.append(_start(job))
            Thread(target=_listen, args=(processes[-1], number, lines), daemon=True).start()
        _follow(processes, lines, total)
    finally:
        # After a failure, or when the user interrupts, nobody goes on working in the background.
        for process in processes:
            process.kill()
        for process in processes:
            process.wait()


def _start(job: Job) -> subprocess.Popen[str]:
    """Start one worker and give it its job."""
    # The worker finds the same modules as this process, however they got on the path; -P keeps files that
    # happen to lie in the current folder out of it.
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(entry for entry in sys.path if entry)}
    process = subprocess.Popen(  # noqa: S603 - our own module, run by our own interpreter
        [sys.executable, "-P", "-m", _MODULE],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        errors="replace",
        env=environment,
    )
    if process.stdin is not None:
        try:
            with process.stdin as stdin:
                stdin.write(job.model_dump_json())
        except BrokenPipeError:
            # It died before it read its job; its own words, read later, say why.
            pass
    return process


def _listen(process: subprocess.Popen[str], number: int, lines: "SimpleQueue[tuple[int, str | None]]") -> None:
    """Pass on what a worker says; None when it has ended."""
    if process.stdout is not None:
        for line in process.stdout:
            lines.put((number, line.rstrip("\n")))
    lines.put((number, None))


def _follow(processes: list[subprocess.Popen[str]], lines: "SimpleQueue[tuple[int, str | None]]", total: int) -> None:
    """Report progress until all workers are done; raise as soon as one has failed."""
    said: list[list[str]] = [[] for _ in processes]
    running = len(processes)
    with task("Rendering the simulated edition", total=total) as advance:
        while running:
            number, line = lines.get()
            if line == STEP:
                advance(1)
            elif line is not None:
                said[number] = [*said[number], line][-_KEPT_LINES:]
            else:
                running -= 1
                code = processes[number].wait()
                if code != 0:
                    words = "\n".join(said[number]) or "it said nothing"
                    raise RuntimeError(
                        f"rendering worker {number + 1} of {len(processes)} ended with exit status {code}:\n{words}"
                    )
