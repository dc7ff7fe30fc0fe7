"""How many threads numerical libraries may use, and how much memory a phase takes at its peak."""

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
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
