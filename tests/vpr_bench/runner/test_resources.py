import cv2
import numpy as np
import torch

from vpr_bench.runner.resources import PeakMemory, limit_threads


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
