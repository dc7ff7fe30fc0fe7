"""Which cells and runs somebody asks about."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from vpr_bench.dataset.card import expand_groups
from vpr_bench.dataset.request import Request, own_folder
from vpr_bench.dataset.source import find_whole_card
from vpr_bench.errors import UsageError, closest
from vpr_bench.gate.cell import Cell
from vpr_bench.gate.matching import asked_for
from vpr_bench.gate.recording import changed_parameters
from vpr_bench.gate.rerun import Sources
from vpr_bench.method.build import find_method
from vpr_bench.method.rebuild import called, places_of
from vpr_bench.registry import NOT_INSTALLED
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol, Unmatched


@dataclass(frozen=True)
class Subject:
    """What a cell or a run is about.

    Attributes
    ----------
    label, method, protocol
        Of it.
    inside : frozenset of str
        What its parameters name; methods inside the method are among them.
    """

    label: str
    method: str
    protocol: Protocol
    inside: frozenset[str] = frozenset()

    @classmethod
    def of_cell(cls, cell: Cell) -> "Subject":
        """Say what a cell is about."""
        return cls(cell.label, cell.method, cell.asked, _named_in(cell.parameters))

    @classmethod
    def of_run(cls, run: StoredRun) -> "Subject":
        """Say what a run is about."""
        record = run.record
        return cls(record.label, record.key.method, run.protocol, _named_in(changed_parameters(record)))


@dataclass(frozen=True)
class Selection:
    """What is asked about; an empty list asks about all.

    Attributes
    ----------
    methods : sequence of str
        Ids or labels, or a method's file with its folder; one that is not installed is meant inside others too.
    datasets : sequence of str
        As for ``vpr-bench run``; without an edition, all editions: ``gardens:real`` are the real images only.
    protocols : sequence of str
        ``references-queries``, with or without the radius (``@5f``) and, after that, the policy (``~reject``).
    trusted : sequence of str
        Methods whose code may be run though they are not installed; they choose nothing.
    """

    methods: Sequence[str] = ()
    datasets: Sequence[str] = ()
    protocols: Sequence[str] = ()
    trusted: Sequence[str] = ()
    _requests: tuple[tuple[str, Request], ...] = field(init=False, repr=False, default=())
    _ids: dict[str, str] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        """Look up what datasets and methods are called in results.

        Raises
        ------
        UsageError
            If there is no such dataset or trusted method, a protocol cannot be read, or two methods have one name in
            results.
        DataError
            If a folder of one's own is not recognised.
        """
        requests = tuple((name, Request.parse(name)) for name in expand_groups(self.datasets))
        object.__setattr__(self, "_requests", tuple((_dataset_id(request), request) for _, request in requests))
        object.__setattr__(self, "_ids", {name: _method_id(name) for name in self.methods})
        self._places()
        for name in self.protocols:
            if "@" in name:
                _protocol("any", name)

    @property
    def sources(self) -> Sources:
        """Where the methods and folders lie that are named."""
        folders = {dataset: one.dataset for dataset, one in self._requests if own_folder(one.dataset) is not None}
        return Sources(self._places(), folders)

    @property
    def names_radii(self) -> bool:
        """Whether protocols are named with their radius."""
        return any("@" in name for name in [*self.protocols, *(one.pairing or "" for _, one in self._requests)])

    def asked_of(self, run: StoredRun) -> list[StoredRun]:
        """Return a run once for each protocol that is asked about and that it serves, whatever it was asked for."""
        own = run.protocol
        served = [own, *(_protocol(own.source, name, own) for name in self.protocols if _names(name, own))]
        for _, request in self._requests:
            if request.pairing is not None and _names(request.pairing, own):
                served.append(_protocol(own.source, request.pairing, own, request.unmatched))
        about = Subject.of_run(run)
        wanted = [one for one in dict.fromkeys(served) if self.wants(replace(about, protocol=one))]
        return [run if one == own else asked_for(run, one) for one in wanted]

    def wants(self, subject: Subject) -> bool:
        """Tell whether something is asked about."""
        return (
            (not self.methods or any(self._is_method(name, subject) for name in self.methods))
            and (not self._requests or any(_is_dataset(dataset, one, subject) for dataset, one in self._requests))
            and (not self.protocols or any(_is_pairing(one, subject) for one in self.protocols))
        )

    def check(self, subjects: Iterable[Subject]) -> None:
        """Refuse a name that means nothing that is there.

        Raises
        ------
        UsageError
            If there is one.
        """
        subjects = list(subjects)
        for name in self.methods:
            if not any(self._is_method(name, one) for one in subjects):
                raise UsageError(_nothing("method", name, {one.method for one in subjects}))
        for name, (dataset, request) in zip(expand_groups(self.datasets), self._requests, strict=True):
            if not any(_is_dataset(dataset, request, one) for one in subjects):
                raise UsageError(_nothing("dataset", name, {one.protocol.source for one in subjects}))
        for name in self.protocols:
            if not any(_is_pairing(name, one) for one in subjects):
                raise UsageError(_nothing("protocol", name, {one.protocol.pairing for one in subjects}))

    def _places(self) -> dict[str, str]:
        return places_of(self._ids | {name: called(name) for name in self.trusted})

    def _is_method(self, name: str, subject: Subject) -> bool:
        method = self._ids[name]
        inside = method in subject.inside and find_method(name)[0].origin == NOT_INSTALLED
        return inside or name == subject.label or method == subject.method


def _method_id(name: str) -> str:
    """Return what a method is called in results; of one that is not here, or a label, the name itself."""
    try:
        return called(name)
    except UsageError:
        return name


def _named_in(parameters: Mapping[str, Any]) -> frozenset[str]:
    return frozenset(value for value in parameters.values() if isinstance(value, str))


def _dataset_id(request: Request) -> str:
    return request.dataset if own_folder(request.dataset) is None else find_whole_card(request).id


def _is_dataset(dataset: str, request: Request, subject: Subject) -> bool:
    if subject.protocol.dataset != dataset or request.edition not in ("auto", subject.protocol.edition):
        return False
    if request.unmatched not in (None, subject.protocol.unmatched):
        return False
    return request.pairing is None or _is_pairing(request.pairing, subject)


def _is_pairing(name: str, subject: Subject) -> bool:
    protocol = subject.protocol
    if "@" not in name:
        return name == protocol.pairing
    return _protocol(protocol.source, name, protocol) == protocol


def _names(name: str, protocol: Protocol) -> bool:
    """Tell whether these are the two traverses of a protocol, with a radius."""
    return name.startswith(f"{protocol.pairing}@")


def _protocol(source: str, name: str, like: Protocol | None = None, unmatched: Unmatched | None = None) -> Protocol:
    """Read ``references-queries@radius``; a policy that is not written is the given one, or that of another protocol.

    Raises
    ------
    UsageError
        If it cannot be read.
    """
    try:
        found = Protocol.parse(f"{source}/{name}")
    except UsageError:
        raise UsageError(f"{name!r} is no protocol. Write it like day_left-night_right@5f, or without @5f.") from None
    if unmatched is None and like is not None and "~" not in name:
        unmatched = like.unmatched
    return replace(found, unmatched=unmatched or found.unmatched)


def _nothing(kind: str, name: str, known: set[str]) -> str:
    return f"Neither the baseline nor the runs know the {kind} {name!r}. {closest(name, known)}"
