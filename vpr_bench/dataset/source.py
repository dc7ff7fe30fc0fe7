"""Which dataset, in which edition: what is looked up once a request has been read."""

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from vpr_bench.dataset.card import Card, find_card
from vpr_bench.dataset.editions import choose_edition, edition_folder
from vpr_bench.dataset.own import own_card
from vpr_bench.dataset.request import Request, own_folder


def find_whole_card(request: Request) -> Card:
    """Return the card of what was asked for, with all its editions; nothing needs to be on disk.

    Raises
    ------
    UsageError
        If there is no such dataset.
    DataError
        If a folder of one's own is not recognised.
    """
    own = own_folder(request.dataset)
    return find_card(request.dataset) if own is None else own_card(own)


@dataclass(frozen=True, eq=False)
class Source:
    """A dataset in one edition.

    Attributes
    ----------
    card : Card
        As it is in this edition.
    edition : str
        Never ``auto``.
    whole : Card
        The card as it is written, with all editions.
    own : Path, optional
        The user's own folder; None for an installed dataset.
    render : bool
        Render simulated images that are not here yet; else they are missing.
    """

    card: Card
    edition: str
    whole: Card = field(repr=False)
    own: Path | None = None
    render: bool = True

    @classmethod
    def find(cls, request: Request, *, render: bool = True) -> "Source":
        """Look up what was asked for; nothing is rendered yet.

        Raises
        ------
        UsageError
            If there is no such dataset or edition.
        DataError
            If the real images are needed and are not on disk, or a folder of one's own is not recognised.
        """
        own, card = own_folder(request.dataset), find_whole_card(request)
        if own is not None:
            return cls(card, "real", card, own)
        edition = choose_edition(card, request.edition)
        return cls(card.in_edition(edition), edition, card, render=render)

    @property
    def name(self) -> str:
        """Dataset with its edition, as in a protocol's id."""
        return self.card.id if self.edition == "real" else f"{self.card.id}:{self.edition}"

    @property
    def foreign(self) -> bool:
        """Whether the images come from somebody else: neither rendered nor the user's own."""
        return self.own is None and self.edition != "simulated"

    @cached_property
    def folder(self) -> Path:
        """Holds the traverses; simulated ones are rendered when it is asked for."""
        return self.own or edition_folder(self.whole, self.edition, render=self.render)
