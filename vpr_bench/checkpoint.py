"""What a long fit has computed so far, kept so that an interrupted one goes on where it stopped.

A method stores the results of its long steps with :func:`kept`, or from within a loop with :func:`save_checkpoint`.
Whoever fits it says with :func:`checkpoints` where they are kept; when nobody does, a step costs one context-variable
look-up and nothing is written.

The folder stands for one fit: same method, version, parameters, weights and images. Within it a name stands for the
n-th use of that name in the order of the fit, so that two methods inside one never read each other's results; what
is computed inside :func:`kept` has names of its own. A fit must therefore take its steps in the same order each time;
where a loop may go on from the middle, the number of the round belongs in the name.
"""

import shutil
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import quote

from numpy.typing import NDArray

from vpr_bench.errors import DataError
from vpr_bench.files.atomic import read_arrays, write_arrays
from vpr_bench.files.disk import disk_errors

Arrays = Mapping[str, NDArray[Any]]


class CheckpointWarning(UserWarning):
    """Something that was kept cannot be read, or something cannot be kept; it costs time and nothing else."""


@dataclass
class Checkpoints:
    """The results that one fit keeps.

    Attributes
    ----------
    folder : Path
        Where they are; made when the first one is stored.
    resumed : bool
        Whether something was there that an interrupted fit had stored.
    """

    folder: Path
    resumed: bool = False
    _uses: Counter[str] = field(default_factory=Counter)

    def load(self, name: str) -> dict[str, NDArray[Any]] | None:
        """Begin to use a name; return what an interrupted fit stored under it."""
        self._uses[name] += 1
        path = self._path(name)
        if not path.exists():
            return None
        try:
            arrays = read_arrays(path)
        except DataError as error:
            warnings.warn(f"{error} It is computed again.", CheckpointWarning, stacklevel=3)
            return None
        self.resumed = True
        return arrays

    def save(self, name: str, arrays: Arrays) -> None:
        """Store arrays under a name that is in use, over what was stored before."""
        self._uses[name] = max(self._uses[name], 1)
        path = self._path(name)
        try:
            with disk_errors(path):
                path.parent.mkdir(parents=True, exist_ok=True)
            write_arrays(path, arrays)
        except DataError as error:  # the fit itself may well succeed
            warnings.warn(f"{error} The fit goes on, and could not be continued here.", CheckpointWarning, stacklevel=3)

    @contextmanager
    def inside(self, name: str) -> Iterator[None]:
        """Keep what is computed inside the ``with`` block apart, and drop it once it has served."""
        inner = Checkpoints(self._path(name).with_suffix(""))
        token = _checkpoints.set(inner)
        try:
            yield
        finally:
            _checkpoints.reset(token)
            self.resumed |= inner.resumed

    def close(self, name: str) -> None:
        """Drop what was kept inside a result that is stored itself by now."""
        shutil.rmtree(self._path(name).with_suffix(""), ignore_errors=True)

    def _path(self, name: str) -> Path:
        # A plus sign is none that quote() leaves in a name.
        return self.folder / f"{quote(name, safe='')}+{self._uses[name]}.npz"


_checkpoints: ContextVar[Checkpoints | None] = ContextVar("checkpoints", default=None)


@contextmanager
def checkpoints(folder: Path) -> Iterator[Checkpoints]:
    """Keep in ``folder`` what is computed inside the ``with`` block, and give back what is kept there.

    The folder is made when it is needed, and left for the caller to delete once the result is safe.
    """
    kept_here = Checkpoints(folder)
    token = _checkpoints.set(kept_here)
    try:
        yield kept_here
    finally:
        _checkpoints.reset(token)


def kept(name: str, compute: Callable[[], Arrays]) -> dict[str, NDArray[Any]]:
    """Return what an interrupted fit stored under a name, else compute and store it.

    Parameters
    ----------
    name : str
        What it is, for example ``descriptors``.
    compute : callable
        Returns named arrays of numbers or strings, which are given back as they are. It may keep steps of its own:
        their names are apart from those outside.

    Examples
    --------
    >>> import numpy as np
    >>> kept("squares", lambda: {"squares": np.arange(3) ** 2})["squares"]
    array([0, 1, 4])
    """
    listening = _checkpoints.get()
    if listening is None:
        return dict(compute())
    stored = listening.load(name)
    if stored is not None:
        return stored
    with listening.inside(name):
        arrays = dict(compute())
    listening.save(name, arrays)
    listening.close(name)
    return arrays


def load_checkpoint(name: str) -> dict[str, NDArray[Any]] | None:
    """Return what an interrupted fit last stored under a name, None if nothing or if nobody keeps it.

    Call it once, before the loop that calls :func:`save_checkpoint` with the same name.
    """
    listening = _checkpoints.get()
    return None if listening is None else listening.load(name)


def save_checkpoint(name: str, arrays: Arrays) -> None:
    """Store named arrays of numbers or strings under a name, over what was stored before; for every round of a loop."""
    listening = _checkpoints.get()
    if listening is not None:
        listening.save(name, arrays)
