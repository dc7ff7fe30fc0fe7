"""Checks of datasets."""

from vpr_bench.check.dataset import cards, contents
from vpr_bench.check.dataset.subject import DatasetSubject
from vpr_bench.check.suite import Suite

DATASET_CHECKS: Suite[DatasetSubject] = Suite(cards.CHECKS, contents.CHECKS)
"""All of them."""

__all__ = ["DATASET_CHECKS", "DatasetSubject"]
