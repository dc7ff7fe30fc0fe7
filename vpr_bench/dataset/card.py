"""A dataset's card: what it is, where it comes from, and on which protocols it is measured."""

import re
import tomllib
from collections.abc import Iterable
from dataclasses import replace
from importlib.resources.abc import Traversable
from pathlib import Path, PurePosixPath
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from vpr_bench.dataset.parts import parse_parts
from vpr_bench.errors import DataError, UsageError, closest, first_fault
from vpr_bench.registry import Registry
from vpr_bench.types.protocol import Protocol, Unit, Unmatched


def _inside(path: str) -> str:
    if PurePosixPath(path).is_absolute() or ".." in PurePosixPath(path).parts or "\\" in path or ":" in path:
        raise ValueError(f"{path!r} leads out of the dataset's folder")
    return path


Digest = Annotated[str, Field(pattern=r"^sha256:[0-9a-f]{64}$")]
InnerPath = Annotated[str, AfterValidator(_inside)]


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class TraverseCard(_Frozen):
    """One traverse: its name, how many images it has, and what its files' digest is in the known copy."""

    name: str = Field(pattern=r"^[a-z0-9][a-z0-9_]*$")
    images: int | None = Field(None, gt=0, description="None: as many as there are")
    digest: Digest | None = None
    folder: InnerPath = Field("", description="inside the dataset's folder; by default the name")
    options: dict[str, Any] = Field(default={}, description="for the layout, over the loader's")
    about: str = ""

    @property
    def path(self) -> str:
        """Folder of the traverse inside the dataset's folder."""
        return self.folder or self.name


class Download(_Frozen):
    """An archive to fetch; without a published digest, the traverses' own digests decide."""

    url: str = Field(pattern=r"^https?://")
    sha256: Digest | None = None
    inner: InnerPath = Field("", description="name of an archive in the archive, which is unpacked in its place")


class Loader(_Frozen):
    """The layout of the images on disk, by its name, with its options."""

    layout: str
    options: dict[str, Any] = {}


class GivenCard(_Frozen):
    """A ground truth that a file of the dataset lists, for protocols ``@given``; the layout reads it."""

    references: str
    queries: str
    options: dict[str, Any] = {}


class ProtocolCard(_Frozen):
    """A named protocol of the dataset; the first one is the default."""

    references: str
    queries: str
    radius: float = Field(0, ge=0, allow_inf_nan=False)
    unit: Unit | None = Field(None, description="None: the card's")
    unmatched: Unmatched = "exclude"
    about: str = ""


class Published(_Frozen):
    """A number that others published, beside which ours may stand."""

    references: str
    queries: str
    radius: float | None = Field(None, description="None: the source does not state it")
    unit: Unit | None = Field(None, description="of the radius; None: the card's")
    method: str
    metric: str
    value: float
    source: str


class Overlay(_Frozen):
    """What is different in an edition; what is not given is as in the real one."""

    loader: Loader | None = None
    traverses: list[TraverseCard] | None = None
    given: list[GivenCard] | None = None
    unit: Unit | None = None
    protocols: Annotated[list[ProtocolCard], Field(min_length=1)] | None = None


class Simulation(Overlay):
    """The renderer of the simulated edition, ``module:function``, and the description that it renders."""

    renderer: str
    options: dict[str, Any]


class EditionCard(Overlay):
    """Another copy of the real images that goes by a name of its own, such as one of smaller frames."""

    name: str = Field(pattern=r"^[a-z0-9][a-z0-9_]*$")
    about: str = ""
    folders: list[str] = Field(min_length=1, description="names its folder has under the data root")


