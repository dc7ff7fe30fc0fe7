"""A batch of queries per step."""

from typing import Any

import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from vpr_bench.envs.exchange import Batch, Exchange, in_words
from vpr_bench.envs.picture import draw
from vpr_bench.envs.ranking import Action, Ranking
from vpr_bench.envs.single import RENDER_MODES, VprEnv
from vpr_bench.envs.task import Asking
from vpr_bench.errors import UsageError


class VprVectorEnv(Asking, VectorEnv[NDArray[np.uint8], Action, NDArray[Any]]):
    """As :class:`~vpr_bench.envs.single.VprEnv`, with ``num_envs`` queries of the one episode per step.

    Made by ``gymnasium.make_vec(id, num_envs=32)``. The queries come in the order in which the single environment of
    the same seed asks them. The last batch is filled up with black images: ``info["mask"]`` says which rows of the
    observation are queries. What is answered in the other rows does not matter, earns 0, and is not counted.

    As in all vector environments, ``info["_query"]`` says which rows of ``info["query"]`` hold something, and so on.
    All rows terminate together, when the last query has been asked.

    Parameters
    ----------
    dataset : str
        As in the single environment.
    num_envs : int
        Queries per step.
    autoreset_mode : {"NextStep", "Disabled"}
        What the step after the last one does: it begins the next episode, whatever the action, or is an error.
    **settings
        The others of the single environment, ``protocol`` and so on; what is rendered is a tuple with one picture or
        line per row.

    Raises
    ------
    UsageError
        If there is no such dataset, protocol or setting.
    DataError
        If images are missing or damaged.
    """

    def __init__(
        self,
        dataset: str,
        num_envs: int = 1,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        **settings: Any,
    ) -> None:
        if not isinstance(num_envs, int) or num_envs < 1:
            raise UsageError(f"num_envs must be a whole number of at least 1. Got {num_envs!r} instead.")
        self._mode = _autoreset(autoreset_mode)
        self.metadata = {"render_modes": RENDER_MODES, "render_fps": 2, "autoreset_mode": self._mode}
        row = VprEnv(dataset, **settings)
        self.task, self.num_envs, self.render_mode = row.task, num_envs, row.render_mode
        self.single_observation_space, self.single_action_space = row.observation_space, row.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space: Ranking = Ranking(len(self.references), self.k, num_envs)
        self._questions: NDArray[np.int64] | None = None
        self._asked, self._earned = 0, 0
        self._last: Batch | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.uint8], dict[str, Any]]:
        """Begin again with all queries; the rows share one episode and cannot be reset one by one."""
        if options and not np.all(options.get("reset_mask", True)):
            raise UsageError("All rows are of one episode: they can only be reset together.")
        super().reset(seed=seed)
        self._questions = self.task.questions(self.np_random)
        self._asked, self._earned, self._last = 0, 0, None
        return self._observe()

    def step(
        self, actions: Action
    ) -> tuple[NDArray[np.uint8], NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Answer the queries that are shown, and see the next ones.

        Raises
        ------
        gymnasium.error.InvalidAction
            If a row is not a valid answer; says why. The queries can be answered again.
        gymnasium.error.ResetNeeded
            If there is no query to answer.
        """
        asked = self._waiting()
        if not len(asked) and (self._questions is None or self._mode == AutoresetMode.DISABLED):
            raise ResetNeeded("There is no query to answer: call reset().")
        rewards, truncated = np.zeros(self.num_envs), np.zeros(self.num_envs, dtype=bool)
        if not len(asked):
            observation, info = self.reset()
        else:
            indices, scores = self.action_space.parse(actions, np.arange(self.num_envs) < len(asked))
            judged = self.task.judge(asked, indices)
            rewards[: len(asked)] = judged.reward
            self._last = Batch(asked, indices, scores, judged, self._asked, self._earned)
            self._asked, self._earned = self._asked + len(asked), self._earned + int(judged.reward.sum())
            observation, info = self._observe()
            answered = {"query": asked, "correct": judged.correct, "has_match": judged.has_match, "truth": judged.truth}
            for name, column in answered.items():
                info |= _padded(name, column, self.num_envs)
        return observation, rewards, np.full(self.num_envs, not len(self._waiting())), truncated, info

    def _observe(self) -> tuple[NDArray[np.uint8], dict[str, Any]]:
        waiting = self._waiting()
        info = _padded("size", self.task.frames.sizes[waiting], self.num_envs)
        return self.task.frames.batch(waiting, self.num_envs), {**info, "mask": info["_size"].copy()}

    def _waiting(self) -> NDArray[np.int64]:
        """Return the queries that are to be answered."""
        questions = np.empty(0, dtype=np.int64) if self._questions is None else self._questions
        return questions[self._asked : self._asked + self.num_envs]

    def render(self) -> Any:
        """Show each of the last answers, or the first queries while there is none, as ``render_mode`` says."""
        waiting: list[int | None] = [*self._waiting().tolist(), *[None] * self.num_envs][: self.num_envs]
        rows: list[Exchange | None] = [None] * self.num_envs
        if self._last is not None:
            last = [self._last.row(self.case, row) for row in range(len(self._last.queries))]
            rows[: len(last)], waiting = last, [None] * self.num_envs
        if self.render_mode == "ansi":
            return tuple(in_words(self.case, row) for row in rows)
        if self.render_mode == "rgb_array":
            shape = self.task.frames.shape
            return tuple(draw(self.case, shape, query, row) for query, row in zip(waiting, rows, strict=True))
        return None


def _padded(name: str, column: NDArray[Any], rows: int) -> dict[str, NDArray[Any]]:
    """Return a column of an info filled up to so many rows, and the one that says which hold something."""
    filled = np.zeros((rows, *column.shape[1:]), dtype=column.dtype)
    filled[: len(column)] = column
    return {name: filled, f"_{name}": np.arange(rows) < len(column)}


def _autoreset(mode: str | AutoresetMode) -> AutoresetMode:
    known = (AutoresetMode.NEXT_STEP, AutoresetMode.DISABLED)
    for one in known:
        if mode in (one, one.value):
            return one
    raise UsageError(f"autoreset_mode must be {' or '.join(one.value for one in known)}. Got {mode!r} instead.")
