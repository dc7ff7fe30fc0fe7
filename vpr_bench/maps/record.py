"""``map.json``: everything about a map except what its method has learnt. It may have been written by anybody."""

import hashlib
import json
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from vpr_bench.errors import DamagedError, DataError, first_fault, one_line
from vpr_bench.files.atomic import write_bytes
from vpr_bench.files.npy import read_limited
from vpr_bench.maps.commands import fit_again
from vpr_bench.runner.machine import Machine

SCHEMA_VERSION = 1
RECORD, STATE = "map.json", "state"

LIMIT = 512_000_000
"""Bytes: a larger ``map.json`` is not read; a million references take about 60 MB."""


def _inside(name: str) -> str:
    """Check that a name stays inside the folder that it is relative to, on any system."""
    for path in (PurePosixPath(name), PureWindowsPath(name)):
        if not path.parts or path.is_absolute() or path.drive or path.root or ".." in path.parts or "\0" in name:
            raise ValueError("must be the relative path of a file, and not lead out of its folder")
    return name


RelativePath = Annotated[str, Field(max_length=4096), AfterValidator(_inside)]
Digest = Annotated[str, Field(pattern="^sha256:[0-9a-f]{64}$")]
_Number = Annotated[float, Field(allow_inf_nan=False)]
_Text = Annotated[str, Field(max_length=4096)]


class _Strict(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)


class StoredFile(_Strict):
    """Size in bytes and digest of one file."""

    size: Annotated[int, Field(ge=0, lt=2**63)]
    digest: Digest


class Fitted(_Strict):
    """The method that made a map: what must be the same for the map to be understood."""

    id: _Text
    version: _Text
    parameters: dict[str, Any]
    weights: _Text | None
    label: _Text


class Part(_Strict):
    """References that came into the map together.

    Attributes
    ----------
    dataset : str or None
        Its id; None for folders of one's own.
    folder : str or None
        Of one's own images or dataset; None where the dataset says where its images are.
    edition : str
        Where the images came from: ``real``, ``simulated`` or another one of the dataset.
    traverse : str
        Its name, with parts and joined ones as in a protocol; of a folder of images, the folder's.
    digest : str
        Over the content of the images, their order and place labels.
    names : tuple of str
        Paths of the images, relative to the folder of the dataset or of the images, in the order of the map.
    places : tuple, optional
        Place labels: a number each, or a position in metres.
    """

    dataset: Annotated[str, Field(pattern="^[a-z0-9][a-z0-9-]*$", max_length=200)] | None
    folder: _Text | None
    edition: _Text
    traverse: _Text
    digest: Digest
    names: Annotated[tuple[RelativePath, ...], Field(min_length=1, strict=False)]
    places: Annotated[tuple[_Number | tuple[_Number, ...], ...] | None, Field(strict=False)] = None

    @model_validator(mode="after")
    def _check(self) -> "Part":
        if self.places is not None and len(self.places) != len(self.names):
            raise ValueError(f"{len(self.names)} references have {len(self.places)} places")
        if self.dataset is None and self.folder is None:
            raise ValueError("images come from a dataset or from a folder")
        return self

    def __str__(self) -> str:
        """Write where the references come from, as for a person."""
        if self.dataset is None:
            return one_line(self.folder)
        edition = "" if self.edition == "real" else f":{self.edition}"
        return one_line(f"{self.dataset}{edition}/{self.traverse}")


class MapRecord(_Strict):
    """One map.

    Attributes
    ----------
    package : str
        Version of vpr-bench that wrote it.
    method : Fitted
        What made it.
    parts : tuple of Part
        What it was fitted on, and what was added later.
    fit_seconds : float
        Wall time of fitting and extending, decoding included; where a fit was continued, of its last stretch.
    created : str
        UTC, when it was last written.
    files : dict
        Every file of its ``state`` folder.
    """

    schema_version: int = SCHEMA_VERSION
    package: _Text
    method: Fitted
    parts: Annotated[tuple[Part, ...], Field(min_length=1, strict=False)]
    fit_seconds: Annotated[float, Field(ge=0, allow_inf_nan=False)]
    machine: Machine
    created: _Text
    files: dict[RelativePath, StoredFile]

    @property
    def n_references(self) -> int:
        """How many references there are."""
        return sum(len(part.names) for part in self.parts)

    def locate(self, reference: int) -> tuple[Part, int]:
        """Return the part that a reference belongs to, and its number there."""
        for part in self.parts:
            if reference < len(part.names):
                return part, reference
            reference -= len(part.names)
        raise IndexError(reference)


def write_record(record: MapRecord, folder: Path) -> None:
    """Write a ``map.json``, with a digest over all of it."""
    content = record.model_dump(mode="json")
    content["digest"] = _digest(content)
    write_bytes(folder / RECORD, json.dumps(content, indent=1).encode())


def read_map_record(folder: Path) -> MapRecord:
    """Read a ``map.json``.

    Raises
    ------
    DamagedError
        If it is not as it was written.
    DataError
        If there is no map, or it is of a schema that this version does not know; says how to make it again.
    """
    path = folder / RECORD
    if not path.exists():
        raise DataError(_absent(folder))
    try:
        content = json.loads(read_limited(path, LIMIT))
    except (ValueError, RecursionError) as error:
        raise DamagedError(f"{path} is damaged: {one_line(error):.200}. {fit_again(None, folder)}") from None
    if not isinstance(content, dict):
        raise DamagedError(f"{path} is damaged: it holds no record. {fit_again(None, folder)}")
    found = content.get("schema_version")
    if type(found) is int and found != SCHEMA_VERSION:
        by = one_line(content.get("package"))
        raise DataError(
            f"{path} was made by vpr-bench {by:.40} in another format: schema version {found:.6g}, "
            f"and this one reads {SCHEMA_VERSION}. {fit_again(content, folder)}"
        )
    if content.pop("digest", None) != _digest(content):
        raise DamagedError(f"{path} was changed after it was written. {fit_again(content, folder)}")
    try:
        return MapRecord.model_validate_json(json.dumps(content))
    except ValidationError as error:
        raise DamagedError(f"{path} is refused: {one_line(first_fault(error)):.300}.") from None


def _digest(content: dict[str, Any]) -> str:
    """Return the digest of everything else: it tells edits and damage, and vouches for nobody."""
    canonical = json.dumps(content, sort_keys=True, separators=(",", ":"))
    return f"sha256:{hashlib.sha256(canonical.encode()).hexdigest()}"


def _absent(folder: Path) -> str:
    if folder.with_name(folder.name + ".partial").exists():
        return f"The map {folder} is unfinished. Give the command that was interrupted again, and it goes on."
    if folder.exists():
        return f"{folder} is not a map: it has no {RECORD}. Maps are made with `vpr-bench fit`."
    return f"There is no map {folder}. Make one with `vpr-bench fit --method … --dataset … -o {folder}`."
