"""The dataset that is checked."""

from dataclasses import dataclass
from functools import cached_property

from vpr_bench.dataset.load import Case, load_from, load_traverse
from vpr_bench.dataset.recording import Recording
from vpr_bench.dataset.source import Source
from vpr_bench.types.protocol import Protocol


@dataclass(eq=False)
class DatasetSubject:
    """A dataset in one edition.

    Attributes
    ----------
    source : Source
        Where it is, and its card.
    """

    source: Source

    @property
    def protocols(self) -> list[Protocol]:
        """Those that the card lists, in this edition."""
        return self.source.card.listed_protocols(self.source.edition)

    @cached_property
    def cases(self) -> list[Case]:
        """All protocols, loaded."""
        return self.load()

    def load(self) -> list[Case]:
        """Load all protocols; no digest is remembered, as to look is not to meet."""
        return [load_from(self.source.card, one, self.source.folder) for one in self.protocols]

    def traverses(self) -> dict[str, Recording]:
        """Load every traverse of the card, whole."""
        card, folder = self.source.card, self.source.folder
        return {one.name: load_traverse(card, one, folder) for one in card.traverses}
