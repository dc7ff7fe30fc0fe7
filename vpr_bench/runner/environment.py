"""What a run was done in, as words, and where two runs differ in it: there to look if answers or times differ."""

from typing import NamedTuple

from vpr_bench.runner.record import RunRecord


class Difference(NamedTuple):
    """One part of the environment that two runs do not share; None where it was not noted."""

    what: str
    first: str | None
    second: str | None


def environment(record: RunRecord) -> dict[str, str | None]:
    """Return every part of a run's environment by name; None where it was not noted."""
    machine, noted = record.machine, record.provenance
    return {
        "vpr-bench at": None if noted.source is None else str(noted.source),
        "method from": noted.origin,
        "method at": None if noted.method_source is None else str(noted.method_source),
        "system": machine.system,
        "processor": machine.processor,
        "cores": str(machine.cores),
        "threads": str(machine.threads),
        "memory": None if machine.memory_bytes is None else f"{machine.memory_bytes / 2**30:.1f} GiB",
        "Python": machine.python,
        "BLAS": None if machine.blas is None else ", ".join(machine.blas),
        **machine.libraries,
    }


def differences(first: RunRecord, second: RunRecord) -> list[Difference]:
    """Return the parts of the environment in which two runs differ, or that only one of them noted."""
    mine, others = environment(first), environment(second)
    return [
        Difference(what, mine.get(what), others.get(what))
        for what in dict.fromkeys([*mine, *others])
        if mine.get(what) != others.get(what)
    ]
