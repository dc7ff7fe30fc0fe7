"""Making the environments known to Gymnasium without importing it: it costs more than all of our own start-up.

Gymnasium has no entry points for environments. Whoever imports ``vpr_bench`` expects the ids to be there whether
Gymnasium was imported before or is imported later; in the second case they are registered at that moment.
"""

import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:  # all of these, of which some are not light, are only for annotations
    from collections.abc import Sequence
    from importlib.abc import Loader
    from importlib.machinery import ModuleSpec
    from types import ModuleType

_GYMNASIUM = "gymnasium"


def make_ids_known() -> None:
    """Register every environment now if Gymnasium has been imported, else as soon as it is."""
    if sys.modules.get(_GYMNASIUM) is not None:
        _register()
    elif not any(isinstance(finder, _Watch) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Watch())


def _register() -> None:
    from vpr_bench.envs.ids import register_all

    register_all()


class _Watch:
    """Notices the import of Gymnasium; the module is found and loaded as it would be without us."""

    def find_spec(
        self, name: str, path: "Sequence[str] | None", target: "ModuleType | None" = None
    ) -> "ModuleSpec | None":
        """Let the other finders find Gymnasium, and have its loader tell us when it is done."""
        if name != _GYMNASIUM:
            return None
        for finder in [finder for finder in sys.meta_path if finder is not self]:
            spec = finder.find_spec(name, path, target)
            if spec is not None:
                if spec.loader is not None:
                    spec.loader = cast("Loader", _ThenRegister(spec.loader, self))
                return spec
        return None


class _ThenRegister:
    """Loads a module with its own loader, and registers the environments when it is complete."""

    def __init__(self, loader: "Loader", watch: _Watch) -> None:
        self._loader = loader
        self._watch = watch

    def __getattr__(self, name: str) -> Any:
        return getattr(self._loader, name)  # for those who only look Gymnasium up

    def create_module(self, spec: "ModuleSpec") -> "ModuleType | None":
        """Create it as its own loader does."""
        return self._loader.create_module(spec)

    def exec_module(self, module: "ModuleType") -> None:
        """Load it; nothing of us is left on the module."""
        module.__loader__ = self._loader
        if module.__spec__ is not None:
            module.__spec__.loader = self._loader
        self._loader.exec_module(module)
        with suppress(ValueError):  # a second thread has been here
            sys.meta_path.remove(self._watch)
        _register()
