"""How many threads there are, and how many there may be."""

import sys
import threading
from types import TracebackType
from typing import Self

_PERIOD = 0.005  # seconds between two looks


def pool_threads() -> dict[str, int]:
    """Return how many threads each numerical library that is loaded may use."""
    from threadpoolctl import threadpool_info

    found = {str(pool["internal_api"]): int(pool["num_threads"]) for pool in threadpool_info()}
    torch, cv2 = sys.modules.get("torch"), sys.modules.get("cv2")
    if torch:
        found["torch"] = torch.get_num_threads()
    if cv2:
        found["OpenCV"] = cv2.getNumThreads()
    return found


class Busiest:
    """The most threads and child processes that are there at once inside a ``with`` block.

    Attributes
    ----------
    more : int
        Than at its beginning.
    """

    def __init__(self) -> None:
        import psutil

        self.more = 0
        self._process = psutil.Process()
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Self:
        """Start to watch."""
        self._before = self._count() + 1  # the watch itself
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Take a last look."""
        self.more = max(self.more, self._count() - self._before)
        self._done.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._done.wait(_PERIOD):
            self.more = max(self.more, self._count() - self._before)

    def _count(self) -> int:
        return int(self._process.num_threads()) + len(self._process.children(recursive=True))
