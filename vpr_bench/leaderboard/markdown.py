"""Links in Markdown."""

from urllib.parse import quote


def link(text: str, target: str) -> str:
    """Write a link from a text, Markdown already, to a file.

    Examples
    --------
    >>> link("day to night", "gardens/day_left-night_right@2f.md")
    '[day to night](gardens/day_left-night_right%402f.md)'
    """
    return f"[{text}]({quote(target)})"
