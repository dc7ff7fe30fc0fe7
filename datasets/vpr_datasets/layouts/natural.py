"""The order in which a camera or a person numbers files."""

import re


def natural_key(name: str) -> tuple[list[str | int], str]:
    """Return a sorting key by which ``2.jpg`` comes before ``10.jpg``.

    Examples
    --------
    >>> sorted(["b-10.jpg", "b-2.jpg", "a-11.jpg"], key=natural_key)
    ['a-11.jpg', 'b-2.jpg', 'b-10.jpg']
    """
    # Text and numbers take turns, so that two keys are always compared like with like.
    parts: list[str | int] = list(re.split(r"([0-9]+)", name))
    parts[1::2] = [int(part) for part in parts[1::2]]
    return parts, name  # the name itself tells 01.jpg from 1.jpg
