"""Whatever a method does wrong, the run says who, where and what, keeps what was done, and can be continued."""

import threading
import time

import numpy as np
import pytest

from vpr_bench.errors import UsageError, VprBenchError
from vpr_bench.runner.run import RunOptions, run
from vpr_bench.runner.worker import AbandonedWarning
from vpr_bench.timing import stage
from vpr_bench.types.match import Match

GOOD = 3 + 5
"""Answers before the fault: the warm-up, and some that are to be kept."""


def hang():
    while True:
        time.sleep(0.001)


def fail(error):
    raise error


def spoilt():
    match = Match([0, 1], [2.0, 1.0])
    match.scores[0] = np.nan
    return match


def used_twice():
    match = Match([0, 1], [2.0, 1.0])
    match.indices[1] = 0
    return match


FAULTS = {
    "raises": (lambda: {}["gone"], "KeyError: 'gone'"),
    "exits": (lambda: fail(SystemExit(0)), "SystemExit: 0"),
    "out of memory": (lambda: fail(MemoryError("64 GiB")), "MemoryError: 64 GiB"),
    "two lines": (lambda: fail(RuntimeError("one\ntwo")), "RuntimeError: one two"),
    "NaN": (lambda: Match([0], [np.nan]), "ValueError: the scores of a match must be finite"),
    "infinite": (lambda: Match([0], [np.inf]), "ValueError: the scores of a match must be finite"),
    "NaN written later": (spoilt, "ValueError: the scores of a match must be finite"),
    "duplicates": (lambda: Match([1, 1], [2.0, 1.0]), "ValueError: the indices of a match must be unique"),
    "duplicates written later": (used_twice, "ValueError: the indices of a match must be unique"),
    "negative": (lambda: Match([-1], [1.0]), "ValueError: the indices of a match must be unique and not negative"),
    "fractions": (lambda: Match([0.5], [1.0]), "ValueError: the indices of a match must be integers"),
    "rising scores": (lambda: Match([0, 1], [1.0, 2.0]), "ValueError: the scores of a match must not increase"),
    "out of range": (lambda: Match([12], [1.0]), "reference 12 of a map of 12"),
    "too many": (lambda: Match(range(12), np.zeros(12)), "12 references where 3 were asked for"),
    "too few": (lambda: Match([0], [1.0]), "1 reference where 3 were asked for. If it is meant to, its class has to"),
    "none at all": (lambda: Match([], []), "no references where 3 were asked for"),
    "nothing": (lambda: None, "a NoneType instead of a Match"),
    "something else": (lambda: (np.arange(3), np.zeros(3)), "a tuple instead of a Match"),
    "hangs": (hang, "TimeoutError: no answer within 0.2 s"),
}


class Faulty:
    """Answers well until it does not."""

    def __init__(self, fault=None, good=GOOD):
        self.fault, self.good = fault, good

    def fit(self, references):
        self.colours_ = np.stack([image.mean(axis=(0, 1)) for image in references])

    def match(self, image, k):
        self.good -= 1
        if self.good < 0 and self.fault:
            return self.fault()
        with stage("encode"):
            colour = image.mean(axis=(0, 1))
        return Match.from_scores(-np.linalg.norm(self.colours_ - colour, axis=1), k)


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_named_and_costs_only_the_query(case, store, built, fault):
    answer, said = FAULTS[fault]
    options = RunOptions(k=3, timeout=0.2)
    with pytest.raises(VprBenchError) as caught:
        run(case, built(Faulty(answer)), store, options)
    message = str(caught.value)
    assert "'mean-colour'" in message and "winter[" in message and said in message
    assert message.count("\n") == 0 and caught.value.exit_code == 1
    assert not list(store.root.rglob("run.json"))

    healed = Faulty(good=0)
    stored = run(case, built(healed), store, options)
    assert -healed.good == 3 + len(case.queries) - 5  # the warm-up, and all but what was kept
    assert stored.indices[:, 0].tolist() == list(range(len(case.queries)))
    assert stored.record.resumed


@pytest.mark.parametrize("few", [Match([0], [1.0]), Match([], [])])
def test_who_declares_why_may_answer_fewer(case, store, built, few):
    class Picky(Faulty):
        may_answer_fewer = "only what is alike is an answer"

    stored = run(case, built(Picky(lambda: few)), store, RunOptions(k=3))
    assert sorted((stored.indices >= 0).sum(axis=1).tolist())[0] == len(few)


@pytest.mark.parametrize("error", [RuntimeError, TimeoutError, KeyError, SystemExit])
def test_a_fault_while_warming_up_is_named(case, store, built, error):
    with pytest.raises(VprBenchError, match=f"'mean-colour' failed while warming up: {error.__name__}"):
        run(case, built(Faulty(lambda: fail(error("no")), good=0)), store, RunOptions(timeout=5))


def test_who_never_answers_is_given_up_while_warming_up(case, store, built):
    with pytest.raises(VprBenchError, match=r"failed while warming up: TimeoutError: no answer within 0\.5 s"):
        run(case, built(Faulty(hang, good=0)), store, RunOptions(timeout=0.05))


def test_the_first_answer_may_take_longer_than_the_others(case, store, built):
    class SlowStart(Faulty):
        def match(self, image, k):
            time.sleep(0.2 if self.good == GOOD else 0)
            return super().match(image, k)

    assert run(case, built(SlowStart()), store, RunOptions(timeout=0.1)).record.timeout == 0.1


def test_a_time_limit_changes_no_answer_and_is_no_other_run(case, store, built):
    limited = run(case, built(Faulty()), store, RunOptions(timeout=5))
    assert {"encode", "decode", "total"} <= limited.seconds.keys()
    matches = (limited.folder / "matches.npz").read_bytes()
    free = run(case, built(Faulty()), store, RunOptions(overwrite="always"))
    assert free.folder == limited.folder
    assert (free.folder / "matches.npz").read_bytes() == matches
    assert free.record.timeout is None


@pytest.mark.parametrize("seconds", [0, -1, float("nan"), float("inf")])
def test_a_time_limit_must_be_positive(case, store, built, seconds):
    with pytest.raises(UsageError, match=f"time-out must be positive. Got {seconds}"):
        run(case, built(Faulty()), store, RunOptions(timeout=seconds))


def test_ctrl_c_while_a_thread_answers_is_ctrl_c(case, store, built):
    with pytest.raises(KeyboardInterrupt):
        run(case, built(Faulty(lambda: fail(KeyboardInterrupt()))), store, RunOptions(timeout=5))
    assert list(store.root.rglob("answers.npz"))


def test_no_thread_is_left(case, store, built):
    before = threading.active_count()
    run(case, built(Faulty()), store, RunOptions(timeout=5))
    with pytest.raises(VprBenchError, match="no answer within"):
        run(case, built(Faulty(hang)), store, RunOptions(timeout=0.1, seed=1))
    assert threading.active_count() == before


def test_who_cannot_be_stopped_is_left_behind_with_a_warning(case, store, built, monkeypatch):
    monkeypatch.setattr("vpr_bench.runner.worker._GRACE", 0.05)
    awake = threading.Event()
    with (
        pytest.warns(AbandonedWarning, match="left behind"),
        pytest.raises(VprBenchError, match=r"no answer within 0\.1 s"),
    ):
        run(case, built(Faulty(awake.wait)), store, RunOptions(timeout=0.1))
    awake.set()
