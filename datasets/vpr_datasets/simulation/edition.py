"""The simulated edition as a dataset's card asks for it."""

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from vpr_bench.errors import DataError, first_fault
from vpr_datasets.simulation import SIMULATION_VERSION
from vpr_datasets.simulation.beside import KINDS, writer
from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.spec import SimulationSpec


class SimulatedEdition:
    """What a card's ``[simulation]`` describes.

    Parameters
    ----------
    options : mapping
        The fields of :class:`~vpr_datasets.simulation.spec.SimulationSpec` and of
        :class:`~vpr_datasets.simulation.files.Files`.

    Raises
    ------
    DataError
        If they do not describe a simulation; names the first field that is wrong.
    """

    def __init__(self, options: Mapping[str, Any]) -> None:
        naming = {key: value for key, value in options.items() if key in Files.model_fields}
        try:
            self.spec = SimulationSpec.model_validate({key: options[key] for key in options if key not in naming})
            self.files = Files.model_validate(naming)
        except ValidationError as error:
            raise DataError(f"The card's simulation is not valid: {first_fault(error)}.") from None
        unknown = [kind for kind in self.files.beside if kind not in KINDS]
        if unknown:
            known = ", ".join(KINDS)
            raise DataError(f"The card's simulation is not valid: beside: {unknown[0]!r} is none of {known}.")
        if self.spec.bayer is not None and not self.files.lossless:
            raise DataError("The card's simulation is not valid: pattern: raw pictures are stored as .png only.")

    def fingerprint(self) -> str:
        """Return what changes whenever a pixel or a name does: a digest of the description and the version."""
        described = f"{SIMULATION_VERSION} {self.spec.model_dump_json()} {self.files.model_dump_json()}"
        return hashlib.sha256(described.encode()).hexdigest()[:12]

    def render(self, folder: Path) -> None:
        """Write every image into ``folder``, and what the dataset has beside them."""
        from vpr_datasets.simulation.rendering import render

        render(self.spec, folder, files=self.files)
        for kind in self.files.beside:
            writer(kind)(self.spec, Path(folder), self.files)
