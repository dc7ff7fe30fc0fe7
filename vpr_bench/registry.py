"""Plug-ins by name: entry points of installed packages, or ``module:Class``, imported when they are used.

Our own datasets and methods come through the same door as everybody else's.
"""

import ast
import importlib
import importlib.util
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, Generic, TypeVar

from vpr_bench.errors import UsageError, blaming, closest

T = TypeVar("T")


def import_object(target: str, called: str) -> Any:
    """Import what ``module:attribute`` names.

    Raises
    ------
    UsageError
        If that is not possible; ``called`` is what the message names.
    """
    module, _, attribute = target.partition(":")
    with blaming(f"{called} cannot be loaded from {target}", UsageError):
        loaded: Any = importlib.import_module(module)
        for part in attribute.split("."):
            loaded = getattr(loaded, part)
    return loaded


NOT_INSTALLED = "not installed"
"""Origin of what is named by ``module:Class`` and comes from no package."""


class PluginWarning(UserWarning):
    """A third-party plug-in cannot be used; the others go on."""


@dataclass(frozen=True)
class Entry:
    """One plug-in, known by name and not yet imported.

    Attributes
    ----------
    name : str
        What it is called on the command line.
    target : str
        ``module:attribute``.
    origin : str
        The distribution that brings it, with its version; ``not installed`` for a bare ``module:Class``.
    """

    name: str
    target: str
    origin: str

    def load(self) -> Any:
        """Import the object.

        Raises
        ------
        UsageError
            If the module cannot be imported or has no such attribute; says why.
        """
        return import_object(self.target, f"{self.name!r} ({self.origin})")

    def summary(self) -> str:
        """Return the first line of the docstring, read from the source without importing it ('' if none)."""
        node = self._definition()
        return (ast.get_docstring(node) or "").partition("\n")[0] if node else ""

    def parameters(self) -> dict[str, str]:
        """Return the constructor's parameters with their defaults, read from the source without importing it."""
        node = self._definition()
        body = node.body if isinstance(node, ast.ClassDef) else []
        for part in body:
            if isinstance(part, ast.FunctionDef) and part.name == "__init__":
                arguments = [*part.args.args[1:], *part.args.kwonlyargs]
                required = len(part.args.args) - 1 - len(part.args.defaults)
                defaults = [None] * required + [*part.args.defaults, *part.args.kw_defaults]
                return {one.arg: _written(default) for one, default in zip(arguments, defaults, strict=True)}
        fields = (part for part in body if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name))
        return {
            ast.unparse(field.target): _written(field.value)
            for field in fields
            if not ast.unparse(field.annotation).startswith("ClassVar")
        }

    def _definition(self) -> ast.ClassDef | ast.FunctionDef | None:
        module_name, _, attribute = self.target.partition(":")
        try:
            spec = importlib.util.find_spec(module_name)
            tree = ast.parse(Path(spec.origin).read_text("utf-8")) if spec and spec.origin else None
        except Exception:  # finding a module runs its package's __init__, which may raise anything
            return None
        for node in tree.body if tree else []:
            if isinstance(node, ast.ClassDef | ast.FunctionDef) and node.name == attribute:
                return node
        return None


def _written(default: ast.expr | None) -> str:
    return "required" if default is None else ast.unparse(default)


class Registry(Generic[T]):
    """All plug-ins of one entry-point group.

    Parameters
    ----------
    group : str
        Entry-point group, for example ``vpr_bench.methods``.
    noun : str
        What one of them is called in messages.
    find : callable, optional
        Where entry points come from; the installed packages by default.
    """

    def __init__(self, group: str, noun: str, find: Callable[..., Iterable[EntryPoint]] | None = None) -> None:
        self.group = group
        self.noun = noun
        self._find = find or entry_points

    @cached_property
    def _found(self) -> dict[str, list[Entry]]:
        found: dict[str, list[Entry]] = {}
        for point in self._find(group=self.group):
            origin = f"{point.dist.name} {point.dist.version}" if point.dist else "unknown package"
            entry = Entry(point.name, f"{point.module}:{point.attr}", origin)
            same_name = found.setdefault(point.name, [])
            if entry not in same_name:  # one package can be found twice on the path
                same_name.append(entry)
        return found

    def entries(self) -> list[Entry]:
        """Return every plug-in, sorted by name; a name that two packages claim is left out with a warning."""
        for name, claims in self._found.items():
            if len(claims) > 1:
                warnings.warn(self._duplicate(name, claims), PluginWarning, stacklevel=2)
        return [claims[0] for _, claims in sorted(self._found.items()) if len(claims) == 1]

    def entry(self, name: str) -> Entry:
        """Find one plug-in by name, or describe the object that ``module:Class`` names.

        Raises
        ------
        UsageError
            If there is none of that name (the closest one is suggested), or two packages claim it.
        """
        claims = self._found.get(name, [])
        if len(claims) == 1:
            return claims[0]
        if claims:
            raise UsageError(self._duplicate(name, claims))
        module, colon, attribute = name.partition(":")
        if colon and all(part.isidentifier() for part in [*module.split("."), *attribute.split(".")]):
            return Entry(name, name, NOT_INSTALLED)
        raise UsageError(f"There is no {self.noun} {name!r}. {closest(name, self._found)}")

    def load_all(self, check: Callable[[Any], T]) -> dict[str, T]:
        """Load every plug-in; one that fails to load or to pass ``check`` becomes one warning."""
        loaded = {}
        for entry in self.entries():
            try:
                loaded[entry.name] = check(entry.load())
            except Exception as error:
                warnings.warn(f"Left out {self.noun} {entry.name!r}: {error}", PluginWarning, stacklevel=2)
        return loaded

    def _duplicate(self, name: str, claims: list[Entry]) -> str:
        owners = " and ".join(entry.origin for entry in claims)
        return f"The {self.noun} {name!r} is claimed by {owners}: uninstall one of them."
