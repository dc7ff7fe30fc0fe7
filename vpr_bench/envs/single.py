"""One query per step."""

from collections.abc import Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box
from numpy.typing import NDArray

from vpr_bench.envs.exchange import Batch, in_words
from vpr_bench.envs.picture import draw
from vpr_bench.envs.ranking import Action, Ranking
from vpr_bench.envs.task import Asking, Order, Task
from vpr_bench.errors import UsageError
from vpr_bench.types.protocol import Unmatched

RENDER_MODES = ["rgb_array", "ansi"]


class VprEnv(Asking, gymnasium.Env[NDArray[np.uint8], Action]):
    """Every query of a protocol is shown once; the action is a ranked list of references with scores.

    The observation is the query image. The reward is 1 if the first reference lies within the radius, else 0; soft
    matches are passed over, and where queries without a true match are to be rejected, answering nothing to one of
    them earns 1 too. The episode ends when all queries have been asked: its mean reward is the metric ``accuracy``,
    over all queries.

    Before an answer nothing tells which query it is or how many there were: in many datasets that gives the place
    away. After it, ``info`` holds

    - ``query``: index of the query that was answered;
    - ``correct``, ``has_match``: bool;
    - ``truth``: (m,) int64, the references that are right, padded with -1 to the most that any query has;

    and always ``size``: (2,) int64, height and width of the image that is shown. Images of mixed sizes stand in the
    upper left corner of the observation, the rest of which is black. After the last answer it is all black.

    Parameters
    ----------
    dataset : str
        Dataset id, also with edition, a whole protocol id, or a folder of one's own.
    protocol, edition, radius, unmatched
        As in :func:`vpr_bench.load_case`.
    k : int, optional
        Places per answer; by default 20, or the whole map.
    order : {"shuffled", "sequential"}
        ``shuffled`` is seeded by ``reset``; a run of the same seed asks in the same order. ``sequential`` is for
        agents that need the sequence.
    size : (int, int), optional
        Height and width to which queries and references are stretched; by default images stay as they are.
    in_memory : bool
        Keep decoded queries, for more than one episode.
    render_mode : {"rgb_array", "ansi"}, optional
        A picture of the last query beside its answer and the truth, or one line of text.

    Raises
    ------
    UsageError
        If there is no such dataset, protocol or setting.
    DataError
        If images are missing or damaged.
    """

    metadata = {"render_modes": RENDER_MODES, "render_fps": 2}  # noqa: RUF012 - as Gymnasium declares it

    def __init__(
        self,
        dataset: str,
        protocol: str | None = None,
        edition: str = "auto",
        radius: float | None = None,
        unmatched: Unmatched | None = None,
        k: int | None = None,
        order: Order = "shuffled",
        size: Sequence[int] | None = None,
        in_memory: bool = False,
        render_mode: str | None = None,
    ) -> None:
        if render_mode not in (None, *RENDER_MODES):
            raise UsageError(f"render_mode must be {' or '.join(RENDER_MODES)}. Got {render_mode!r} instead.")
        self.task = Task.load(dataset, protocol, edition, radius, unmatched, k, order, size, in_memory)
        self.render_mode = render_mode
        self.observation_space = Box(0, 255, self.task.frames.shape, np.uint8)
        self.action_space: Ranking = Ranking(len(self.task.case.references), self.task.k)
        self._questions: NDArray[np.int64] | None = None
        self._asked, self._earned = 0, 0
        self._last: Batch | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.uint8], dict[str, Any]]:
        """Begin again with all queries; there are no options."""
        super().reset(seed=seed)
        self._questions = self.task.questions(self.np_random)
        self._asked, self._earned, self._last = 0, 0, None
        return self._observe()

    def step(self, action: Action) -> tuple[NDArray[np.uint8], float, bool, bool, dict[str, Any]]:
        """Answer the query that is shown, and see the next one.

        Raises
        ------
        gymnasium.error.InvalidAction
            If it is not a valid answer; says why. The query can be answered again.
        gymnasium.error.ResetNeeded
            If there is no query to answer.
        """
        waiting = self._waiting()
        if waiting is None:
            raise ResetNeeded("There is no query to answer: call reset().")
        indices, scores = self.action_space.parse(action)
        query = np.array([waiting])
        judged = self.task.judge(query, indices)
        reward = float(judged.reward[0])
        self._last = Batch(query, indices, scores, judged, self._asked, self._earned)
        self._asked, self._earned = self._asked + 1, self._earned + int(reward)
        observation, info = self._observe()
        info |= {
            "query": waiting,
            "correct": bool(judged.correct[0]),
            "has_match": bool(judged.has_match[0]),
            "truth": judged.truth[0],
        }
        return observation, reward, self._waiting() is None, False, info

    def _observe(self) -> tuple[NDArray[np.uint8], dict[str, Any]]:
        waiting = self._waiting()
        if waiting is None:
            return np.zeros(self.task.frames.shape, dtype=np.uint8), {"size": np.zeros(2, dtype=np.int64)}
        return self.task.frames[waiting], {"size": self.task.frames.sizes[waiting].copy()}

    def _waiting(self) -> int | None:
        """Return the query that is to be answered, None if there is none."""
        if self._questions is None or self._asked == len(self._questions):
            return None
        return int(self._questions[self._asked])

    def render(self) -> Any:
        """Show the last answer, or the first query while there is none, as ``render_mode`` says."""
        answered = None if self._last is None else self._last.row(self.case, 0)
        if self.render_mode == "ansi":
            return in_words(self.case, answered)
        if self.render_mode == "rgb_array":
            return draw(self.case, self.task.frames.shape, self._waiting() if answered is None else None, answered)
        return None
