"""How many threads numerical libraries may use, what memory a phase takes, and what else the machine does meanwhile."""

import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import Self

_PERIOD = 0.02  # seconds between two looks at the memory


@contextmanager
def limit_threads(threads: int) -> Iterator[None]:
    """Hold BLAS, OpenMP, OpenCV and torch to ``threads`` threads inside the ``with`` block.

    It reaches the libraries that are loaded when the block begins.
    """
    from threadpoolctl import threadpool_limits

    torch, cv2 = sys.modules.get("torch"), sys.modules.get("cv2")
    before = (torch.get_num_threads() if torch else 0, cv2.getNumThreads() if cv2 else 0)
    with threadpool_limits(threads):
        if torch:
            torch.set_num_threads(threads)
        if cv2:
            cv2.setNumThreads(threads)
        try:
            yield
        finally:
            if torch:
                torch.set_num_threads(before[0])
            if cv2:
                cv2.setNumThreads(before[1])


class PeakMemory:
    """The process's largest resident memory inside a ``with`` block, sampled every 20 ms by a thread.

    Attributes
    ----------
    bytes : int
        Largest resident set size seen so far.
    """

    def __init__(self) -> None:
        import psutil

        self.bytes = 0
        self._process = psutil.Process()
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Self:
        """Start to watch."""
        self._look()
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Take a last look."""
        self._done.set()
        self._thread.join()
        self._look()

    def _watch(self) -> None:
        while not self._done.wait(_PERIOD):
            self._look()

    def _look(self) -> None:
        self.bytes = max(self.bytes, self._process.memory_info().rss)


class Elsewhere:
    """What other processes take of the machine's processor time inside a ``with`` block.

    Processes that this one started are not others, as long as it waits for them or they live. Time that a virtual
    machine waited for its host counts as taken.

    Attributes
    ----------
    share : float
        Of all cores' time, in [0, 1]; known when the block has ended.
    """

    def __init__(self) -> None:
        self.share = 0.0
        self._before = (0.0, 0.0, 0.0)

    def __enter__(self) -> Self:
        """Start to count."""
        self._before = _clocks()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Take the difference."""
        wall, busy, own = (after - before for after, before in zip(_clocks(), self._before, strict=True))
        self.share = min(1.0, max(0.0, busy - own) / wall) if wall > 0 else 0.0


def _clocks() -> tuple[float, float, float]:
    """Return the seconds gone by times the cores, those in which a core was busy, and those of our processes."""
    import psutil

    machine = psutil.cpu_times()
    waiting = machine.idle + getattr(machine, "iowait", 0.0)
    # Virtual machines count guests twice: in their own column, and as the user's.
    total = sum(machine) - getattr(machine, "guest", 0.0) - getattr(machine, "guest_nice", 0.0)
    cores = psutil.cpu_count() or 1
    return time.perf_counter() * cores, total - waiting, _own_seconds()


def _own_seconds() -> float:
    """Return the processor seconds of this process, of what it started that still lives, and of what it waited for."""
    import psutil

    seconds = 0.0
    process = psutil.Process()
    for one in [process, *process.children(recursive=True)]:
        with suppress(psutil.Error):  # it may just have ended
            own = one.cpu_times()
            seconds += own.user + own.system + own.children_user + own.children_system
    return seconds
