"""Parts of traverses, and several joined into one map: ``summer.every10+winter.every10``."""

import re
from dataclasses import dataclass

from vpr_bench.errors import UsageError

_STEP = re.compile(r"(every|first|even)([1-9][0-9]*)")


@dataclass(frozen=True)
class Part:
    """A traverse, or some of its frames.

    Attributes
    ----------
    traverse : str
        Its name in the card.
    steps : tuple of (str, int)
        What is taken of it, one step after the other: ``("every", 10)`` is every tenth frame from the first one
        on, ``("first", 100)`` the first hundred, ``("even", 100)`` a hundred at even distances.
    """

    traverse: str
    steps: tuple[tuple[str, int], ...] = ()

    def indices(self, length: int) -> list[int]:
        """Return which frames of a traverse of this length are taken; never more than there are.

        Examples
        --------
        >>> Part("summer", (("first", 50), ("every", 20))).indices(1000)
        [0, 20, 40]
        >>> Part("summer", (("even", 4),)).indices(10)
        [0, 2, 5, 7]
        """
        taken = list(range(length))
        for step, number in self.steps:
            if step == "every":
                taken = taken[::number]
            elif step == "first":
                taken = taken[:number]
            elif number < len(taken):
                taken = [taken[index * len(taken) // number] for index in range(number)]
        return taken


def parse_parts(name: str) -> list[Part]:
    """Read the name of a map or of queries, as it stands in a protocol.

    Raises
    ------
    UsageError
        If a traverse is followed by something else than ``.everyN``, ``.firstN`` or ``.evenN``.

    Examples
    --------
    >>> parse_parts("summer.every10+winter")
    [Part(traverse='summer', steps=(('every', 10),)), Part(traverse='winter', steps=())]
    """
    parts = []
    for piece in name.split("+"):
        traverse, *steps = piece.split(".")
        found = [_STEP.fullmatch(step) for step in steps]
        if None in found:
            raise UsageError(
                f"{piece!r} is not part of a traverse. Write it like {traverse}.every10, .first100 or .even100."
            )
        parts.append(Part(traverse, tuple((step[1], int(step[2])) for step in found if step)))
    return parts
