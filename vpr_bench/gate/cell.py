"""One cell of a baseline: what one method answered on one protocol when it was recorded."""

import hashlib
import json
import math
from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from vpr_bench.errors import DataError, UsageError
from vpr_bench.gate.answered import Answered
from vpr_bench.gate.lines import from_lines
from vpr_bench.gate.rules import Rules
from vpr_bench.metrics.answers import NEVER, Answers
from vpr_bench.metrics.definitions import compute
from vpr_bench.types.protocol import Protocol

DECIMALS = 6
"""Of the metrics in the file; they are there to be read, and judged by those that follow from the answers."""

_ABOUT_TIMES = frozenset({"latency", "machine", "threads", "package", "commit", "created", "digest", "rules"})

_Text = Annotated[str, Field(max_length=4000)]
_Count = Annotated[int, Field(ge=0, lt=10**11)]
_Finite = Annotated[float, Field(allow_inf_nan=False)]


class _Strict(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)


class Columns(_Strict):
    """What was answered, as text: see :class:`~vpr_bench.gate.answered.Answered` and :mod:`vpr_bench.gate.lines`."""

    best: list[str]
    rank: list[str]
    score: list[str]


class CellMachine(_Strict):
    """Where times were measured.

    Attributes
    ----------
    name : str
        The machine in a few words.
    fingerprint : str
        The same where times may be compared.
    elsewhere : float or None
        Share of its processor time that other processes took meanwhile, in [0, 1]; None where it was not noted.
    """

    name: _Text
    fingerprint: _Text
    elsewhere: Annotated[float, Field(ge=0, le=1)] | None


class Cell(_Strict):
    """One method on one protocol, as it was recorded.

    Attributes
    ----------
    label, protocol : str
        What the cell is called: the method with the parameters that are not the default ones, and the protocol's id.
    method : str
        The method's id.
    parameters : dict
        Those that are not the default ones, written as for ``--param``.
    version, weights : str
        Of the method; no weights are None.
    dataset : str
        Digest of the images.
    seed, k, threads : int
        As in the run.
    n_queries, n_references, depth : int
        Of the protocol, and how many answers per query were known; None for as many as there are.
    metrics : dict
        All metrics of the best answers, None where undefined.
    answers : Columns
        What was answered.
    latency : dict
        Milliseconds per query, ``<stage>_p50`` and ``<stage>_p95``.
    machine : CellMachine
        What it ran on.
    package, commit, created : str
        Version of vpr-bench, its commit if that was known, and when the run was complete.
    rules : Rules
        What differs from the rules of the whole file; may be edited by hand.
    digest : str
        Over everything but the rules: it tells edits and damage, and vouches for nobody.
    """

    label: _Text
    protocol: _Text
    method: _Text
    parameters: dict[str, Any]
    version: _Text
    weights: _Text | None
    dataset: _Text
    seed: _Count
    k: _Count
    threads: _Count
    n_queries: _Count
    n_references: _Count
    depth: _Count | None
    metrics: dict[str, _Finite | None]
    answers: Columns
    latency: dict[str, Annotated[_Finite, Field(ge=0)]]
    machine: CellMachine
    package: _Text
    commit: _Text | None
    created: _Text
    rules: Rules = Rules()
    digest: str = ""

    @property
    def id(self) -> str:
        """What the cell is called in the file; no two have the same."""
        return cell_id(self.label, self.protocol)

    @cached_property
    def asked(self) -> Protocol:
        """The protocol.

        Raises
        ------
        UsageError
            If it is none.
        """
        return Protocol.parse(self.protocol)

    @cached_property
    def answered(self) -> Answered:
        """What is known of each query.

        Raises
        ------
        ValueError
            If the columns are not as they were written; names the column.
        """
        texts = {}
        for name, lines in self.answers.model_dump().items():
            try:
                texts[name] = from_lines(lines, self.n_queries)
            except ValueError as error:
                raise ValueError(f"answers.{name}: {error}") from None
        return Answered.from_texts(**texts, n_references=self.n_references)

    @cached_property
    def judged(self) -> Answers:
        """The answers, as metrics take them; errors as of :attr:`answered`."""
        return self.answered.answers(self.asked.unmatched, NEVER if self.depth is None else self.depth)

    def sealed(self) -> "Cell":
        """Return the cell with its digest."""
        return self.model_copy(update={"digest": self._digest()})

    def check(self) -> None:
        """Compare everything with what it follows from.

        Raises
        ------
        ValueError
            If the answers are damaged, a metric does not follow from them, or the digest is another one.
        UsageError
            If the protocol, or a metric, does not exist.
        """
        found = compute(self.metrics, self.judged)
        for name, written in self.metrics.items():
            if not _agree(written, found[name]):
                says = "undefined" if written is None else f"{written:g}"
                raise ValueError(f"{name} is {says} in the file, and {found[name]:.{DECIMALS}f} by its answers")
        if self.digest != self._digest():
            raise ValueError("it is not as it was written: its digest is another one")

    def same_answers(self, other: "Cell") -> bool:
        """Tell whether two cells differ in nothing but times, where and when they were measured, and rules."""
        mine, others = (cell.model_dump(mode="json", exclude=set(_ABOUT_TIMES)) for cell in (self, other))
        return mine == others

    def _digest(self) -> str:
        content = self.model_dump(mode="json", exclude={"digest", "rules"})
        canonical = json.dumps(content, sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(canonical.encode()).hexdigest()[:16]


def cell_id(label: str, protocol: str) -> str:
    """Write what a cell is called: the protocol, which has no spaces, then the method's label."""
    return f"{protocol} {label}"


def other_images(cell: Cell, found: str, where: str) -> DataError:
    """Return the error that images of another digest deserve."""
    return DataError(
        f"the images are others: {cell.dataset} in the baseline, {found} {where}. Get the same ones; if they are meant "
        "to change, take the cell out of the baseline and record it with --update."
    )


def written_metrics(values: Mapping[str, float]) -> dict[str, float | None]:
    """Round metrics as they stand in the file; None for what is undefined."""
    return {name: None if math.isnan(value) else round(value, DECIMALS) for name, value in values.items()}


def check_cell(cell: Cell, key: str) -> str | None:
    """Return what is wrong with a cell that stands under this key of a file, None if nothing is."""
    if cell.id != key:
        return f"it holds {cell.id!r}"
    try:
        cell.check()
    except (ValueError, UsageError) as error:
        return str(error).rstrip(".")
    return None


def _agree(written: float | None, found: float) -> bool:
    if written is None or math.isnan(found):
        return written is None and math.isnan(found)
    return bool(abs(written - found) < 2 * 10.0**-DECIMALS)
