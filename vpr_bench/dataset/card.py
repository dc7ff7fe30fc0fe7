"""A dataset's card: what it is, where it comes from, and on which protocols it is measured."""

import tomllib
from importlib.resources.abc import Traversable
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from vpr_bench.errors import DataError, UsageError, closest, first_fault
from vpr_bench.registry import Registry
from vpr_bench.types.protocol import Protocol, Unit, Unmatched

Digest = Annotated[str, Field(pattern=r"^sha256:[0-9a-f]{64}$")]


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class TraverseCard(_Frozen):
    """One traverse: its name, how many images it has, and what its files' digest is in the known copy."""

    name: str = Field(pattern=r"^[a-z0-9][a-z0-9._]*$")
    images: int = Field(gt=0)
    digest: Digest | None = None
    folder: str = Field("", description="inside the dataset's folder; by default the name")
    about: str = ""

    @property
    def path(self) -> str:
        """Folder of the traverse inside the dataset's folder."""
        return self.folder or self.name


class Download(_Frozen):
    """An archive to fetch; without a published digest, the traverses' own digests decide."""

    url: str = Field(pattern=r"^https?://")
    sha256: Digest | None = None


class Loader(_Frozen):
    """The loader that understands the on-disk layout, ``module:function``, with its options."""

    function: str
    options: dict[str, Any] = {}


class Simulation(_Frozen):
    """The renderer of the simulated edition, ``module:function``, and the description that it renders."""

    renderer: str
    options: dict[str, Any]


class ProtocolCard(_Frozen):
    """A named protocol of the dataset; the first one is the default."""

    references: str
    queries: str
    radius: float = Field(ge=0, allow_inf_nan=False)
    unmatched: Unmatched = "exclude"
    about: str = ""


class Published(_Frozen):
    """A number that others published, beside which ours may stand."""

    references: str
    queries: str
    radius: float | None = Field(None, description="None: the source does not state it")
    method: str
    metric: str
    value: float
    source: str


class Card(_Frozen):
    """Everything the harness knows about a dataset; read from TOML, unknown fields refused."""

    id: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$")
    name: str
    summary: str
    citation: str
    licence: str
    homepage: str
    folders: list[str] = Field(default=[], description="names its folder has under the data root, besides the id")
    unit: Unit
    loader: Loader
    download: Download | None = None
    traverses: list[TraverseCard]
    protocols: list[ProtocolCard] = Field(min_length=1)
    published: list[Published] = []
    simulation: Simulation | None = None

    @model_validator(mode="after")
    def _names_exist(self) -> "Card":
        known = {traverse.name for traverse in self.traverses}
        pairings = [(protocol.references, protocol.queries) for protocol in self.protocols]
        if len(known) < len(self.traverses) or len(set(pairings)) < len(pairings):
            raise ValueError("two traverses or two protocols have the same name")
        pairs: list[ProtocolCard | Published] = [*self.protocols, *self.published]
        for name in [name for pair in pairs for name in (pair.references, pair.queries)]:
            if name not in known:
                raise ValueError(f"there is no traverse {name!r}. {closest(name, known)}")
        return self

    @classmethod
    def from_toml(cls, file: Traversable) -> "Card":
        """Read a card.

        Raises
        ------
        DataError
            If it is not TOML or does not describe a dataset; names the first field that is wrong.
        """
        try:
            return cls.model_validate(tomllib.loads(file.read_text("utf-8")))
        except ValidationError as error:
            raise DataError(f"The card {file} is not valid: {first_fault(error)}.") from None
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise DataError(f"The card {file} cannot be read: {error}.") from None

    def protocol(self, pairing: str | None = None, edition: str = "real") -> Protocol:
        """Return one of the card's protocols by its pairing (``references-queries``), by default the first.

        Raises
        ------
        UsageError
            If the card has no such protocol.
        """
        named = {f"{one.references}-{one.queries}": one for one in self.protocols}
        if pairing is None:
            pairing = next(iter(named))
        if pairing not in named:
            raise UsageError(f"The dataset {self.id!r} has no protocol {pairing!r}. {closest(pairing, named)}")
        one = named[pairing]
        return Protocol(self.id, one.references, one.queries, one.radius, self.unit, edition, one.unmatched)

    def traverse(self, name: str) -> TraverseCard:
        """Return the card of one traverse."""
        return next(traverse for traverse in self.traverses if traverse.name == name)


DATASETS: Registry[Card] = Registry("vpr_bench.datasets", "dataset")


def as_card(loaded: Any) -> Card:
    """Check that a dataset plug-in is a card.

    Raises
    ------
    UsageError
        If it is something else.
    """
    if not isinstance(loaded, Card):
        raise UsageError(f"a dataset must be a vpr_bench.dataset.card.Card. Got {type(loaded).__name__} instead.")
    return loaded


def find_card(dataset: str) -> Card:
    """Return the card of a dataset by its id.

    Raises
    ------
    UsageError
        If there is no such dataset; the closest one is suggested.
    """
    card = as_card(DATASETS.entry(dataset).load())
    if card.id != dataset:
        raise UsageError(f"The dataset {dataset!r} has a card with the id {card.id!r}: both must be the same.")
    return card