class Card(_Frozen):
    """Everything the harness knows about a dataset; read from TOML, unknown fields refused."""

    id: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$")
    name: str
    summary: str
    citation: str
    licence: str
    homepage: str
    groups: list[str] = Field(default=[], description="names that stand for several datasets at once")
    folders: list[str] = Field(default=[], description="names its folder has under the data root, besides the id")
    unit: Unit
    loader: Loader
    download: Download | None = None
    obtain: str = Field("", description="how to get the images where they cannot be fetched")
    traverses: list[TraverseCard]
    given: list[GivenCard] = []
    protocols: list[ProtocolCard] = Field(min_length=1)
    published: list[Published] = []
    editions: list[EditionCard] = []
    simulation: Simulation | None = None

    @model_validator(mode="after")
    def _hangs_together(self) -> "Card":
        known = {traverse.name for traverse in self.traverses}
        protocols = [str(one) for one in self.listed_protocols()]
        if len(known) < len(self.traverses) or len(set(protocols)) < len(protocols):
            raise ValueError("two traverses or two protocols have the same name")
        pairs: list[ProtocolCard | Published | GivenCard] = [*self.protocols, *self.published, *self.given]
        try:
            for name in [name for pair in pairs for name in (pair.references, pair.queries)]:
                self.check_traverses(name)
        except UsageError as error:
            raise ValueError(str(error)) from None
        for one in self.protocols:
            if one.unit == "given" and self.given_options(one.references, one.queries) is None:
                raise ValueError(f"{one.references}-{one.queries} is @given, but [[given]] does not list it")
        names = self.edition_names()
        if len({"auto", *names}) <= len(names):
            raise ValueError("two editions have the same name")
        for name in names:
            self.in_edition(name)
        return self

    def check_traverses(self, name: str) -> None:
        """Check that a name of references or queries is made of the card's traverses.

        Raises
        ------
        UsageError
            If it is not; the closest traverse is suggested.
        """
        known = {traverse.name for traverse in self.traverses}
        for part in parse_parts(name):
            if part.traverse not in known:
                near = closest(part.traverse, known)
                raise UsageError(f"In {self.id} there is no traverse {part.traverse!r}. {near}")

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
        except UsageError as error:
            raise DataError(f"The card {file} is not valid: {error}") from None
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise DataError(f"The card {file} cannot be read: {error}.") from None

    def edition_names(self) -> list[str]:
        """Return the names of all editions: ``real``, other copies of the real images, ``simulated``."""
        return ["real", *(one.name for one in self.editions), *(["simulated"] if self.simulation else [])]

    def in_edition(self, edition: str) -> "Card":
        """Return the card as it is in one edition: its layout, traverses and protocols.

        Raises
        ------
        UsageError
            If there is no such edition.
        """
        if edition == "real":
            return self
        overlays: dict[str, Overlay] = {one.name: one for one in self.editions}
        if self.simulation is not None:
            overlays["simulated"] = self.simulation
        if edition not in overlays:
            raise UsageError(f"The dataset {self.id!r} has no edition {edition!r}. {closest(edition, overlays)}")
        changed = {name: getattr(overlays[edition], name) for name in Overlay.model_fields}
        kept = {name: getattr(self, name) for name in Card.model_fields}
        # Digests are those of the real files; published numbers were measured on them.
        unknown = [one.model_copy(update={"digest": None}) for one in self.traverses]
        kept |= {"traverses": unknown, "published": [], "editions": [], "simulation": None, "download": None}
        return Card(**{**kept, **{name: value for name, value in changed.items() if value is not None}})

    def protocol(self, pairing: str | None = None, edition: str = "real") -> Protocol:
        """Return one of the card's protocols, or make one of its traverses.

        Parameters
        ----------
        pairing : str, optional
            ``references-queries``, with a reach (``@25m``, ``@5nearest``) where there are several; by default the
            first. One that the card does not list is taken too, if it is made of the card's traverses: it has the
            reach of the first.
        edition : str
            That is written into it.

        Raises
        ------
        UsageError
            If there are no such traverses.
        """
        if pairing is None:
            return self._protocol(self.protocols[0], edition)
        named, at, reach = pairing.partition("@")
        listed = [one for one in self.listed_protocols(edition) if one.pairing == named]
        for one in listed:
            if not at or one.reach == reach:
                return one
        like = listed[0] if listed else self._made(named, edition)
        return self._reaching(like, reach) if at else like

    def listed_protocols(self, edition: str = "real") -> list[Protocol]:
        """Return the protocols that the card names, the default first."""
        return [self._protocol(one, edition) for one in self.protocols]

    def _made(self, pairing: str, edition: str) -> Protocol:
        """Make a protocol of the card's traverses that it does not name, with the reach of its first one."""
        references, _, queries = pairing.partition("-")
        try:
            self.check_traverses(references)
            self.check_traverses(queries)
        except UsageError:
            known = [one.pairing for one in self.listed_protocols()]
            raise UsageError(
                f"The dataset {self.id!r} has no protocol {pairing!r}. {closest(pairing, known)}"
            ) from None
        measured = [one for one in self.protocols if one.unit != "given"] or self.protocols
        return self._protocol(measured[0].model_copy(update={"references": references, "queries": queries}), edition)

    def _reaching(self, protocol: Protocol, reach: str) -> Protocol:
        asked = Protocol.parse(f"{protocol.source}/{protocol.pairing}@{reach}")
        possible = {self.unit, *(["nearest"] if self.unit in ("f", "m") else [])}
        if self.given_options(protocol.references, protocol.queries) is not None:
            possible.add("given")
        if asked.unit not in possible:
            units = " or ".join(sorted(possible))
            raise UsageError(f"{protocol.pairing}@{reach} is in {asked.unit!r}, but {self.id} is measured in {units}.")
        return replace(protocol, radius=asked.radius, unit=asked.unit)

    def _protocol(self, one: ProtocolCard, edition: str) -> Protocol:
        unit = one.unit or self.unit
        return Protocol(self.id, one.references, one.queries, one.radius, unit, edition, one.unmatched)

    def traverse(self, name: str) -> TraverseCard:
        """Return the card of one traverse."""
        return next(traverse for traverse in self.traverses if traverse.name == name)

    def given_options(self, references: str, queries: str) -> dict[str, Any] | None:
        """Return how to read the ground truth that the dataset lists for two traverses, None if it lists none.

        It serves parts of the traverses too.
        """
        parts = [parse_parts(name) for name in (references, queries)]
        if any(len(part) > 1 for part in parts):
            return None
        names = [part[0].traverse for part in parts]
        return next((one.options for one in self.given if [one.references, one.queries] == names), None)


