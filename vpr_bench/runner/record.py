"""``run.json``: everything about a run except its arrays."""

import hashlib
import json
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from vpr_bench.errors import DamagedError, DataError, UsageError, first_fault
from vpr_bench.files.disk import disk_errors
from vpr_bench.files.migrations import migrated
from vpr_bench.runner.machine import Machine
from vpr_bench.runner.migrations import SCHEMA_VERSION, STEPS
from vpr_bench.runner.provenance import Provenance
from vpr_bench.types.protocol import Protocol


class RunKey(BaseModel):
    """What makes two runs the same run: equal keys give equal answers, on one machine bit by bit.

    The radius is not in it: it decides how answers are scored, not what they are, so that one run serves
    every radius. ``dataset_digest`` stands for the images, ``pairing`` for their roles.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    source: str
    pairing: str
    dataset_digest: str
    method: str
    version: str
    parameters: dict[str, Any]
    weights: str | None
    seed: int
    k: int
    limit: int | None
    threads: int

    def digest(self) -> str:
        """Return the first 12 hexadecimal digits of the SHA-256 over the key's canonical JSON."""
        canonical = json.dumps(self.model_dump(mode="json"), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(canonical.encode()).hexdigest()[:12]


class RunRecord(BaseModel):
    """One complete run.

    Attributes
    ----------
    key : RunKey
        What identifies it.
    protocol : str
        Canonical id of the protocol it was asked for, radius included.
    label : str
        The method with the parameters that differ from their defaults.
    partial : bool
        Only some of the queries were asked (``--limit``): never ranked.
    resumed : bool
        It was interrupted and continued, so that its times come from several processes.
    order : {"shuffled", "sequential"}
        How the queries were asked: in the order that the key's seed gives, or, by a method that makes use of the
        queries before, as they come.
    future : int
        How many frames after each query the method was shown before it answered.
    timeout : float or None
        Seconds that an answer was allowed to take; with a limit, answers come from a thread beside the main one.
    fit_seconds : float
        Wall time of fitting, decoding included.
    peak_memory : dict
        Largest resident memory in bytes while fitting and while matching, of the whole process: libraries, and what
        earlier runs in it left behind, count too.
    machine : Machine
        What it ran on.
    provenance : Provenance
        How it came about.
    created : str
        UTC time at which it was complete, ISO 8601.
    files : dict
        ``sha256:…`` of each array file beside it.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    schema_version: int = SCHEMA_VERSION
    key: RunKey
    protocol: str
    label: str
    n_references: int
    n_queries: int
    partial: bool
    resumed: bool
    order: Literal["shuffled", "sequential"] = "shuffled"
    future: int = 0
    timeout: float | None = None
    fit_seconds: float
    peak_memory: dict[str, int]
    machine: Machine
    provenance: Provenance = Provenance()
    created: str
    files: dict[str, str]


def read_record(path: Path) -> RunRecord:
    """Read a ``run.json``.

    Raises
    ------
    DamagedError
        If it is missing or damaged.
    DataError
        If it cannot be read, or is of a schema that this version does not know.
    """
    if not path.exists():
        raise DamagedError(f"{path} is missing.")
    try:
        with disk_errors(path, "read"):
            content = json.loads(path.read_text("utf-8"))
    except (ValueError, RecursionError) as error:
        raise DamagedError(f"{path} is damaged: {error}.") from None
    found = content.get("schema_version") if isinstance(content, dict) else None
    if type(found) is not int:  # True is an int too
        raise DamagedError(f"{path} is damaged: it states no schema version.")
    if not 1 <= found <= SCHEMA_VERSION:
        raise DataError(
            f"{path} has schema version {found}; this vpr-bench reads 1 to {SCHEMA_VERSION}. Update vpr-bench."
        )
    try:
        record = RunRecord.model_validate(migrated(content, STEPS, SCHEMA_VERSION))
        Protocol.parse(record.protocol)
    except ValidationError as error:
        raise DamagedError(f"{path} is damaged: {first_fault(error)}.") from None
    except UsageError as error:
        raise DamagedError(f"{path} is damaged: {error}") from None
    return record
