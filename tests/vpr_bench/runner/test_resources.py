import subprocess
import sys
import time
from types import SimpleNamespace

import cv2
import numpy as np
import psutil
import pytest
import torch

from vpr_bench.runner import resources
from vpr_bench.runner.resources import Elsewhere, PeakMemory, limit_threads

BUSY = "import time\nend = time.process_time() + 0.3\nwhile time.process_time() < end: pass\nprint(flush=True)\ninput()"


def test_threads_are_limited_and_given_back():
    before = torch.get_num_threads(), cv2.getNumThreads()
    with limit_threads(1):
        assert (torch.get_num_threads(), cv2.getNumThreads()) == (1, 1)
    assert (torch.get_num_threads(), cv2.getNumThreads()) == before


def test_peak_sees_what_was_freed():
    with PeakMemory() as small:
        pass
    with PeakMemory() as large:
        block = np.ones(40_000_000)  # 320 MB, held longer than one look apart
        total = sum(float(block.sum()) for _ in range(5))
        del block
    assert total == 5 * 40_000_000
    assert large.bytes - small.bytes > 200_000_000


@pytest.fixture
def clocks(monkeypatch):
    """Set what the clocks show: seconds gone by times the cores, busy ones, and ours."""
    shown = []
    monkeypatch.setattr(resources, "_clocks", lambda: shown.pop(0))
    return shown


@pytest.mark.parametrize(
    ("gone", "busy", "ours", "share"),
    [
        (10.0, 4.0, 4.0, 0.0),  # nobody else
        (10.0, 4.0, 1.0, 0.3),
        (10.0, 4.0, 4.2, 0.0),  # clocks tick in steps: our own may be ahead
        (10.0, 10.5, 0.0, 1.0),
        (0.0, 0.0, 0.0, 0.0),
    ],
)
def test_what_is_not_ours_is_elsewhere(clocks, gone, busy, ours, share):
    clocks += [(100.0, 50.0, 7.0), (100.0 + gone, 50.0 + busy, 7.0 + ours)]
    with Elsewhere() as elsewhere:
        pass
    assert elsewhere.share == pytest.approx(share)


def test_nothing_has_gone_by_at_once():
    with Elsewhere() as elsewhere:
        pass
    assert 0 <= elsewhere.share <= 1


def test_real_clocks_run_on():
    before = resources._clocks()
    end = time.process_time() + 0.1
    while time.process_time() < end:
        pass
    after = resources._clocks()
    assert all(later >= earlier for earlier, later in zip(before, after, strict=True))
    assert after[2] - before[2] > 0.05


def test_children_are_ours_while_they_live_and_when_they_have_ended():
    before = resources._own_seconds()
    own = time.process_time()
    with subprocess.Popen([sys.executable, "-c", BUSY], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as child:
        child.stdout.readline()
        alive = resources._own_seconds()
        child.communicate(b"\n")
    ended = resources._own_seconds()
    own = time.process_time() - own
    assert alive - before - own > 0.2
    assert ended - before - own > 0.2


def test_guests_are_counted_once(monkeypatch):
    class Times(tuple):
        user, idle, iowait, guest, guest_nice = 50.0, 30.0, 5.0, 10.0, 0.0

    monkeypatch.setattr(psutil, "cpu_times", lambda: Times((50.0, 30.0, 5.0, 10.0, 0.0)))
    assert resources._clocks()[1] == 50.0


def test_a_child_that_ends_while_it_is_looked_at(monkeypatch):
    class Gone:
        def cpu_times(self):
            raise psutil.NoSuchProcess(1)

    times = SimpleNamespace(user=1.0, system=2.0, children_user=3.0, children_system=4.0)
    process = SimpleNamespace(cpu_times=lambda: times, children=lambda recursive: [Gone()])
    monkeypatch.setattr(psutil, "Process", lambda: process)
    assert resources._own_seconds() == 10.0
