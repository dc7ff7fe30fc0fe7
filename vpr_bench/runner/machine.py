"""What the numbers were measured with: versions and hardware."""

import hashlib
import platform
import re
import shutil
import subprocess
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from vpr_bench.cores import available_cores

_OURSELVES = "vpr-bench"


class Machine(BaseModel):
    """The computer and the libraries of a run.

    Attributes
    ----------
    system : str
        Operating system with its version.
    processor : str
        As it calls itself.
    cores, threads : int
        How many cores there were for us, and how many threads numerical libraries were allowed.
    memory_bytes : int or None
        Of the whole machine; None where it was not noted.
    python : str
        Version.
    libraries : dict
        vpr-bench and the distributions that it depends on, as far as they are installed also those that are optional,
        by name with their versions.
    blas : list of str or None
        The libraries that multiply matrices and share out threads, with version and instruction set; None where it was
        not noted.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    system: str
    processor: str
    cores: int
    threads: int
    memory_bytes: int | None = None
    python: str
    libraries: dict[str, str]
    blas: list[str] | None = None

    @property
    def fingerprint(self) -> str:
        """Eight hexadecimal digits that are the same where times may be compared.

        They stand for the processor, its cores, the threads, the memory to the GiB and the kind of system. Versions
        of libraries are left out: what a new one costs is to be seen.
        """
        memory = None if self.memory_bytes is None else round(self.memory_bytes / 2**30)
        kind = self.system.partition("-")[0]
        facts = "|".join(map(str, (self.processor, self.cores, self.threads, memory, kind)))
        return hashlib.sha256(facts.encode()).hexdigest()[:8]

    def __str__(self) -> str:
        """Say in a few words which machine it is."""
        memory = "" if self.memory_bytes is None else f", {self.memory_bytes / 2**30:.0f} GiB"
        cores = f"{self.cores} core{'s' * (self.cores != 1)}, {self.threads} thread{'s' * (self.threads != 1)}"
        return f"{self.processor}, {cores}{memory}, {self.system.partition('-')[0]}"


def describe_machine(threads: int) -> Machine:
    """Describe this computer, with the number of threads that numerical libraries may use."""
    import psutil

    return Machine(
        system=platform.platform(),
        processor=_processor(),
        cores=available_cores(),
        threads=threads,
        memory_bytes=psutil.virtual_memory().total,
        python=platform.python_version(),
        libraries={name: found for name in (_OURSELVES, *_dependencies()) if (found := installed(name))},
        blas=_blas(),
    )


def installed(distribution: str) -> str | None:
    """Return the version of an installed distribution, None if it is not."""
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def _dependencies() -> list[str]:
    try:
        lines = requires(_OURSELVES) or []
    except PackageNotFoundError:  # taken from its sources, without being installed
        return []
    used = [line for line in lines if not re.search("""extra == ['"]dev['"]""", line)]
    return sorted({re.split(r"[^A-Za-z0-9._-]", line, maxsplit=1)[0] for line in used})


def _blas() -> list[str]:
    from threadpoolctl import threadpool_info

    parts = ("internal_api", "version", "threading_layer", "architecture")
    return sorted({" ".join(str(one[part]) for part in parts if one.get(part)) for one in threadpool_info()})


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    found = _from_cpuinfo(information.read_text("utf-8", errors="replace")) if information.is_file() else _from_sysctl()
    return found or platform.processor() or platform.machine()


def _from_cpuinfo(text: str) -> str:
    """Return the processor's name; on ARM, which gives none, the numbers of its maker and its kind."""
    facts: dict[str, str] = {}
    for line in text.splitlines():
        name, _, value = line.partition(":")
        facts.setdefault(name.strip(), value.strip())
    numbers = [facts[name] for name in ("CPU implementer", "CPU part") if name in facts]
    return facts.get("model name") or " ".join([platform.machine(), *numbers] if numbers else [])


def _from_sysctl() -> str:
    """Return the processor's name as macOS knows it; nothing elsewhere."""
    sysctl = shutil.which("sysctl")
    if sysctl is None:
        return ""
    done = subprocess.run(  # noqa: S603
        [sysctl, "-n", "machdep.cpu.brand_string"], capture_output=True, text=True, check=False
    )
    return done.stdout.strip()
