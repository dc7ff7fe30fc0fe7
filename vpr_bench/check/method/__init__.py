"""Checks of methods."""

from vpr_bench.check.method import answers, images, inputs, order, parameters, repeating, storage, surroundings
from vpr_bench.check.method.subject import MethodLike, Subject
from vpr_bench.check.suite import Suite

METHOD_CHECKS: Suite[Subject] = Suite(
    parameters.CHECKS,
    answers.CHECKS,
    images.CHECKS,
    inputs.CHECKS,
    repeating.CHECKS,
    order.CHECKS,
    storage.CHECKS,
    surroundings.CHECKS,
)
"""All of them."""

__all__ = ["METHOD_CHECKS", "MethodLike", "Subject"]
