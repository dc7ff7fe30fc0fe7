"""Options that several commands share."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from vpr_bench.errors import UsageError
from vpr_bench.types.protocol import Unmatched

Format = Literal["table", "json", "csv"]
"""How results are written to stdout."""

FormatOption = Annotated[Format, typer.Option("--format", "-f", help="How to write the result to stdout.")]
OutputOption = Annotated[Path, typer.Option("--output", "-o", help="Folder that holds the runs.", file_okay=False)]
RadiusOption = Annotated[
    list[str] | None,
    typer.Option(help="Radius instead of the protocol's own; several (0,1,2,5) are swept.", metavar="R[,R…]"),
]
EditionOption = Annotated[
    str,
    typer.Option(help="real, simulated, or another one that the dataset has; auto: real if on disk, else simulated."),
]
UnmatchedOption = Annotated[Unmatched | None, typer.Option(help="What becomes of queries without a true match.")]
BootstrapOption = Annotated[
    int, typer.Option("--bootstrap", help="Resamples for 95 % intervals over queries; 0 for none.", min=0, metavar="N")
]
MetricOption = Annotated[list[str] | None, typer.Option("--metric", help="Metric id; repeat for more.")]

RUNS = Path("runs")


def parse_radii(texts: list[str] | None) -> list[float] | None:
    """Read ``--radius 0,1,2``, given once or several times.

    Raises
    ------
    UsageError
        If one of them is not a number of at least 0.
    """
    if not texts:
        return None
    radii = []
    for part in ",".join(texts).split(","):
        try:
            radius = float(part)
        except ValueError:
            radius = -1.0
        if not 0 <= radius < float("inf"):
            raise UsageError(f"A radius must be a number of at least 0. Got {part.strip()!r} instead.")
        radii.append(radius)
    return list(dict.fromkeys(radii))
