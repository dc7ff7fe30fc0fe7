"""``vpr-bench locate``: where photos were taken, by a map that was kept."""

import sys
import time
from collections.abc import Iterator
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from vpr_bench.cli import INTERRUPTED
from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import complain, say
from vpr_bench.cli.fit import MapArgument
from vpr_bench.cli.options import ThreadsOption
from vpr_bench.cli.parameters import find_here, split_assignment
from vpr_bench.errors import DataError, VprBenchError

if TYPE_CHECKING:
    from vpr_bench.maps.answer import Answer, Photo

LOCATE_EXAMPLES = """[bold]Examples[/bold]

vpr-bench locate gardens.map photo.jpg

vpr-bench locate gardens.map photo.jpg another.jpg folder/of/photos -k 3 --show answers.png

vpr-bench locate gardens.map photo.jpg --param n_components=1 --format json
"""

_FEW = 8  # photos that are not worth a progress bar


def locate(
    path: MapArgument,
    photos: Annotated[list[Path], typer.Argument(help="Images, or folders of images.", metavar="PHOTO…")],
    k: Annotated[int | None, typer.Option("-k", "--k", help="How many places for each. Default: 5.")] = None,
    picture: Annotated[
        Path | None,
        typer.Option("--show", help="Draw each photo beside its places.", metavar="FILE.png"),
    ] = None,
    method: Annotated[
        str | None,
        typer.Option("--method", "-m", help="Where the map's method is, if it is not installed.", metavar="NAME"),
    ] = None,
    param: Annotated[
        list[str] | None,
        typer.Option("--param", "-p", help="name=value instead of the map's own; for what only matters to answers."),
    ] = None,
    threads: ThreadsOption = None,
    verify: Annotated[
        bool,
        typer.Option("--verify", help="Read every byte of the map, however large it is, to see whether it is whole."),
    ] = False,
    form: Annotated[
        Literal["table", "json", "csv"], typer.Option("--format", "-f", help="How to write the result to stdout.")
    ] = "table",
) -> None:
    """Say where photos were taken: ranked places of a map, with scores and times."""
    from vpr_bench.cli.answers import print_answers
    from vpr_bench.cores import available_cores
    from vpr_bench.maps.map import load_map
    from vpr_bench.report.figure import check_picture
    from vpr_bench.runner.resources import limit_threads

    if picture is not None:
        check_picture(picture, ["png"])
    given = dict(map(split_assignment, param or []))
    failures: list[int] = []
    answers: list[Answer] = []
    with redirect_stdout(sys.stderr), progress_bars():
        start = time.perf_counter()
        find_here(*([method] if method else []))
        asked = load_map(path, method=method, parameters=given, verify=verify)
        wanted = min(5, len(asked)) if k is None else k
        asked.check_k(wanted)
        _ = asked.method
        loaded = time.perf_counter() - start
        try:
            with limit_threads(threads or available_cores()):
                answers += asked.locate_each(_readable(photos, failures), wanted)
        except KeyboardInterrupt:
            failures.append(INTERRUPTED)
        except VprBenchError as error:
            complain(str(error))
            failures.append(error.exit_code)
    print_answers(asked, answers, loaded, form)
    if picture is not None and answers:
        from vpr_bench.report.answer_sheet import draw_answers

        with progress_bars():
            say(str(draw_answers(asked, answers, picture, lambda message: say(f"warning: {message}"))))
    if failures:
        raise typer.Exit(max(failures))


def _readable(words: list[Path], failures: list[int]) -> Iterator["Photo"]:
    """Read one photo after the other; complain of what is none, and go on."""
    from vpr_bench.maps.map import read_photo
    from vpr_bench.progress import track

    files = list(_files(words, failures))
    for file in track(files, "Locating") if len(files) > _FEW else files:
        try:
            yield read_photo(file)
        except DataError as error:
            complain(str(error))
            failures.append(error.exit_code)


def _files(words: list[Path], failures: list[int]) -> Iterator[Path]:
    from vpr_bench.files.images import some_listed

    for word in words:
        try:
            yield from some_listed(word) if word.is_dir() else [word]
        except DataError as error:
            complain(str(error))
            failures.append(error.exit_code)
