"""Which cells and runs somebody asks about."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from vpr_bench.dataset.card import expand_groups
from vpr_bench.dataset.request import Request, own_folder
from vpr_bench.dataset.source import find_whole_card
from vpr_bench.errors import UsageError, closest
from vpr_bench.gate.cell import Cell
from vpr_bench.gate.rerun import Sources
from vpr_bench.method.build import find_method
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol


@dataclass(frozen=True)
class Subject:
    """What a cell or a run is about."""

    label: str
    method: str
    protocol: Protocol

    @classmethod
    def of_cell(cls, cell: Cell) -> "Subject":
        """Say what a cell is about."""
        return cls(cell.label, cell.method, cell.asked)

    @classmethod
    def of_run(cls, run: StoredRun) -> "Subject":
        """Say what a run is about."""
        return cls(run.record.label, run.record.key.method, run.protocol)


@dataclass(frozen=True)
class Selection:
    """What is asked about; an empty list asks about all.

    Attributes
    ----------
    methods : sequence of str
        Ids or labels, or a method's file with its folder.
    datasets : sequence of str
        As for ``vpr-bench run``; without an edition, all editions.
    protocols : sequence of str
        ``references-queries``, with or without the radius.
    """

    methods: Sequence[str] = ()
    datasets: Sequence[str] = ()
    protocols: Sequence[str] = ()
    _requests: tuple[tuple[str, Request], ...] = field(init=False, repr=False, default=())
    _ids: dict[str, str] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        """Look up what datasets and methods are called in results.

        Raises
        ------
        UsageError
            If there is no such dataset.
        DataError
            If a folder of one's own is not recognised.
        """
        requests = tuple((name, Request.parse(name)) for name in expand_groups(self.datasets))
        object.__setattr__(self, "_requests", tuple((_dataset_id(request), request) for _, request in requests))
        object.__setattr__(self, "_ids", {name: _method_id(name) for name in self.methods})

    @property
    def sources(self) -> Sources:
        """Where the methods and folders lie that are named."""
        folders = {dataset: one.dataset for dataset, one in self._requests if own_folder(one.dataset) is not None}
        return Sources({method: name for name, method in self._ids.items()}, folders)

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

    def _is_method(self, name: str, subject: Subject) -> bool:
        return name == subject.label or self._ids[name] == subject.method


def _method_id(name: str) -> str:
    """Return what a method is called in results; of one that is not here, or a label, the name itself."""
    try:
        entry, preset = find_method(name)
    except UsageError:
        return name
    return name if preset is not None else entry.name


def _dataset_id(request: Request) -> str:
    return request.dataset if own_folder(request.dataset) is None else find_whole_card(request).id


def _is_dataset(dataset: str, request: Request, subject: Subject) -> bool:
    if subject.protocol.dataset != dataset or request.edition not in ("auto", subject.protocol.edition):
        return False
    return request.pairing is None or _is_pairing(request.pairing, subject)


def _is_pairing(name: str, subject: Subject) -> bool:
    protocol = subject.protocol
    return name in (protocol.pairing, f"{protocol.pairing}@{protocol.reach}")


def _nothing(kind: str, name: str, known: set[str]) -> str:
    return f"Neither the baseline nor the runs know the {kind} {name!r}. {closest(name, known)}"
