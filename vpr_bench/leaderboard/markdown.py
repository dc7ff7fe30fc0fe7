"""Foreign text in Markdown: shown as it is, whatever is in it."""

import re
from html import escape
from urllib.parse import quote

from vpr_bench.errors import one_line

_MARKUP = re.compile(
    r"[\\`*\[\]~$#@]"  # anywhere
    r"|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])"  # within a word it is only itself
    r"|(?<=www)\.|:(?=//)"  # would become a link
    r"|^[-+=]|(?<=^[0-9])[.)]"  # would begin a list
)


def plain(text: str) -> str:
    r"""Write foreign text on one line so that Markdown shows it; ``|`` is left to the table around it.

    Examples
    --------
    >>> print(plain("twostage(n_components=1)"), plain("<b>*new*</b>"), plain("two\nlines"))
    twostage(n_components=1) &lt;b&gt;\*new\*&lt;/b&gt; two lines
    """
    return escape(_MARKUP.sub(r"\\\g<0>", one_line(text).strip()), quote=False) or "?"


def link(text: str, target: str) -> str:
    """Write a link from a text, Markdown already, to a file.

    Examples
    --------
    >>> link("day to night", "gardens/day_left-night_right@2f.md")
    '[day to night](gardens/day_left-night_right%402f.md)'
    """
    return f"[{text}]({quote(target)})"
