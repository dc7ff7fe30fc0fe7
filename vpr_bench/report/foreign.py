"""Foreign text in Markdown and CSV: shown as it is, and never taken for more than text."""

import re
from collections.abc import Mapping
from html import escape
from typing import Any

from vpr_bench.errors import one_line

_MARKUP = re.compile(
    r"[\\`*\[\]~$#]"  # anywhere
    r"|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])"  # within a word it is only itself
    r"|(?<=[wW]{3})\.|:(?=//)|@(?=[0-9A-Za-z_-]*\.)|(?<![0-9A-Za-z])@"  # would become a link
    r"|^[-+=](?![0-9A-Za-z.])"  # would begin a list, or underline a heading
)
_NUMBERED = re.compile(r"^([0-9]{1,9})([.)])(?= |$)")

_RISKY = "=+-@'\uff1d\uff0b\uff0d\uff20"
"""A spreadsheet takes a cell that begins so (in full width too) for a formula, or for text that is quoted already."""


def plain(text: str) -> str:
    r"""Write text on one line so that Markdown shows it, in a table or outside; ``?`` for none.

    Examples
    --------
    >>> print(plain("twostage(n_components=1)"), plain("<b>*new*</b>"), plain("two\nlines"), plain("a|b"))
    twostage(n_components=1) &lt;b&gt;\*new\*&lt;/b&gt; two lines a&#124;b
    """
    marked = _NUMBERED.sub(r"\1\\\2", _MARKUP.sub(r"\\\g<0>", one_line(text).strip()))
    return escape(marked, quote=False).replace("|", "&#124;") or "?"


def shortened(text: str, most: int = 80) -> str:
    """Write text on one line, without its middle where it is longer than ``most`` characters; ``?`` for none.

    Examples
    --------
    >>> shortened("sad(width=64)"), shortened("a_very_long_name_indeed", most=11)
    ('sad(width=64)', 'a_ver…ndeed')
    """
    text = one_line(text) or "?"
    if len(text) <= most:
        return text
    tail = (most - 1) // 2
    return f"{text[: most - 1 - tail]}…{text[len(text) - tail :]}"


def guarded(text: str) -> str:
    r"""Write text so that no spreadsheet takes it for a formula; what is empty is told from what is missing.

    Examples
    --------
    >>> guarded("hog"), guarded("=1+1"), guarded("'quoted'"), guarded("")
    ('hog', "'=1+1", "''quoted'", "'")
    """
    risky = not text or text[0] in _RISKY or text[0].isspace()
    return f"'{text}" if risky else text


def unguarded(text: str) -> str:
    """Return what :func:`guarded` was given."""
    return text.removeprefix("'")


def guarded_cells(line: Mapping[str, Any]) -> dict[str, Any]:
    """Guard the texts among the cells of a line by column; numbers stay, and what is empty stays empty.

    Examples
    --------
    >>> guarded_cells({"method": "=1+1", "value": -0.5, "file": ""})
    {'method': "'=1+1", 'value': -0.5, 'file': ''}
    """
    return {name: guarded(cell) if isinstance(cell, str) and cell else cell for name, cell in line.items()}