DATASETS: Registry[Card] = Registry("vpr_bench.datasets", "dataset", Card)


def expand_groups(names: Iterable[str]) -> list[str]:
    """Put the datasets of a group in place of its name, each once; all other names stay as they are.

    Raises
    ------
    UsageError
        If a name is neither of a dataset nor of a group nor a folder; the closest of both is suggested.
    """
    expanded: list[str] = []
    for name in names:
        group, colon, edition = name.partition(":")
        members = _members(group) if re.fullmatch(r"[a-z0-9-]+", group) else []
        expanded += [member + colon + edition for member in members] or [name]
    return list(dict.fromkeys(expanded))


def _members(name: str) -> list[str]:
    """Return the datasets of a group; none if the name is one of a dataset, or of a folder."""
    if name in DATASETS:
        return []
    cards = DATASETS.load_all()
    members = [dataset for dataset, card in cards.items() if name in card.groups]
    if not members and not Path(name).is_dir():
        groups = {group for card in cards.values() for group in card.groups}
        raise UsageError(f"There is no dataset and no group {name!r}. {closest(name, groups | cards.keys())}")
    return members


def find_card(dataset: str) -> Card:
    """Return the card of a dataset by its id.

    Raises
    ------
    UsageError
        If there is no such dataset; the closest one is suggested.
    """
    return DATASETS.find(dataset)
