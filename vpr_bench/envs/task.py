"""What the single and the vector environment share: the queries, the map, and what the answers are compared with."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, Self, get_args

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case, load_case
from vpr_bench.envs.frames import Frames, resized
from vpr_bench.envs.judge import Judge
from vpr_bench.errors import UsageError, closest
from vpr_bench.types.protocol import Protocol, Unmatched
from vpr_bench.types.traverse import Traverse

Order = Literal["shuffled", "sequential"]

DEFAULT_K = 20
"""Places per answer, as in a run."""


@dataclass(frozen=True, eq=False)
class Task:
    """A protocol to be answered.

    Attributes
    ----------
    case : Case
        Images and places.
    k : int
        Places per answer.
    order : {"shuffled", "sequential"}
        How queries follow each other.
    frames : Frames
        The queries as observations.
    """

    case: Case
    k: int
    order: Order
    frames: Frames

    @cached_property
    def judge(self) -> Judge:
        """What knows which answers are right; made for the first one, as finding neighbours takes its time."""
        return Judge(self.case.ground_truth, self.case.protocol.unmatched)

    @classmethod
    def load(
        cls,
        dataset: str,
        protocol: str | None,
        edition: str,
        radius: float | None,
        unmatched: Unmatched | None,
        k: int | None,
        order: Order,
        size: Sequence[int] | None,
        in_memory: bool,
    ) -> Self:
        """Load it; the parameters are those of :class:`~vpr_bench.envs.single.VprEnv`."""
        for name, value in {"dataset": dataset, "protocol": protocol or "", "edition": edition}.items():
            if not isinstance(value, str):
                raise UsageError(f"{name} must be text, so that it can stand in a spec. Got {value!r} instead.")
        case = load_case(dataset, protocol, edition, radius, unmatched)
        return cls.of(case, k, order, size, in_memory)

    @classmethod
    def of(
        cls,
        case: Case,
        k: int | None = None,
        order: Order = "shuffled",
        size: Sequence[int] | None = None,
        in_memory: bool = False,
    ) -> Self:
        """Take a case that is loaded already.

        Raises
        ------
        UsageError
            If ``k``, the order or the size is none.
        DataError
            If there are no queries or references, or the size of an image cannot be read.
        """
        if order not in get_args(Order):
            raise UsageError(f"There is no order {order!r}. {closest(str(order), get_args(Order))}")
        places = len(case.references)
        k = min(DEFAULT_K, places) if k is None else k
        if isinstance(k, bool) or not isinstance(k, int | np.integer) or not 1 <= k <= places:
            raise UsageError(f"k must lie between 1 and {places}, the number of references. Got {k!r} instead.")
        if size is not None:
            case = replace(case, references=resized(case.references, size), queries=resized(case.queries, size))
        return cls(case, int(k), order, Frames(case.queries, in_memory=in_memory))

    def questions(self, generator: np.random.Generator) -> NDArray[np.int64]:
        """Return the queries of one episode in the order in which they are asked.

        A run of the same seed asks in the same order, as Gymnasium makes its generators as NumPy does.
        """
        asked = len(self.case.queries)
        return generator.permutation(asked) if self.order == "shuffled" else np.arange(asked)


class Asking:
    """What an environment tells about its task to those who set it up; an agent sees observations and infos only."""

    task: Task

    @property
    def references(self) -> Traverse:
        """The map, for agents to learn."""
        return self.task.case.references

    @property
    def protocol(self) -> Protocol:
        """What the numbers are for."""
        return self.task.case.protocol

    @property
    def case(self) -> Case:
        """Images with their places, for those who compute metrics."""
        return self.task.case

    @property
    def k(self) -> int:
        """Places per answer."""
        return self.task.k
