"""The method that is checked, made anew for every check."""

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import ModuleType
from typing import Any, TypeAlias

from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.world import ANSWERS, usual_map, usual_queries
from vpr_bench.check.outcome import Failed
from vpr_bench.errors import UsageError
from vpr_bench.method.build import BuiltMethod, build_method
from vpr_bench.method.interfaces import Method
from vpr_bench.types.match import Match

MethodLike: TypeAlias = str | type[Any] | Callable[[], Method] | tuple[str | type[Any], Mapping[str, Any]]
"""A name as on the command line, a class, a function that makes a new one each time, or one of the first two with its
parameters."""

_LOCAL = "vpr_bench_checked_"


@dataclass(eq=False)
class Subject:
    """A method under test.

    Attributes
    ----------
    id : str
        What to call it.
    name : str, optional
        What the harness makes it by; None if a function makes it.
    parameters : mapping
        Given to the constructor.
    factory : callable, optional
        That function.
    seed : int
        For methods that take one.
    """

    id: str
    name: str | None = None
    parameters: Mapping[str, Any] = field(default_factory=dict)
    factory: Callable[[], Method] | None = None
    seed: int = 0

    @classmethod
    def of(cls, what: MethodLike, seed: int = 0) -> "Subject":
        """Take a name, a class, a function that makes a new method, or one of the first two with its parameters.

        Raises
        ------
        UsageError
            If it is something else.
        """
        what, parameters = what if isinstance(what, tuple) else (what, {})
        told = ",".join(f"{key}={value}" for key, value in parameters.items())
        suffix = f"({told})" if told else ""
        if isinstance(what, str):
            return cls(what + suffix, what, parameters, seed=seed)
        called = getattr(what, "__name__", type(what).__name__)
        if isinstance(what, type):
            return cls(called + suffix, _importable(what), parameters, seed=seed)
        if not callable(what) or parameters or hasattr(what, "fit"):
            raise UsageError(f"A method is checked by its name, its class or a function that makes it. Got {what!r}.")
        return cls(called, factory=what, seed=seed)

    def build(self) -> BuiltMethod | None:
        """Make a new one with everything that identifies it; None if a function makes it."""
        return None if self.name is None else build_method(self.name, self.parameters, self.seed)

    def make(self) -> Method:
        """Make a new one, not fitted.

        Raises
        ------
        Failed
            If its function does not make new methods.
        """
        built = self.build()
        if built is not None:
            return built.method
        assert self.factory is not None  # noqa: S101
        made, other = self.factory(), self.factory()
        if made is other or not isinstance(made, Method):
            raise Failed(f"{self.id} must make a new method each time it is called. Got {type(made).__name__}.")
        return made

    @cached_property
    def expected_failures(self) -> Mapping[str, str]:
        """Which checks the method says that it fails, and why."""
        return _declared(self._one)

    @cached_property
    def excused_failures(self) -> Mapping[str, str]:
        """Which checks the methods inside it say that they fail: it may fail them too, or make up for it."""
        held = getattr(self._one, "__dict__", {}).values()
        return {
            check: f"{reason} (the method inside)"
            for method in held
            if isinstance(method, Method)
            for check, reason in _declared(method).items()
            if check not in self.expected_failures
        }

    @cached_property
    def _one(self) -> Method | None:
        try:
            return self.make()
        except Exception:  # that it cannot be made is what its checks will say
            return None

    @cached_property
    def usual_answers(self) -> list[Match]:
        """What a new one answers to the usual queries on the usual map; kept, as fitting takes its time."""
        method = self.make()
        fit(method, usual_map())
        return ask(method, usual_queries(), ANSWERS)


def _declared(method: Any) -> Mapping[str, str]:
    declared: Mapping[str, str] = getattr(method, "expected_failures", {})
    return declared


def _importable(method: type) -> str:
    """Return ``module:Class``; a class that no module holds, as one made by a function, is put into one of its own."""
    module, name = method.__module__, method.__qualname__
    writable = all(part.isidentifier() for part in [*module.split("."), name])
    if writable and getattr(sys.modules.get(module), name, None) is method:
        return f"{module}:{name}"
    holder = ModuleType(f"{_LOCAL}{id(method):x}")
    setattr(holder, method.__name__, method)
    sys.modules[holder.__name__] = holder
    return f"{holder.__name__}:{method.__name__}"
