"""Plug-ins by name: entry points of installed packages, ``module:Class`` or ``file.py:Class``, imported when used.

Our own datasets and methods come through the same door as everybody else's.
"""

import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, Generic, TypeVar

from vpr_bench.definition import Definition
from vpr_bench.errors import UsageError, closest
from vpr_bench.importing import import_object, is_file

T = TypeVar("T")

NOT_INSTALLED = "not installed"
"""Origin of what is named by ``module:Class`` or ``file.py:Class`` and comes from no package."""


class PluginWarning(UserWarning):
    """A third-party plug-in cannot be used; the others go on."""


@dataclass(frozen=True)
class Entry:
    """One plug-in, known by name and not yet imported.

    Attributes
    ----------
    name : str
        What it is called on the command line; of a ``file.py:Class``, without the folder.
    target : str
        ``module:attribute`` or ``/path/to/file.py:attribute``.
    origin : str
        The distribution that brings it, with its version; ``not installed`` for what comes from none.
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

    def definition(self) -> Definition | None:
        """Return what its source says, read without importing it; None if that cannot be found."""
        return Definition.find(self.target)

    def summary(self) -> str:
        """Return the first line of its docstring, read without importing it ('' if none)."""
        found = self.definition()
        return found.summary() if found else ""

    def parameters(self) -> dict[str, str]:
        """Return its constructor's parameters with their defaults, read without importing it."""
        found = self.definition()
        return found.parameters() if found else {}


class Registry(Generic[T]):
    """All plug-ins of one entry-point group.

    Parameters
    ----------
    group : str
        Entry-point group, for example ``vpr_bench.methods``.
    noun : str
        What one of them is called in messages.
    kind : type, optional
        What a plug-in must be an instance of; where it has an ``id``, that must be its name.
    find : callable, optional
        Where entry points come from; the installed packages by default.
    """

    def __init__(
        self,
        group: str,
        noun: str,
        kind: type[T] | None = None,
        find: Callable[..., Iterable[EntryPoint]] | None = None,
    ) -> None:
        self.group = group
        self.noun = noun
        self.kind = kind
        self._entry_points = find or entry_points

    @cached_property
    def _found(self) -> dict[str, list[Entry]]:
        found: dict[str, list[Entry]] = {}
        for point in self._entry_points(group=self.group):
            origin = f"{point.dist.name} {point.dist.version}" if point.dist else "unknown package"
            entry = Entry(point.name, f"{point.module}:{point.attr}", origin)
            same_name = found.setdefault(point.name, [])
            if entry not in same_name:  # one package can be found twice on the path
                same_name.append(entry)
        return found

    def __contains__(self, name: str) -> bool:
        return name in self._found

    def entries(self) -> list[Entry]:
        """Return every plug-in, sorted by name; a name that two packages claim is left out with a warning."""
        for name, claims in self._found.items():
            if len(claims) > 1:
                warnings.warn(self._duplicate(name, claims), PluginWarning, stacklevel=2)
        return [claims[0] for _, claims in sorted(self._found.items()) if len(claims) == 1]

    def entry(self, name: str) -> Entry:
        """Find one plug-in by name, or describe the object that ``module:Class`` or ``file.py:Class`` names.

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
        if is_file(name):
            raise UsageError(f"Which class of that file is the {self.noun}? Write {name}:Class.")
        module, colon, attribute = name.rpartition(":")
        if is_file(module) and attribute.isidentifier():
            file = Path(module).expanduser().absolute()
            return Entry(f"{file.name}:{attribute}", f"{file}:{attribute}", NOT_INSTALLED)
        if colon and all(part.isidentifier() for part in [*module.split("."), *attribute.split(".")]):
            return Entry(name, name, NOT_INSTALLED)
        raise UsageError(f"There is no {self.noun} {name!r}. {closest(name, self._found)}")

    def find(self, name: str) -> T:
        """Load one plug-in by its name.

        Raises
        ------
        UsageError
            If there is none of that name (the closest one is suggested), it cannot be imported, or it is not what it
            should be.
        """
        return self._loaded(self.entry(name))

    def load_all(self) -> dict[str, T]:
        """Load every plug-in; one that fails to load, or is not what it should be, becomes one warning."""
        loaded = {}
        for entry in self.entries():
            try:
                loaded[entry.name] = self._loaded(entry)
            except Exception as error:
                warnings.warn(f"Left out {self.noun} {entry.name!r}: {error}", PluginWarning, stacklevel=2)
        return loaded

    def _loaded(self, entry: Entry) -> T:
        found: T = entry.load()
        if self.kind is not None and not isinstance(found, self.kind):
            expected = f"{self.kind.__module__}.{self.kind.__qualname__}"
            raise UsageError(
                f"The {self.noun} {entry.name!r} must be a {expected}. Got {type(found).__name__} instead."
            )
        own = getattr(found, "id", entry.name)
        if own != entry.name:
            raise UsageError(f"The {self.noun} {entry.name!r} has the id {own!r}: both must be the same.")
        return found

    def _duplicate(self, name: str, claims: list[Entry]) -> str:
        owners = " and ".join(entry.origin for entry in claims)
        return f"The {self.noun} {name!r} is claimed by {owners}: uninstall one of them."
