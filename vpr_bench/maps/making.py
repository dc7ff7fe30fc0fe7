"""Making a map in a folder beside its place, so that what is in its place is whole at any time."""

import hashlib
import itertools
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from vpr_bench.checkpoint import checkpoints
from vpr_bench.cores import available_cores
from vpr_bench.errors import UsageError, blaming
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.lock import held
from vpr_bench.files.swap import former_of, recover, swap_in
from vpr_bench.maps.record import RECORD, STATE, Fitted, MapRecord, Part, write_record
from vpr_bench.maps.state import describe_state
from vpr_bench.method.interfaces import Method
from vpr_bench.method.saving import save_fitted
from vpr_bench.runner.machine import describe_machine
from vpr_bench.runner.resources import limit_threads

_STEPS = "fitting-"


@contextmanager
def claimed(folder: Path) -> Iterator[Path]:
    """Hold the place of a map against other processes; yield the folder beside it that a new one is made in.

    Raises
    ------
    UsageError
        If something else than a map is in the place, or it has no name.
    DataError
        If nothing can be written there.
    """
    check_place(folder)
    with held(folder.with_name(f".{folder.name}.lock"), "Waiting for another process that makes the same map"):
        if (former_of(folder) / RECORD).is_file():  # else it is not ours to delete
            recover(folder)
        check_place(folder)
        yield folder.with_name(folder.name + ".partial")


def check_place(folder: Path) -> None:
    """Refuse to put a map where something else is.

    Raises
    ------
    UsageError
        If something else is there.
    """
    if folder.name in ("", ".."):
        raise UsageError(f"A map needs a name of its own, such as gardens.map. Got {str(folder)!r} instead.")
    # An empty folder is nobody's work.
    if folder.exists() and not (folder / RECORD).is_file() and not (folder.is_dir() and not any(folder.iterdir())):
        raise UsageError(f"{folder} is there and is not a map: it is left alone. Choose another name for the map.")


@dataclass(frozen=True)
class Making:
    """How a map is made.

    Attributes
    ----------
    fitted : Fitted
        What stands in ``map.json`` about the method.
    parts : tuple of Part
        The references that it will have.
    seconds : float
        That went into it before.
    threads : int, optional
        For numerical libraries; by default one per core.
    """

    fitted: Fitted
    parts: tuple[Part, ...]
    seconds: float = 0.0
    threads: int | None = None

    def work(self, method: Method, learn: Callable[[], None], partial: Path, folder: Path) -> None:
        """Have the method learn, write the map into ``partial``, and move it to ``folder``.

        What was kept of an interrupted attempt at the same map is used.

        Raises
        ------
        UsageError
            If the method cannot be kept after all.
        DataError
            If an image cannot be decoded, or nothing can be written.
        VprBenchError
            If the method fails.
        """
        steps = partial / f"{_STEPS}{self._digest()}"
        with disk_errors(partial):
            partial.mkdir(exist_ok=True)
        for other in partial.glob(f"{_STEPS}*"):  # of another map that was to be here
            if other != steps:
                shutil.rmtree(other)
        threads, start = self.threads or available_cores(), time.perf_counter()
        failing = f"The method {self.fitted.id!r} failed while fitting"
        try:
            with disk_errors(partial), limit_threads(threads), checkpoints(steps), blaming(failing):
                learn()
        except UsageError:  # nothing to go on with
            shutil.rmtree(partial, ignore_errors=True)
            raise
        seconds = time.perf_counter() - start
        if not save_fitted(method, partial / STATE, self.fitted.id):
            shutil.rmtree(partial, ignore_errors=True)
            raise UsageError(
                f"{self.fitted.label} cannot be kept on disk: a method inside it has no save and load. "
                "It can be measured with `vpr-bench run`."
            )
        record = MapRecord(
            package=version("vpr-bench"),
            method=self.fitted,
            parts=self.parts,
            fit_seconds=self.seconds + seconds,
            machine=describe_machine(threads),
            created=datetime.now(UTC).isoformat(timespec="seconds"),
            files=describe_state(partial / STATE),
        )
        write_record(record, partial)
        shutil.rmtree(steps, ignore_errors=True)
        with disk_errors(folder):
            swap_in(partial, folder)

    def _digest(self) -> str:
        parts = (part.digest for part in self.parts)
        told = "\n".join(itertools.chain([self.fitted.model_dump_json()], parts))
        return hashlib.sha256(told.encode()).hexdigest()[:12]
