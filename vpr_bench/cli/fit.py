"""``vpr-bench fit`` and ``vpr-bench extend``: maps that are kept."""

import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import say, write
from vpr_bench.cli.listing import TextFormatOption, show_facts
from vpr_bench.cli.options import EditionOption, ParamOption, ThreadsOption
from vpr_bench.cli.parameters import find_here, sort_parameters
from vpr_bench.cli.where import say_where
from vpr_bench.errors import UsageError

if TYPE_CHECKING:
    from vpr_bench.maps.references import References
    from vpr_bench.method.build import BuiltMethod

FIT_EXAMPLES = """[bold]Examples[/bold]

vpr-bench fit --method twostage --dataset gardens -o gardens.map

vpr-bench fit --method hog --param cell=16 --dataset gardens --references day_right -o gardens.map

vpr-bench fit --method efficientnet-lite0 --images path/to/photos -o walk.map

vpr-bench fit --method twostage --dataset gardens --preview augmentations.png
"""
EXTEND_EXAMPLES = """[bold]Examples[/bold]

vpr-bench extend gardens.map --references day_right

vpr-bench extend gardens.map --images path/to/photos -o larger.map
"""

MapArgument = Annotated[Path, typer.Argument(help="The map: a folder that `vpr-bench fit` made.", metavar="MAP")]
ImagesOption = Annotated[
    Path | None, typer.Option(help="A folder of images, in the order of their names.", metavar="FOLDER")
]
OverwriteOption = Annotated[bool, typer.Option("--overwrite", help="Put it in the place of another map.")]


def fit(
    method: Annotated[
        str, typer.Option("--method", "-m", help="Name, module:Class or my_file.py:Class.", metavar="NAME")
    ],
    dataset: Annotated[
        str | None,
        typer.Option(
            "--dataset", help="Dataset, dataset:edition, protocol id, or a folder of your own.", metavar="NAME"
        ),
    ] = None,
    images: ImagesOption = None,
    references: Annotated[
        str | None,
        typer.Option(help="A traverse, a part of one, or several joined. Default: the first protocol's."),
    ] = None,
    protocol: Annotated[str | None, typer.Option(help="references-queries: those references.")] = None,
    edition: EditionOption = "auto",
    param: ParamOption = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the method, if it has one.")] = 0,
    threads: ThreadsOption = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The map: a folder, such as gardens.map.", metavar="MAP")
    ] = None,
    overwrite: OverwriteOption = False,
    preview: Annotated[
        Path | None,
        typer.Option(
            help="Only draw some references beside the changed copies that the method learns from.", metavar="FILE.png"
        ),
    ] = None,
    form: TextFormatOption = "table",
) -> None:
    """Fit a method on references and keep the map.

    The same map is not fitted again, and a fit that was interrupted goes on if the same command is given.
    """
    from vpr_bench.method.build import build_method

    if (dataset is None) == (images is None):
        raise UsageError("Say what the map is of: either --dataset or --images.")
    if images is not None and (references or protocol or edition != "auto"):
        raise UsageError("--references, --protocol and --edition are for --dataset, not for --images.")
    if (output is None) == (preview is None):
        raise UsageError("Say where to put the map with --output, or the picture with --preview.")
    with redirect_stdout(sys.stderr), progress_bars():
        built = build_method(method, sort_parameters([method], param or [])[method], seed)
        if preview is not None:
            _check_preview(built, preview)
        found = _references(dataset, images, references, protocol, edition)
        drawn = None if preview is None else _preview(built, found, preview)
        facts = None if output is None else _fit(built, found, output, threads, overwrite)
    if drawn is not None:
        say("Nothing was fitted: leave out --preview to fit.")
        write(str(drawn))
    if facts is not None:
        show_facts(facts, form)


def extend(
    path: MapArgument,
    references: Annotated[
        str | None, typer.Option(help="A traverse, a part of one, or several joined.", metavar="TRAVERSE")
    ] = None,
    images: ImagesOption = None,
    dataset: Annotated[
        str | None, typer.Option("--dataset", help="Of the traverse. Default: the map's.", metavar="NAME")
    ] = None,
    edition: EditionOption = "auto",
    method: Annotated[
        str | None,
        typer.Option("--method", "-m", help="Where the map's method is, if it is not installed.", metavar="NAME"),
    ] = None,
    threads: ThreadsOption = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Leave the map as it is, and write another.", metavar="MAP")
    ] = None,
    overwrite: OverwriteOption = False,
    form: TextFormatOption = "table",
) -> None:
    """Add references to a map, behind those that it has, without fitting it anew."""
    from vpr_bench.cli.map_facts import describe_map
    from vpr_bench.maps.extend import extend_map
    from vpr_bench.maps.map import load_map

    if (images is None) == (references is None):
        raise UsageError("Say what to add: either --references or --images.")
    if images is not None and (dataset or edition != "auto"):
        raise UsageError("--dataset and --edition are for --references, not for --images.")
    with redirect_stdout(sys.stderr), progress_bars():
        if references is not None and dataset is None:
            first = next((part for part in load_map(path).record.parts if part.dataset is not None), None)
            if first is None:
                raise UsageError(f"{path} was made of a folder of images: say which --dataset has {references!r}.")
            dataset = first.folder or first.dataset
            edition = first.edition if edition == "auto" else edition
        find_here(*([method] if method else []))
        found = _references(dataset, images, references, None, edition)
        extended = extend_map(path, found, output, method=method, threads=threads, overwrite=overwrite)
    show_facts(describe_map(extended), form)


def _references(
    dataset: str | None, images: Path | None, references: str | None, protocol: str | None, edition: str
) -> "References":
    from vpr_bench.maps.references import of_dataset, of_folder

    if dataset is None:
        return of_folder(images or Path())
    found = of_dataset(dataset, references, protocol, edition)
    chosen = edition != "auto" or ":" in dataset
    say_where(found.part.dataset or dataset, found.part.edition, found.base, chosen=chosen)
    return found


def _fit(
    built: "BuiltMethod", found: "References", output: Path, threads: int | None, overwrite: bool
) -> dict[str, object]:
    from vpr_bench.cli.map_facts import describe_map
    from vpr_bench.maps.fit import check_persistent, find_map, fit_map

    check_persistent(built)
    there = None if overwrite else find_map(built, found, output)
    say(f"{built.label} on {found.part}: {'fitted already' if there else 'fitting'}")
    return describe_map(there or fit_map(built, found, output, threads=threads, overwrite=overwrite))


def _check_preview(built: "BuiltMethod", file: Path) -> None:
    from vpr_bench.method.interfaces import Augmenting
    from vpr_bench.report.figure import check_picture

    check_picture(file, ["png"])
    if not isinstance(built.method, Augmenting):
        raise UsageError(f"The method {built.id!r} learns from no changed copies that could be drawn (augmented()).")


def _preview(built: "BuiltMethod", found: "References", file: Path) -> Path:
    from vpr_bench.method.interfaces import Augmenting
    from vpr_bench.report.augmentation_sheet import draw_augmentations

    assert isinstance(built.method, Augmenting)  # noqa: S101 - _check_preview() has checked it
    simulated = found.part.edition == "simulated"
    return draw_augmentations(built, built.method, found.traverse, str(found.part), file, simulated=simulated)
