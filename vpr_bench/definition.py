"""What the source of a class or function says about it, read without importing anything."""

import ast
import importlib.util
import sys
from dataclasses import dataclass
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from typing import Any

from vpr_bench.importing import is_file


@dataclass(frozen=True)
class Definition:
    """A class or function as it is written.

    Attributes
    ----------
    node : ast.ClassDef or ast.FunctionDef
        Its own source.
    scope : ast.Module
        The module around it.
    module : str
        That module's name, or its file.
    """

    node: ast.ClassDef | ast.FunctionDef
    scope: ast.Module
    module: str

    @classmethod
    def find(cls, target: str) -> "Definition | None":
        """Find what ``module:attribute`` or ``file.py:attribute`` names; None if its source cannot be read."""
        module, _, attribute = target.rpartition(":")
        scope = _parsed(module)
        return cls._within(scope, module, attribute) if scope else None

    def summary(self) -> str:
        """Return the first line of the docstring, '' if there is none."""
        return (ast.get_docstring(self.node) or "").partition("\n")[0]

    def parameters(self) -> dict[str, str]:
        """Return the constructor's parameters with their defaults, inherited ones last."""
        if not isinstance(self.node, ast.ClassDef):
            return {}
        for part in self.node.body:
            if isinstance(part, ast.FunctionDef) and part.name == "__init__":
                arguments = [*part.args.args[1:], *part.args.kwonlyargs]
                required = len(part.args.args) - 1 - len(part.args.defaults)
                defaults = [None] * required + [*part.args.defaults, *part.args.kw_defaults]
                return {one.arg: _written(default) for one, default in zip(arguments, defaults, strict=True)}
        own = {name: _written(field.value) for name, field in self._annotated() if not _of_the_class(field)}
        inherited = [one for base in self._bases() for one in base.parameters().items() if one[0] not in own]
        return own | dict(inherited)

    def constant(self, name: str) -> Any:
        """Return the value of a class attribute that is written as a literal, its own or inherited, else None."""
        for written, field in self._annotated():
            if written == name and field.value is not None:
                try:
                    return ast.literal_eval(field.value)
                except ValueError:  # it is computed
                    return None
        return next((value for base in self._bases() if (value := base.constant(name)) is not None), None)

    def defines(self, method: str) -> bool:
        """Say whether a class has a method of that name, its own or inherited."""
        own = self.node.body if isinstance(self.node, ast.ClassDef) else []
        if any(isinstance(part, ast.FunctionDef) and part.name == method for part in own):
            return True
        return any(base.defines(method) for base in self._bases())

    def _annotated(self) -> list[tuple[str, ast.AnnAssign]]:
        body = self.node.body if isinstance(self.node, ast.ClassDef) else []
        return [(ast.unparse(part.target), part) for part in body if isinstance(part, ast.AnnAssign)]

    def _bases(self) -> list["Definition"]:
        """Return the base classes whose source can be found: those of the same module or imported by name."""
        names = [base.id for base in getattr(self.node, "bases", ()) if isinstance(base, ast.Name)]
        found = [self._within(self.scope, self.module, name) or self._imported(name) for name in names]
        return [base for base in found if base is not None]

    def _imported(self, name: str) -> "Definition | None":
        for part in self.scope.body:
            if isinstance(part, ast.ImportFrom) and part.level == 0 and part.module:
                for alias in part.names:
                    if (alias.asname or alias.name) == name:
                        return Definition.find(f"{part.module}:{alias.name}")
        return None

    @classmethod
    def _within(cls, scope: ast.Module, module: str, name: str) -> "Definition | None":
        for node in scope.body:
            if isinstance(node, ast.ClassDef | ast.FunctionDef) and node.name == name:
                return cls(node, scope, module)
        return None


def _parsed(module: str) -> ast.Module | None:
    if module.partition(".")[0] in sys.stdlib_module_names:  # nothing to say about parameters, and long to read
        return None
    try:
        spec = None if is_file(module) else _spec(module)
        source = module if is_file(module) else spec and spec.origin
        return ast.parse(Path(source).read_text("utf-8")) if source else None
    except Exception:  # finders are foreign code, and a file may hold anything
        return None


def _spec(module: str) -> ModuleSpec | None:
    """Find a module without running its packages, which importlib.util.find_spec does."""
    top, *inner = module.split(".")
    spec, name = importlib.util.find_spec(top), top
    for part in inner:
        name = f"{name}.{part}"
        spec = PathFinder.find_spec(name, spec.submodule_search_locations) if spec else None
    return spec


def _of_the_class(field: ast.AnnAssign) -> bool:
    return ast.unparse(field.annotation).startswith("ClassVar")


def _written(default: ast.expr | None) -> str:
    return "required" if default is None else ast.unparse(default)
