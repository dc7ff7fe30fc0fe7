"""Checks of environments."""

from vpr_bench.check.env import episodes, interface
from vpr_bench.check.env.subject import EnvSubject
from vpr_bench.check.suite import Suite

ENV_CHECKS: Suite[EnvSubject] = Suite(interface.CHECKS, episodes.CHECKS)
"""All of them."""

__all__ = ["ENV_CHECKS", "EnvSubject"]
