"""What the numbers were measured with: versions and hardware."""

import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from vpr_bench.cores import available_cores

_LIBRARIES = ("vpr-bench", "numpy", "opencv-python-headless", "pillow", "scikit-learn", "torch")


class Machine(BaseModel):
    """The computer and the libraries of a run."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    system: str
    processor: str
    cores: int
    threads: int
    python: str
    libraries: dict[str, str]


def describe_machine(threads: int) -> Machine:
    """Describe this computer, with the number of threads that numerical libraries may use."""
    return Machine(
        system=platform.platform(),
        processor=_processor(),
        cores=available_cores(),
        threads=threads,
        python=platform.python_version(),
        libraries={name: found for name in _LIBRARIES if (found := installed(name))},
    )


def installed(distribution: str) -> str | None:
    """Return the version of an installed distribution, None if it is not."""
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    if information.is_file():
        for line in information.read_text("utf-8", errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
