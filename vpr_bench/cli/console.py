"""Where things are printed: results on stdout, everything else on stderr."""

import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING, NoReturn, TextIO

from vpr_bench.errors import DataError

if TYPE_CHECKING:
    from rich.console import Console, RenderableType

_WIDE = 200  # columns of a table that goes to a file or a pipe, where nothing has to fit a window


@cache
def stderr() -> "Console":
    """Return the console of messages and progress bars."""
    from rich.console import Console

    return Console(stderr=True, highlight=False)


def show(result: "RenderableType") -> None:
    """Print a result for people on stdout; what is wider than a terminal is left to it to wrap."""
    from rich.console import Console

    terminal = sys.stdout is not None and sys.stdout.isatty()  # None where it was closed
    with _on_stdout():
        Console(width=None if terminal else _WIDE, highlight=False).print(result, crop=False)


def write(text: str) -> None:
    """Print a result for programs on stdout, as it is."""
    if sys.stdout is not None:
        with _on_stdout():
            sys.stdout.write(text + "\n")
            sys.stdout.flush()


@contextmanager
def _on_stdout() -> Iterator[None]:
    """End well if the reader has read enough; say so if it is a file on a disk that is full."""
    try:
        yield
    except BrokenPipeError:
        _reader_has_gone()
    except SystemExit:  # by the library that draws tables, which has met the same
        _reader_has_gone()
    except OSError as error:
        raise DataError(f"Cannot write to stdout: {error.strerror or error}.") from None


def _reader_has_gone() -> NoReturn:
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    raise SystemExit(0)


def say(message: str) -> None:
    """Print a message on stderr, nothing in it taken for markup."""
    stderr().print(message, markup=False, soft_wrap=True)


def complain(message: str) -> None:
    """Print an error on stderr."""
    from rich.text import Text

    stderr().print(Text.assemble(("error: ", "bold red"), message), soft_wrap=True)


@contextmanager
def notes_on_stderr() -> Iterator[None]:
    """Print the project's own warnings as one line each instead of Python's two with a source line."""
    usual = warnings.showwarning

    def note(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        if category.__module__.startswith("vpr_"):
            say(f"warning: {message}")
        else:
            usual(message, category, filename, lineno, file, line)

    with warnings.catch_warnings():
        warnings.showwarning = note
        yield
