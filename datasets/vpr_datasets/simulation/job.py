"""The order that a worker gets, and the files that it writes."""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import cv2
from pydantic import BaseModel, ConfigDict, Field

from vpr_datasets.simulation.files import Files
from vpr_datasets.simulation.frame import render_frame
from vpr_datasets.simulation.mosaic import mosaic
from vpr_datasets.simulation.spec import SimulationSpec

PNG_EFFORT = 4
"""Of 9: more makes files little smaller, and takes longer than rendering them."""


class Job(BaseModel):
    """One worker's share of a simulation: every ``workers``-th image, beginning with number ``worker``."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    spec: SimulationSpec
    folder: Path
    files: Files
    worker: Annotated[int, Field(ge=0)]
    workers: Annotated[int, Field(ge=1)]

    def carry_out(self) -> Iterator[Path]:
        """Render the images of this job; yields the path of each once it is written."""
        # The traverses take turns, so that walls seen from one are still in the processor's cache.
        for index, name in _shots(self.spec)[self.worker :: self.workers]:
            path = self.files.path(self.folder, name, index)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(_shoot(self.spec, name, index, path.suffix))
            yield path


def _shoot(spec: SimulationSpec, name: str, index: int, suffix: str) -> bytes:
    """Render one image and return it as a file."""
    image = render_frame(spec, name, index)
    stored = image[..., ::-1] if spec.bayer is None else mosaic(image, spec.bayer)
    options = [cv2.IMWRITE_JPEG_QUALITY, spec.quality, cv2.IMWRITE_PNG_COMPRESSION, PNG_EFFORT]
    done, data = cv2.imencode(suffix, stored, options)
    if not done:
        raise OSError(f"could not encode image {index} of {name} as {suffix}")
    return bytes(data.tobytes())


def _shots(spec: SimulationSpec) -> list[tuple[int, str]]:
    most = max(spec.frames_of(traverse) for traverse in spec.traverses)
    return [(index, one.name) for index in range(most) for one in spec.traverses if index < spec.frames_of(one)]
