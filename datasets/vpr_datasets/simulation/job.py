"""The order that a worker gets, and the files that it writes."""

from collections.abc import Iterator
from pathlib import Path
from string import Formatter
from typing import Annotated

import cv2
from pydantic import BaseModel, ConfigDict, Field

from vpr_datasets.simulation.frame import render_frame
from vpr_datasets.simulation.spec import SimulationSpec


class Job(BaseModel):
    """One worker's share of a simulation: every ``workers``-th image, beginning with number ``worker``."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    spec: SimulationSpec
    folder: Path
    pattern: str
    worker: Annotated[int, Field(ge=0)]
    workers: Annotated[int, Field(ge=1)]

    def carry_out(self) -> Iterator[Path]:
        """Render the images of this job; yields the path of each once it is written."""
        # The traverses take turns, so that walls seen from one are still in the processor's cache.
        shots = _shots(self.spec)
        for index, name in shots[self.worker :: self.workers]:
            path = self.folder / self.pattern.format(traverse=name, index=index)
            path.parent.mkdir(parents=True, exist_ok=True)
            image = render_frame(self.spec, name, index)
            done, data = cv2.imencode(path.suffix, image[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, self.spec.quality])
            if not done:
                raise OSError(f"could not encode {path}")
            path.write_bytes(data.tobytes())
            yield path


def _shots(spec: SimulationSpec) -> list[tuple[int, str]]:
    most = max(spec.frames_of(traverse) for traverse in spec.traverses)
    return [(index, one.name) for index in range(most) for one in spec.traverses if index < spec.frames_of(one)]


def check_pattern(pattern: str) -> None:
    """Refuse a pattern that would not give every image a JPEG of its own inside the folder."""
    try:
        fields = {name for _, name, _, _ in Formatter().parse(pattern) if name is not None}
        first = pattern.format(traverse="a", index=0)
    except (ValueError, KeyError, IndexError) as error:
        raise ValueError(f"not a pattern for file names: {pattern!r} ({error})") from error
    path = Path(first)
    if fields != {"traverse", "index"} or path.suffix.lower() not in (".jpg", ".jpeg"):
        raise ValueError(f"the pattern must hold {{traverse}} and {{index}} and end in .jpg, got {pattern!r}")
    if path.is_absolute() or ".." in path.parts:
        raise ValueError(f"the pattern must stay inside the folder, got {pattern!r}")
