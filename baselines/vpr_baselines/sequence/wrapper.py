"""What all sequence methods share: a single-image method inside, whose similarities they follow over time."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from vpr_baselines.sequence.rows import contrasted, similarity_row
from vpr_bench.method.build import build_method
from vpr_bench.method.interfaces import Method, Persistent, is_sequential
from vpr_bench.shortlist import collect_shortlists
from vpr_bench.types.traverse import Traverse

_SIZE_FILE, _INNER_FOLDER = "size.json", "inner"


@dataclass
class SequenceWrapper:
    """Fits the method inside and turns each frame into a row of contrasted similarities.

    Parameters
    ----------
    inner : Method or str
        Says how similar an image is to each reference; by its name, or made already.
    contrast : int
        Neighbourhood in references that a similarity is compared with; 0 takes the whole map.
    """

    sequential: ClassVar[bool] = True

    inner: Method | str = "hog"
    contrast: Annotated[int, Field(ge=0)] = 80

    def __post_init__(self) -> None:
        """Make the method inside, if only its name was given.

        Raises
        ------
        ValueError
            If that is a sequence method itself.
        """
        self._method = build_method(self.inner).method if isinstance(self.inner, str) else self.inner
        if is_sequential(self._method):
            raise ValueError("inner must be a method for single images, not a sequence method")

    def fit(self, references: Traverse) -> None:
        """Fit the method inside."""
        self._method.fit(references)
        self.size_ = len(references)
        self.reset()

    def reset(self) -> None:
        """Forget the queries so far."""

    def row(self, image: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the (N,) float32 contrasted similarities of a (H, W, 3) uint8 RGB frame to all references."""
        with collect_shortlists():  # what the method inside rules out for one frame, the sequence may still answer
            row = similarity_row(self._method, image, self.size_)
        return contrasted(row, self.contrast)

    def save(self, folder: Path) -> None:
        """Write the map of the method inside.

        Raises
        ------
        NotImplementedError
            If that method cannot be kept on disk.
        """
        if not isinstance(self._method, Persistent):
            raise NotImplementedError("the method inside cannot be kept on disk")
        (folder / _INNER_FOLDER).mkdir()
        self._method.save(folder / _INNER_FOLDER)
        (folder / _SIZE_FILE).write_text(json.dumps(self.size_), "utf-8")

    def load(self, folder: Path) -> Self:
        """Read what :meth:`save` wrote."""
        if isinstance(self._method, Persistent):
            self._method = self._method.load(folder / _INNER_FOLDER)
        self.size_ = int(json.loads((folder / _SIZE_FILE).read_text("utf-8")))
        self.reset()
        return self
