"""A thread that does one thing at a time and can be given up."""

import ctypes
import queue
import threading
import warnings
from collections.abc import Callable
from contextvars import copy_context
from types import TracebackType
from typing import Any, Self, TypeVar

from vpr_bench.runner.resources import limit_threads

T = TypeVar("T")

_GRACE = 1.0  # seconds that a thread has to stop in before it is left behind


class AbandonedWarning(UserWarning):
    """A method that did not answer in time cannot be stopped."""


class _GivenUp(BaseException):
    """Raised inside a thread that nobody waits for any more; no ``except Exception`` catches it."""


class Worker:
    """Calls functions in a thread of its own, for at most so many seconds each.

    A thread, and not a signal: signals exist in the main thread of a POSIX process only, and do not reach a
    method that hangs inside a library. The thread that is given up is told to stop, which ends Python code; one
    that hangs inside a library is left behind with a warning and dies with the process. The measured time of a
    call does not include the hand-over if it is taken by the function itself.

    Parameters
    ----------
    threads : int
        What numerical libraries are held to in the thread: OpenMP counts for each thread apart.
    """

    def __init__(self, threads: int) -> None:
        self._tasks: queue.SimpleQueue[tuple[Callable[[], Any], queue.SimpleQueue[Any]] | None] = queue.SimpleQueue()
        self._thread = threading.Thread(target=self._work, args=(threads,), daemon=True, name="vpr-bench worker")
        self._busy = False

    def __enter__(self) -> Self:
        """Start the thread."""
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End the thread; if it is at work, because of a time-out or Ctrl-C, give it up."""
        self._tasks.put(None)
        if not self._busy:
            self._thread.join()
        elif not self._stopped():
            warnings.warn(
                "What did not answer in time does not stop either and is left behind: "
                "if it computes, times measured in this process from now on are too long.",
                AbandonedWarning,
                stacklevel=2,
            )

    def call(self, function: Callable[[], T], seconds: float) -> T:
        """Return what the function returns, or raise what it raises.

        Raises
        ------
        TimeoutError
            If it takes longer. The worker cannot be used any more.
        """
        answer: queue.SimpleQueue[tuple[T | None, BaseException | None]] = queue.SimpleQueue()
        context = copy_context()  # so that what listens here listens there
        self._busy = True
        self._tasks.put((lambda: context.run(function), answer))
        try:
            result, error = answer.get(timeout=seconds)
        except queue.Empty:
            raise TimeoutError(f"no answer within {seconds:g} s") from None
        self._busy = False
        if error is not None:
            raise error
        return result  # type: ignore[return-value]

    def _work(self, threads: int) -> None:
        try:
            with limit_threads(threads):
                while (task := self._tasks.get()) is not None:
                    function, answer = task
                    try:
                        answer.put((function(), None))
                    except _GivenUp:
                        raise
                    except BaseException as error:  # goes to whoever waits, whatever it is
                        answer.put((None, error))
        except _GivenUp:
            pass

    def _stopped(self) -> bool:
        """Tell the thread to stop; return whether it did."""
        # Python has no other way to reach into a thread; it arrives when the thread next runs Python code.
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread.ident or 0), ctypes.py_object(_GivenUp))
        self._thread.join(_GRACE)
        return not self._thread.is_alive()
