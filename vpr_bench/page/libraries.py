"""The JavaScript that the page is drawn with, taken from the Python packages that ship it, and packed small."""

import re
from base64 import b64encode
from dataclasses import dataclass
from functools import cache, cached_property
from gzip import compress
from hashlib import sha256
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from vpr_bench.errors import DataError

TABLES = "DataTable"
"""The name by which the page knows the class that makes a table sortable."""

_EXPORTS = re.compile(r"\bexport\s*\{([^{}]*)\}\s*;?(?=\s*(/\*|$))")
_DEFAULT = re.compile(r"(?:^|,)\s*([A-Za-z_$][\w$]*)\s+as\s+default\s*(?:,|$)")


@dataclass(frozen=True)
class Library:
    """JavaScript that the page carries along.

    Attributes
    ----------
    about : str
        Name, version and licence.
    source : str
        A classic script.
    """

    about: str
    source: str

    @cached_property
    def digest(self) -> str:
        """``sha256-…``, as a Content-Security-Policy names a script."""
        return script_digest(self.source)

    @cached_property
    def packed(self) -> str:
        """The script as gzip in base64; the same script gives the same text."""
        return b64encode(compress(self.source.encode(), 9, mtime=0)).decode()


def script_digest(source: str) -> str:
    """Return ``sha256-…`` of a script, as a Content-Security-Policy names it."""
    return f"sha256-{b64encode(sha256(source.encode()).digest()).decode()}"


@cache
def chart_library() -> Library:
    """Return plotly.js, which sets ``Plotly``.

    Raises
    ------
    DataError
        If the package plotly is not as expected.
    """
    source = _shipped("plotly", "package_data/plotly.min.js")
    return Library(f"plotly.js, from plotly {version('plotly')} (MIT)", source)


@cache
def table_library() -> Library:
    """Return DataTables, which sets :data:`TABLES`.

    Raises
    ------
    DataError
        If the package itables is not as expected.
    """
    module = _shipped("itables", "html/dt_bundle.js")
    return Library(f"DataTables, from itables {version('itables')} (MIT)", _as_script(module, TABLES))


def _as_script(module: str, name: str) -> str:
    """Turn a module into a script that gives its default export a name: a policy cannot name what is imported."""
    exports = [*_EXPORTS.finditer(module)]
    default = _DEFAULT.search(exports[0][1]) if len(exports) == 1 else None
    if default is None:
        raise DataError("The JavaScript of the package itables has no default export: install another version of it.")
    # The licences stand behind the exports.
    before, after = module[: exports[0].start()], module[exports[0].end() :]
    return f"(()=>{{{before}\nglobalThis.{name}={default[1]};{after}}})();"


def _shipped(package: str, inner: str) -> str:
    """Read a file of an installed package, which is not imported for it."""
    found = find_spec(package)
    folder = Path(found.origin).parent if found and found.origin else Path()
    try:
        return (folder / inner).read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise DataError(f"The package {package} has no {inner}: install it again ({error}).") from None
