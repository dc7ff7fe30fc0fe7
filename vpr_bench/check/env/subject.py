"""The environment that is checked, made anew for every check."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import gymnasium

from vpr_bench.envs.ids import ANY, env_id
from vpr_bench.errors import UsageError, closest


@dataclass(frozen=True)
class EnvSubject:
    """An environment by its id.

    Attributes
    ----------
    id : str
        ``vpr_bench/Gardens-v0``.
    settings : mapping
        For ``gymnasium.make``.
    """

    id: str
    settings: Mapping[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, name: str, settings: Mapping[str, Any] | None = None) -> "EnvSubject":
        """Take an environment's id, or what names a dataset.

        Raises
        ------
        UsageError
            If there is no such id.
        """
        settings = dict(settings or {})
        known = [identifier for identifier in gymnasium.registry if identifier.startswith("vpr_bench/")]
        if name in known:
            return cls(name, settings)
        if "-v" in name and name.startswith("vpr_bench/"):
            raise UsageError(f"There is no environment {name!r}. {closest(name, known)}")
        own = env_id(name)
        return cls(own, settings) if own in known else cls(env_id(ANY), {"dataset": name, **settings})

    def make(self) -> gymnasium.Env[Any, Any]:
        """Make one."""
        return gymnasium.make(self.id, **self.settings)
