"""The simulated edition as a dataset's card asks for it."""

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from vpr_bench.errors import DataError, first_fault
from vpr_datasets.simulation import SIMULATION_VERSION, SimulationSpec, render


class SimulatedEdition:
    """What a card's ``[simulation]`` describes.

    Parameters
    ----------
    options : mapping
        The fields of :class:`~vpr_datasets.simulation.spec.SimulationSpec`.

    Raises
    ------
    DataError
        If they do not describe a simulation; names the first field that is wrong.
    """

    def __init__(self, options: Mapping[str, Any]) -> None:
        try:
            self.spec = SimulationSpec.model_validate(options)
        except ValidationError as error:
            raise DataError(f"The card's simulation is not valid: {first_fault(error)}.") from None

    def fingerprint(self) -> str:
        """Return what changes whenever a pixel does: a digest of the description and the renderer's version."""
        described = f"{SIMULATION_VERSION} {self.spec.model_dump_json()}"
        return hashlib.sha256(described.encode()).hexdigest()[:12]

    def render(self, folder: Path) -> None:
        """Write every image into ``folder``."""
        render(self.spec, folder)
