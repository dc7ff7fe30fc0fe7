"""Which version of a method answered: what it declares, else a digest of its source."""

import ast
import hashlib
import sys
from pathlib import Path
from typing import Any

from vpr_bench.errors import UsageError
from vpr_bench.registry import NOT_INSTALLED, Entry


def version_of(entry: Entry, factory: Any) -> str:
    """Return a method's version, so that edited code is not taken for the same.

    Parameters
    ----------
    entry : Entry
        Where the method comes from.
    factory : class
        It, loaded.

    Raises
    ------
    UsageError
        If it declares no version, and its source cannot be found.
    """
    declared = getattr(factory, "version", None)
    if isinstance(declared, str):
        return declared
    sources = _sources(factory.__module__)
    if not sources and entry.origin == NOT_INSTALLED:
        raise UsageError(
            f"The source of {entry.name!r} cannot be found, so that edits would pass unnoticed: "
            "give the class an attribute version = '1'."
        )
    digest = hashlib.sha256()
    for file in sources:
        digest.update(file.read_bytes())
    return f"source:{digest.hexdigest()[:16]}" if sources else entry.origin


def _sources(module: str) -> list[Path]:
    """Return the files that a method's behaviour may depend on: its package's, or its own and those it imports beside.

    A file of its own stands first, so that a method with nothing beside it has the digest of its file.
    """
    top = sys.modules.get(module.partition(".")[0])
    folders = [Path(folder) for folder in getattr(top, "__path__", ())]
    files = sorted(file for folder in folders for file in folder.rglob("*.py"))
    alone = getattr(sys.modules.get(module), "__file__", None)
    return files or (_with_helpers(Path(alone)) if alone else [])


def _with_helpers(file: Path) -> list[Path]:
    """Return a file and whatever in its folder it imports, directly or not."""
    found, unread = [file], [file]
    while unread:
        for name in sorted(_imported(unread.pop())):
            package = sorted((file.parent / name).rglob("*.py"))
            new = [one for one in (file.parent / f"{name}.py", *package) if one.is_file() and one not in found]
            found += new
            unread += new
    return found


def _imported(file: Path) -> set[str]:
    """Return the top-level names that a file imports; none of one that is no Python."""
    try:
        nodes = list(ast.walk(ast.parse(file.read_bytes())))
    except (SyntaxError, ValueError):
        return set()
    modules = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    modules += [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
    return {module.partition(".")[0] for module in modules} - {""}
