"""``vpr-bench check``: whether a plug-in keeps what the harness relies on."""

import sys
from collections import Counter
from collections.abc import Sequence
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from vpr_bench.cli.bars import progress_bars
from vpr_bench.cli.console import show, write
from vpr_bench.cli.listing import TextFormat, TextFormatOption
from vpr_bench.errors import UsageError

if TYPE_CHECKING:
    from vpr_bench.check.outcome import Outcome
    from vpr_bench.check.suite import Suite

S = TypeVar("S")

METHOD_EXAMPLES = """[bold]Examples[/bold]

vpr-bench check method hog

vpr-bench check method my_file.py:MyMethod --param size=64

vpr-bench check method twostage --only map-of-one --format json
"""

_WORDS = {"pass": "passed", "fail": "failed", "skip": "skipped", "expected failure": "failed as expected"}
_STYLES = {"pass": "green", "fail": "bold red", "skip": "dim", "expected failure": "yellow"}

OnlyOption = Annotated[list[str] | None, typer.Option("--only", help="Id of a check; repeat for more.", metavar="ID")]
ParamOption = Annotated[list[str] | None, typer.Option("--param", "-p", help="Parameter name=value; repeat for more.")]

app = typer.Typer(
    help="Check that a method, a dataset or an environment keeps what the harness relies on. Exits with 1 if not.",
    no_args_is_help=True,
)


@app.command("method", epilog=METHOD_EXAMPLES)
def method(
    name: Annotated[str, typer.Argument(help="Name, module:Class or my_file.py:Class.")],
    param: ParamOption = None,
    only: OnlyOption = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the method.")] = 0,
    form: TextFormatOption = "table",
) -> None:
    """Check a method on a small made-up world."""
    from vpr_bench.check.method import METHOD_CHECKS, Subject
    from vpr_bench.method.build import build_method

    METHOD_CHECKS.chosen(only)  # so that a typing error costs no time
    if ":" in name:
        sys.path.append(str(Path.cwd()))  # a console script does not find modules in the current folder
    parameters = _assignments(param)
    with redirect_stdout(sys.stderr):
        label = build_method(name, parameters, seed).label
    _examine("method", label, METHOD_CHECKS, Subject(name, name, parameters, seed=seed), only, form)


@app.command("dataset")
def dataset(
    name: Annotated[str, typer.Argument(help="Dataset id, dataset:edition, or a folder of your own.")],
    only: OnlyOption = None,
    form: TextFormatOption = "table",
) -> None:
    """Check a dataset: its card, its protocols, and the images on disk."""
    from vpr_bench.check.dataset import DATASET_CHECKS, DatasetSubject
    from vpr_bench.dataset.request import Request
    from vpr_bench.dataset.source import Source

    DATASET_CHECKS.chosen(only)
    source = Source.find(Request.parse(name))
    _examine("dataset", source.name, DATASET_CHECKS, DatasetSubject(source), only, form)


@app.command("env")
def env(
    name: Annotated[str, typer.Argument(help="Id of an environment, dataset id, dataset:edition, or a folder.")],
    param: ParamOption = None,
    only: OnlyOption = None,
    form: TextFormatOption = "table",
) -> None:
    """Check a Gymnasium environment."""
    from vpr_bench.check.env import ENV_CHECKS, EnvSubject

    ENV_CHECKS.chosen(only)
    subject = EnvSubject.of(name, {key: _value(text) for key, text in _assignments(param).items()})
    with redirect_stdout(sys.stderr), subject.make():  # what cannot be made is told at once
        pass
    _examine("env", name, ENV_CHECKS, subject, only, form)


def _examine(kind: str, name: str, suite: "Suite[S]", subject: S, only: Sequence[str] | None, form: TextFormat) -> None:
    """Run the checks and print what they come to."""
    from vpr_bench.check.examination import Examination
    from vpr_bench.progress import track

    examination: Examination[S] = Examination(suite, subject, only)
    # Stdout is for results: what a plug-in prints is not one.
    with redirect_stdout(sys.stderr), progress_bars():
        outcomes = [examination.outcome(check.id) for check in track(examination.checks, f"Checking {name}")]
    if form == "json":
        _write_json(kind, name, outcomes)
    else:
        _show(outcomes)
        write(_summary(name, outcomes))
    if any(outcome.result == "fail" for outcome in outcomes):
        raise typer.Exit(1)


def _assignments(texts: Sequence[str] | None) -> dict[str, str]:
    given = {}
    for text in texts or ():
        key, equals, value = text.partition("=")
        if not equals or not key:
            raise UsageError(f"A parameter is written name=value. Got {text!r} instead.")
        given[key] = value
    return given


def _value(text: str) -> Any:
    """Read a number, list or null as JSON has them; all else is text."""
    import json

    try:
        return json.loads(text)
    except ValueError:
        return text


def _write_json(kind: str, name: str, outcomes: "Sequence[Outcome]") -> None:
    import json

    content = {kind: name, "checks": [outcome.as_dict() for outcome in outcomes]}
    write(json.dumps(content, indent=2, ensure_ascii=False))


def _show(outcomes: "Sequence[Outcome]") -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False)
    for column in ("check", "result", "reason"):
        table.add_column(column, overflow="fold")
    for one in outcomes:  # as texts: an exception may say [red]
        table.add_row(Text(one.check), Text(one.result, style=_STYLES[one.result]), Text(one.reason))
    show(table)


def _summary(name: str, outcomes: "Sequence[Outcome]") -> str:
    """Say in one line how many came to what."""
    counts = Counter(_WORDS[one.result] for one in outcomes)
    return f"{name}: {', '.join(f'{counts[word]} {word}' for word in _WORDS.values() if counts[word])}"
