"""Options that several commands share."""

import re
from pathlib import Path
from typing import Annotated, Literal

import typer

from vpr_bench.errors import UsageError
from vpr_bench.types.protocol import Unmatched

Format = Literal["table", "json", "csv", "markdown"]
"""How results are written to stdout."""

FormatOption = Annotated[Format, typer.Option("--format", "-f", help="How to write the result to stdout.")]
OutputOption = Annotated[
    Path, typer.Option("--output", "-o", "--runs", help="Folder that holds the runs.", file_okay=False)
]
RadiusOption = Annotated[
    list[str] | None,
    typer.Option(help="Radius instead of the protocol's own; several (0,1,2,5 or 0..10) are swept.", metavar="R[,R…]"),
]
EditionOption = Annotated[
    str,
    typer.Option(help="real, simulated, or another one that the dataset has; auto: real if on disk, else simulated."),
]
UnmatchedOption = Annotated[Unmatched | None, typer.Option(help="What becomes of queries without a true match.")]
BootstrapOption = Annotated[
    int, typer.Option("--bootstrap", help="Resamples for 95 % intervals over queries; 0 for none.", min=0, metavar="N")
]
ParamOption = Annotated[
    list[str] | None,
    typer.Option("--param", "-p", help="name=value; method.name=value for one of several, inner.name=value inside."),
]
ThreadsOption = Annotated[int | None, typer.Option(min=1, help="Of numerical libraries. Default: all cores.")]
MetricOption = Annotated[list[str] | None, typer.Option("--metric", help="Metric id; repeat for more.")]

PlotStepsOption = Annotated[
    Path | None,
    typer.Option("--plot-stages", help="Draw where the right place was lost, stage by stage.", metavar="FILE.png"),
]

RUNS = Path("runs")
_MOST_RADII = 1000


def parse_radii(texts: list[str] | None) -> list[float] | None:
    """Read ``--radius 0,1,2``, given once or several times; ``0..10`` stands for the whole numbers from 0 to 10.

    Raises
    ------
    UsageError
        If one of them is not a number of at least 0, or there are very many.
    """
    if not texts:
        return None
    radii: list[float] = []
    for part in ",".join(texts).split(","):
        if whole := re.fullmatch(r"\s*([0-9]{1,9})\.\.([0-9]{1,9})\s*", part):
            first, last = int(whole[1]), int(whole[2])
            if not 0 <= last - first < _MOST_RADII:
                raise UsageError(
                    f"A range of radii goes up, and over at most {_MOST_RADII}. Got {part.strip()!r} instead."
                )
            radii += map(float, range(first, last + 1))
            continue
        try:
            radius = float(part)
        except ValueError:
            radius = -1.0
        if not 0 <= radius < float("inf"):
            raise UsageError(f"A radius must be a number of at least 0. Got {part.strip()!r} instead.")
        radii.append(radius)
    return list(dict.fromkeys(radii))
