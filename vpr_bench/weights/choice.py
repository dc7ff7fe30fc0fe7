"""The parameter ``weights`` of a method: a training set, a file, or random numbers asked for by name."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from vpr_bench.errors import DataError, UsageError, closest
from vpr_bench.weights.card import WEIGHTS, WeightsCard, find_weights_card
from vpr_bench.weights.digest import file_digest, weights_digest
from vpr_bench.weights.place import find_file

if TYPE_CHECKING:
    from torch import Tensor

RANDOM = "random"
"""Stands for random numbers as weights; nobody gets them by mistake."""


@dataclass(frozen=True)
class WeightsChoice:
    """Weights of one architecture: of a card, of a file, or (with neither) random.

    Attributes
    ----------
    architecture : str
        The network's.
    card : WeightsCard, optional
        Of registered weights.
    file : Path, optional
        The user's own file.
    seed : int
        Of random weights.
    """

    architecture: str
    card: WeightsCard | None = None
    file: Path | None = None
    seed: int = 0

    @property
    def random(self) -> bool:
        """Whether nothing is loaded."""
        return self.card is None and self.file is None

    def identity(self) -> str:
        """Return what stands in a result: architecture, origin, and the digest of the file.

        Raises
        ------
        DataError
            If the weights are not here, or not the right ones; says how to get them.
        """
        if self.card is not None:
            return f"{self.architecture} ({self.card.training_set}) {weights_digest(self.card)}"
        if self.file is not None:
            return f"{self.architecture} ({self.file.name}) {file_digest(_existing(self.file))}"
        return f"{self.architecture} (random, seed {self.seed})"

    def tensors(self) -> "dict[str, Tensor]":
        """Read the weights; none if they are random.

        Raises
        ------
        DataError
            If they are not here or cannot be read.
        """
        from vpr_bench.weights.checkpoint import load_checkpoint

        if self.random:
            return {}
        path = find_file(self.card) if self.card is not None else _existing(self.file or Path())
        return load_checkpoint(path)

    def __str__(self) -> str:
        """Write what messages call the weights."""
        return self.card.id if self.card else str(self.file) if self.file else f"random {self.architecture}"


def choose_weights(architecture: str, asked: str, seed: int = 0) -> WeightsChoice:
    """Find out what the value of a parameter ``weights`` means.

    Parameters
    ----------
    architecture : str
        The network's name, with which the ids of its weights begin.
    asked : str
        The rest of such an id (``imagenet``, ``places365``), the path of a file, or ``random``.
    seed : int
        Of random weights.

    Raises
    ------
    UsageError
        If it means nothing; the closest training set is suggested.
    """
    if asked == RANDOM:
        return WeightsChoice(architecture, seed=seed)
    start = f"{architecture}-"
    known = [entry.name.removeprefix(start) for entry in WEIGHTS.entries() if entry.name.startswith(start)]
    if asked in known:
        return WeightsChoice(architecture, find_weights_card(start + asked))
    path = Path(asked).expanduser()
    if path.suffix or path.parent != Path() or path.is_file():
        return WeightsChoice(architecture, file=path)
    near = closest(asked, [*known, RANDOM])
    raise UsageError(f"There are no weights {asked!r} of {architecture}. {near} A file is given by its path.")


def _existing(file: Path) -> Path:
    if not file.is_file():
        raise DataError(f"The weights {file} are not there. `vpr-bench weights list` says which can be fetched.")
    return file
