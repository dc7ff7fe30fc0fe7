import contextlib
import threading
import time

import pytest

from vpr_bench.runner.worker import Worker
from vpr_bench.timing import collect_stages, stage


def test_it_returns_what_the_function_returns_in_one_thread():
    with Worker(1) as worker:
        threads = {worker.call(threading.get_ident, 5) for _ in range(3)}
    assert len(threads) == 1 and threading.get_ident() not in threads


def test_it_raises_what_the_function_raises_and_goes_on():
    with Worker(1) as worker:
        with pytest.raises(ZeroDivisionError):
            worker.call(lambda: 1 / 0, 5)
        assert worker.call(lambda: 7, 5) == 7


def test_stages_are_collected_across_the_threads():
    def work():
        with stage("encode"):
            pass

    with Worker(1) as worker, collect_stages() as seconds:
        worker.call(work, 5)
    assert "encode" in seconds


def test_libraries_are_held_to_the_threads():
    import torch

    with Worker(1) as worker:
        assert worker.call(torch.get_num_threads, 5) == 1


def test_a_method_cannot_catch_being_given_up():
    stopped = threading.Event()

    def stubborn():
        try:
            while True:
                with contextlib.suppress(Exception):
                    time.sleep(0.001)
        finally:
            stopped.set()

    with Worker(1) as worker, pytest.raises(TimeoutError, match=r"no answer within 0\.05 s"):
        worker.call(stubborn, 0.05)
    assert stopped.is_set()


def test_the_hand_over_is_short():
    with Worker(1) as worker:
        worker.call(int, 5)
        start = time.perf_counter()
        for _ in range(200):
            worker.call(int, 5)
    assert (time.perf_counter() - start) / 200 < 2e-3
