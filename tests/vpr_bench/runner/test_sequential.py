import json
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
import pytest

from vpr_bench.errors import UsageError
from vpr_bench.runner.record import RunKey, read_record
from vpr_bench.runner.run import RunOptions, run, run_key
from vpr_bench.types.match import Match


@dataclass
class Follower:
    """Answers with what it was shown since the last reset, as far as ``k`` goes; finds places by their colour."""

    sequential: ClassVar[bool] = True
    may_answer_fewer: ClassVar[str] = "only what was shown is an answer"

    fail_at: int | None = None
    shown: list[int] = field(default_factory=list)
    resets: int = 0

    def fit(self, references):
        self.colours_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def reset(self):
        self.shown.clear()
        self.resets += 1

    def match(self, image, k):
        if len(self.shown) == self.fail_at:
            raise KeyboardInterrupt
        self.shown.append(self.place(image))
        latest_first = list(dict.fromkeys(self.shown[::-1]))  # unique: the warm-up shows one image three times
        return Match(latest_first, np.zeros(len(latest_first)))

    def place(self, image):
        return int(np.linalg.norm(self.colours_ - image.mean(axis=(0, 1)), axis=1).argmin())

    def save(self, folder):
        np.save(folder / "colours.npy", self.colours_)

    def load(self, folder):
        self.colours_ = np.load(folder / "colours.npy")
        return self


@dataclass
class Foreseer(Follower):
    """Answers with the frames that it was shown and has not answered."""

    future: int = 2
    ahead: list[int] = field(default_factory=list)

    def reset(self):
        super().reset()
        self.ahead.clear()

    def foresee(self, image):
        self.ahead.append(self.place(image))

    def match(self, image, k):
        if not self.ahead:
            self.foresee(image)
        answer = Match(self.ahead, np.zeros(len(self.ahead)))
        assert self.place(image) == self.ahead.pop(0)
        return answer


def answers(stored):
    return [row[row >= 0].tolist() for row in stored.indices]


def test_queries_come_in_their_order_after_a_reset(case, store, built):
    method = Follower()
    stored = run(case, built(method), store)
    assert answers(stored) == [list(range(query, -1, -1)) for query in range(len(case.queries))]
    assert stored.record.order == "sequential"
    assert method.resets == 1  # after the warm-up: nothing of it is left


def test_the_record_says_that_others_are_shuffled(case, store, built, mean_colour):
    assert run(case, built(mean_colour()), store).record.order == "shuffled"


def test_to_say_no_is_to_be_shuffled(case, store, built):
    method = Follower()
    method.sequential = False
    stored = run(case, built(method), store)
    assert stored.record.order == "shuffled"
    assert method.shown[3:] != sorted(method.shown[3:])


def test_a_limit_takes_the_first_in_order(case, store, built):
    stored = run(case, built(Follower()), store, RunOptions(limit=4))
    assert stored.queries.tolist() == [0, 1, 2, 3]
    assert stored.record.partial


def test_an_interrupted_run_begins_again_and_keeps_its_map(case, store, built, monkeypatch):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(Follower(fail_at=7)), store)
    monkeypatch.setattr(Follower, "fit", lambda *_: pytest.fail("fitted again"))
    stored = run(case, built(Follower()), store)
    assert answers(stored) == [list(range(query, -1, -1)) for query in range(len(case.queries))]
    assert stored.record.resumed


@pytest.mark.parametrize("limit", [None, 5])
def test_frames_ahead_are_shown_once_and_in_order(case, store, built, limit):
    stored = run(case, built(Foreseer()), store, RunOptions(limit=limit))
    last = len(case.queries)
    asked = range(limit or last)
    assert answers(stored) == [list(range(query, min(query + 3, last))) for query in asked]
    assert stored.record.future == 2
    assert (stored.seconds["total"] > 0).all()
    assert (stored.seconds["decode"] > 0)[: last - 2].all()


def test_no_frame_ahead_is_none(case, store, built):
    assert answers(run(case, built(Foreseer(future=0)), store)) == [[query] for query in range(len(case.queries))]


def test_frames_ahead_are_for_those_that_are_sequential(case, store, built):
    method = Foreseer()
    method.sequential = False
    assert run(case, built(method), store).record.future == 0


def test_who_cannot_be_reset_is_refused(case, store, built):
    class Stuck:
        sequential = True

        def fit(self, references): ...

        def match(self, image, k): ...

    with pytest.raises(UsageError, match=r"'mean-colour' cannot be run: it is sequential and has no reset\(\)"):
        run(case, built(Stuck()), store)


def test_a_reset_that_fails_is_named(case, store, built, monkeypatch):
    monkeypatch.setattr(Follower, "reset", lambda self: 1 / 0)
    with pytest.raises(Exception, match="'mean-colour' failed while warming up: ZeroDivisionError"):
        run(case, built(Follower()), store)


def test_a_map_that_cannot_be_kept_is_fitted_again(case, store, built, monkeypatch):
    def refuse(self, folder):
        raise NotImplementedError

    monkeypatch.setattr(Follower, "save", refuse)
    with pytest.raises(KeyboardInterrupt):
        run(case, built(Follower(fail_at=3)), store)
    assert len(run(case, built(Follower()), store).queries) == len(case.queries)


def test_records_of_former_versions_are_read(case, store, built, mean_colour):
    path = run(case, built(mean_colour()), store).folder / "run.json"
    written = json.loads(path.read_text())
    for name in ("order", "future", "timeout"):
        del written[name]
    path.write_text(json.dumps(written))
    record = read_record(path)
    assert (record.order, record.future, record.timeout) == ("shuffled", 0, None)


def test_keys_are_those_of_former_versions(case, built, mean_colour):
    """Runs that are stored are found again; the digest was written down before sequence methods existed."""
    key = run_key(case, built(mean_colour(), size=3), RunOptions(threads=2, timeout=5))
    assert key.digest() == "8a72a85654ff"
    assert RunKey.model_validate(key.model_dump()) == key
