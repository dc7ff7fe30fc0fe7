"""Importing an object by ``module:attribute`` or ``path/to/file.py:attribute``, and saying where it went wrong."""

import hashlib
import importlib
import importlib.util
import sys
import traceback
from pathlib import Path
from types import ModuleType
from typing import Any

from vpr_bench.errors import UsageError, VprBenchError, closest, error_in_words, one_line
from vpr_bench.garbage import no_collections


def is_file(module: str) -> bool:
    """Say whether what stands before the colon is a Python file and not a module.

    Examples
    --------
    >>> is_file("methods/mine.py"), is_file("package.module")
    (True, False)
    """
    return module.endswith(".py")


def import_object(target: str, called: str) -> Any:
    """Import what ``module:attribute`` or ``path/to/file.py:attribute`` names.

    Raises
    ------
    UsageError
        If that is not possible; ``called`` is what the message names.
    """
    module, _, attribute = target.rpartition(":") if ":" in target else (target, "", "")
    try:
        with no_collections():
            loaded: Any = _import_file(Path(module)) if is_file(module) else importlib.import_module(module)
        for part in attribute.split("."):
            loaded = _part(loaded, part)
    except (Exception, SystemExit) as error:  # a plug-in that exits must not pass for a good end
        if isinstance(error, SyntaxError):  # without the place, which is said before it
            reason = f"{type(error).__name__}: {one_line(error.msg)}"
        else:
            reason = one_line(error) if isinstance(error, VprBenchError) else error_in_words(error)
        raise UsageError(f"{called} cannot be loaded from {target}: {_where(error)}{reason}") from error
    return loaded


def _part(whole: Any, name: str) -> Any:
    if isinstance(whole, ModuleType) and not hasattr(whole, name):
        raise UsageError(f"there is no {name!r} in it. {closest(name, _public(whole))}")
    return getattr(whole, name)


def _import_file(file: Path) -> ModuleType:
    """Import a file that belongs to no package; it can import what lies beside it.

    An edited file is another module: its classes are not those of before.
    """
    try:
        source = file.read_bytes()
    except OSError as error:
        raise UsageError(f"there is no such file ({error.strerror})") from None
    # No other module can be called so, and pickling and type hints find the module by its name.
    name = f"{file.stem.replace('.', '_')}@{hashlib.sha256(bytes(file) + source).hexdigest()[:12]}"
    if name in sys.modules:
        return sys.modules[name]
    if str(file.parent) not in sys.path:  # last: a helper of the same name must not replace an installed module
        sys.path.append(str(file.parent))
    module = ModuleType(name)
    module.__file__ = str(file)
    sys.modules[name] = module
    try:
        exec(compile(source, file, "exec"), vars(module))  # noqa: S102 - the user asked for this file
    except BaseException:
        del sys.modules[name]
        raise
    return module


def _public(module: ModuleType) -> list[str]:
    """Return the classes and functions that a module itself defines."""
    found = vars(module).items()
    return [name for name, value in found if getattr(value, "__module__", None) == module.__name__ and name[0] != "_"]


def _where(error: BaseException) -> str:
    """Say in which line of foreign code an error arose, '' if none was run."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{Path(error.filename).name}, line {error.lineno}: "
    raised = traceback.extract_tb(error.__traceback__)
    frames = [frame for frame in raised if frame.filename != __file__ and "importlib" not in frame.filename]
    return f"{Path(frames[-1].filename).name}, line {frames[-1].lineno}: " if frames else ""
