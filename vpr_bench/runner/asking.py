"""Asking one method one query after the other: the order, the clock, and what is no answer."""

import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, field
from functools import partial
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case
from vpr_bench.errors import VprBenchError, blaming
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.faults import fault_in, shortfall_in
from vpr_bench.method.interfaces import Foresighted, Method, frames_ahead, is_sequential
from vpr_bench.runner.answers import AnswerTable
from vpr_bench.runner.record import RunKey
from vpr_bench.runner.shortlists import checked
from vpr_bench.runner.worker import Worker
from vpr_bench.shortlist import Shortlists, collect_shortlists
from vpr_bench.timing import collect_stages
from vpr_bench.types.match import Match

T = TypeVar("T")
Image = NDArray[np.uint8]

_WARM_UP = 3  # answers that are not recorded, before the first that is
_FIRST_PATIENCE = 10.0  # times the time-out: the very first answer may have to load a network


def query_order(n_queries: int, key: RunKey, *, sequential: bool) -> list[int]:
    """Return the queries in the order in which they are asked, cut to the limit.

    Shuffled by the run's seed, so that counting queries does not tell places; a sequential method, which
    would make nothing of that, is shown them as they come.
    """
    order = np.arange(n_queries) if sequential else np.random.default_rng(key.seed).permutation(n_queries)
    return [int(query) for query in order[: key.limit]]


@dataclass
class Questioner:
    """Asks a fitted method, and keeps its answers in a table.

    Parameters
    ----------
    case : Case
        Where the images come from.
    built : BuiltMethod
        What to call the method in messages.
    method : Method
        Fitted.
    table : AnswerTable
        Grows.
    timeout : float, optional
        Seconds that an answer may take; the first one of all, which may load things, ten times as many.
    """

    case: Case
    built: BuiltMethod
    method: Method
    table: AnswerTable
    timeout: float | None = None
    _worker: Worker | None = None
    _foreseen: deque[Image] = field(default_factory=deque)
    _next: int = 0
    """The first query that a foresighted method has not seen."""

    @contextmanager
    def ready(self, threads: int) -> Iterator[None]:
        """Ask inside the ``with`` block: the method is warm, and a sequential one has forgotten the warm-up."""
        worker: AbstractContextManager[Worker | None] = Worker(threads) if self.timeout else nullcontext()
        with worker as self._worker:
            with blaming(f"The method {self.built.id!r} failed while warming up"):
                self._warm_up()
                if is_sequential(self.method):
                    self.method.reset()  # type: ignore[attr-defined]
            yield

    def ask(self, query: int) -> None:
        """Ask one query, and note the answer, how long it took, and what was in the running on the way.

        Raises
        ------
        DataError
            If the image cannot be decoded.
        VprBenchError
            If the method raises, answers nonsense or takes too long; names the query.
        """
        start = time.perf_counter()
        image, ahead = self._decode(query)
        decoded = time.perf_counter() - start
        doing = f"The method {self.built.id!r} failed while answering {self.case.queries.name_of(query)}"
        with blaming(doing):
            match, seconds, noted = self._in_time(partial(_timed, self.method, ahead, image, self.table.k))
        self._refuse(fault_in(match, len(self.case.references), self.table.k), query)
        with blaming(doing):
            match = Match(match.indices, match.scores)  # again: arrays can be written to after they were checked
            shortlists = checked(noted, match, len(self.case.references))
        self._refuse(shortfall_in(match, self.method, len(self.case.references), self.table.k), query)
        self.table.add(query, match, {**seconds, "decode": decoded}, shortlists)

    def _warm_up(self) -> None:
        # A reference, not a query: a method that adapts to what it is shown must not see one twice.
        image = self.case.references[0]
        for patience in (_FIRST_PATIENCE, *[1.0] * (_WARM_UP - 1)):
            self._in_time(partial(self.method.match, image, self.table.k), patience)

    def _decode(self, query: int) -> tuple[Image, list[Image]]:
        """Decode a query and, for a foresighted method, the frames up to its horizon that it has not seen."""
        horizon = frames_ahead(self.method)
        if not horizon:
            return self.case.queries[query], []
        ahead = [self.case.queries[one] for one in range(self._next, min(query + horizon + 1, len(self.case.queries)))]
        self._next += len(ahead)
        self._foreseen.extend(ahead)
        return self._foreseen.popleft(), ahead

    def _in_time(self, function: Callable[[], T], patience: float = 1.0) -> T:
        if self._worker is None or self.timeout is None:
            return function()
        return self._worker.call(function, self.timeout * patience)

    def _refuse(self, fault: str, query: int) -> None:
        if fault:
            raise VprBenchError(
                f"The method {self.built.id!r} answered {self.case.queries.name_of(query)} with {fault}."
            )


def _timed(method: Method, ahead: list[Image], image: Image, k: int) -> tuple[Match, dict[str, float], Shortlists]:
    """Show a method what lies ahead and ask it; return the answer, the seconds of its stages, and its shortlists."""
    start = time.perf_counter()
    with collect_stages() as seconds:
        if isinstance(method, Foresighted):
            for frame in ahead:
                method.foresee(frame)
        with collect_shortlists() as shortlists:
            match = method.match(image, k)
    return match, {**seconds, "total": time.perf_counter() - start}, shortlists
