"""How a stored run came about, for people and for programs."""

import shlex
from typing import TYPE_CHECKING, Any

from vpr_bench.cli.details import facts_table

if TYPE_CHECKING:
    from rich.console import RenderableType

    from vpr_bench.runner.store import StoredRun

_UNKNOWN = "not noted"


def provenance_block(run: "StoredRun") -> "RenderableType":
    """Lay out the provenance of a run; what an older version did not note is said to be unknown."""
    from vpr_bench.runner.environment import environment

    record, key, noted = run.record, run.record.key, run.record.provenance
    known = {name: value or _UNKNOWN for name, value in environment(record).items()}
    libraries = ", ".join(f"{name} {version}" for name, version in record.machine.libraries.items())
    timeout = "" if record.timeout is None else f", {record.timeout:g} s for an answer"
    return facts_table(
        {
            "run": str(run.folder),
            "protocol": record.protocol,
            "method": f"{record.label}, version {key.version}",
            "method from": known["method from"],
            "method at": known["method at"],
            "weights": key.weights or "none",
            "dataset": key.dataset_digest,
            "seed, k, limit": f"{key.seed}, {key.k}, {key.limit or 'none'}{timeout}",
            "command": _UNKNOWN if noted.argv is None else shlex.join(noted.argv),
            "started": noted.started or _UNKNOWN,
            "complete": record.created + (", continued after an interruption" if record.resumed else ""),
            "vpr-bench": record.machine.libraries.get("vpr-bench", _UNKNOWN),
            "vpr-bench at": known["vpr-bench at"],
            **{name: known[name] for name in ("processor", "cores", "threads", "memory", "system", "Python", "BLAS")},
            "libraries": libraries,
            "fingerprint": f"{record.machine.fingerprint} (times may be compared where it is the same)",
            "elsewhere": _elsewhere(noted.elsewhere),
        }
    )


def provenance_content(run: "StoredRun") -> dict[str, Any]:
    """Return the provenance of a run, JSON-able; None stands for what was not noted."""
    record, key = run.record, run.record.key
    return {
        "run": str(run.folder),
        "protocol": record.protocol,
        "method": key.method,
        "label": record.label,
        "version": key.version,
        "parameters": key.parameters,
        "weights": key.weights,
        "dataset_digest": key.dataset_digest,
        "seed": key.seed,
        "k": key.k,
        "limit": key.limit,
        "timeout": record.timeout,
        "resumed": record.resumed,
        **record.provenance.model_dump(mode="json"),
        "completed": record.created,
        "machine": {**record.machine.model_dump(mode="json"), "fingerprint": record.machine.fingerprint},
    }


def _elsewhere(share: float | None) -> str:
    if share is None:
        return _UNKNOWN
    return (
        f"{100 * share:.1f} % of the machine's processor time went to other processes while queries were asked "
        "(the nearer to 0, the more the times can be trusted)"
    )
