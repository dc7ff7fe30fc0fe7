"""What there is to know about a map."""

from typing import Any

from vpr_bench.errors import one_line
from vpr_bench.files.disk import readable_size
from vpr_bench.maps.map import Map
from vpr_bench.maps.record import RECORD


def describe_map(described: Map) -> dict[str, Any]:
    """Return the facts about a map, each a text or a number; ``references`` and ``parameters`` are lists of parts."""
    record = described.record
    method = record.method
    size = sum(facts.size for facts in record.files.values()) + (described.folder / RECORD).stat().st_size
    return {
        "map": str(described.folder),
        "method": one_line(method.id),
        "version": one_line(method.version),
        "parameters": [
            {"parameter": one_line(name), "value": one_line(value)} for name, value in method.parameters.items()
        ],
        "weights": one_line(method.weights or "none"),
        "references": [{"from": str(part), "images": len(part.names), "digest": part.digest} for part in record.parts],
        "n_references": len(described),
        "bytes": size,
        "size": f"{readable_size(size)}, {readable_size(size / len(described))} per reference",
        "fit_seconds": round(record.fit_seconds, 3),
        "made": f"{one_line(record.created)} by vpr-bench {one_line(record.package)}",
        "machine": one_line(f"{record.machine.processor}, {record.machine.threads} threads, {record.machine.system}"),
    }
