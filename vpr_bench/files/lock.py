"""One process at a time, across processes."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from vpr_bench.files.disk import disk_errors
from vpr_bench.progress import task


@contextmanager
def held(lock: Path, waiting: str) -> Iterator[None]:
    """Hold the lock file ``lock`` inside the ``with`` block; wait, and say ``waiting``, while another process does.

    Raises
    ------
    DataError
        If the file cannot be made.
    """
    from filelock import FileLock, Timeout

    with disk_errors(lock.parent):
        lock.parent.mkdir(parents=True, exist_ok=True)
        lock.touch()  # where no file can be made, FileLock may wait for ever
        holder = FileLock(lock)
        try:
            holder.acquire(timeout=0)
        except Timeout:
            with task(waiting):
                holder.acquire(poll_interval=0.2)
    try:
        yield
    finally:
        holder.release()
