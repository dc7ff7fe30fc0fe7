"""Progress bars with a rate and an estimate, on stderr, only where it is a terminal."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext

from vpr_bench.cli.console import stderr
from vpr_bench.progress import Advance, listen


def progress_bars() -> AbstractContextManager[None]:
    """Show the progress of everything inside the ``with`` block."""
    return listen(_bar) if stderr().is_terminal else nullcontext()


@contextmanager
def _bar(description: str, total: int | None) -> Iterator[Advance]:
    from rich.markup import escape
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        ProgressColumn,
        Task,
        TextColumn,
        TimeRemainingColumn,
    )
    from rich.text import Text

    class Rate(ProgressColumn):
        """Steps per second."""

        def render(self, task: Task) -> Text:
            speed = task.finished_speed or task.speed
            return Text("" if speed is None else f"{speed:,.1f}/s", style="progress.data.speed")

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        Rate(),
        TimeRemainingColumn(elapsed_when_finished=True),
    )
    with Progress(*columns, console=stderr(), transient=True) as progress:
        bar = progress.add_task(escape(description), total=total)
        yield lambda steps: progress.advance(bar, steps)
