"""What a method keeps on disk."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from vpr_bench.check.method.agreement import expect_same
from vpr_bench.check.method.asking import ask, blaming_method, fit
from vpr_bench.check.method.pickles import is_pickle
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import ANSWERS, as_map, picture, usual_map, usual_queries
from vpr_bench.check.outcome import Failed, Skipped
from vpr_bench.check.suite import check
from vpr_bench.method.interfaces import Persistent
from vpr_bench.types.traverse import Traverse


@contextmanager
def _saved(subject: Subject, references: Traverse) -> Iterator[Path]:
    """Yield a folder with a fitted method, which does not lie where it was saved to."""
    method = subject.make()
    if not isinstance(method, Persistent):
        raise Skipped("it has no save and load")
    with tempfile.TemporaryDirectory(prefix="vpr-bench-check-") as folder:
        first, last = Path(folder, "first"), Path(folder, "last")
        first.mkdir()
        fit(method, references)
        with blaming_method("save"):
            try:
                method.save(first)
            except NotImplementedError as error:
                raise Skipped(f"it cannot be kept: {error}") from None
        yield first.rename(last)


@check("save-load-round-trip", "same-seed-same-answer")
def save_load_round_trip(subject: Subject) -> None:
    """Check that a new one that loads what was saved answers the same, wherever the folder lies by then."""
    with _saved(subject, usual_map()) as folder:
        method = subject.make()
        assert isinstance(method, Persistent)  # noqa: S101
        with blaming_method("load"):
            loaded = method.load(folder)
        if not hasattr(loaded, "match"):
            raise Failed(f"load returns a {type(loaded).__name__} instead of the method")
    # The folder is gone: what is needed has been read.
    expect_same(subject.usual_answers, ask(loaded, usual_queries(), ANSWERS), "after save and load")


@check("pickles-nothing", "save-load-round-trip")
def pickles_nothing(subject: Subject) -> None:
    """Check that what it saves holds no pickles, which may run anything when they are loaded."""
    with _saved(subject, as_map([picture(0), picture(1)])) as folder:
        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            if is_pickle(file.read_bytes()):
                raise Failed(f"{file.relative_to(folder)} is a pickle, or holds one")


CHECKS = (save_load_round_trip, pickles_nothing)
