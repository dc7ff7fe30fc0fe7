"""The images that a stored run was asked about, found again."""

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DataError, VprBenchError
from vpr_bench.runner.images import OtherImagesError, case_of
from vpr_bench.runner.store import StoredRun


class RunPictures:
    """Names and images of a run's queries and references; what is not here any more has a number and no image.

    Parameters
    ----------
    run : StoredRun
        Its dataset is looked for when something is asked for the first time, and taken only if its content is that
        of the run.
    warn : callable
        Told once, in one line, why there are no images, and of each that cannot be decoded.
    dataset : str, optional
        Where the images are, as for :func:`~vpr_bench.dataset.load.load_case`: a folder of one's own is not found by
        its name.
    render : bool
        Render simulated images that are not here yet: worth it to look at them, and not for their names.
    """

    def __init__(
        self, run: StoredRun, warn: Callable[[str], None], dataset: str | None = None, *, render: bool = True
    ) -> None:
        self._run = run
        self._warn = warn
        self._dataset = dataset
        self._render = render

    @cached_property
    def case(self) -> Case | None:
        """The images and places, None if they are not here as they were."""
        key = self._run.record.key
        try:
            return case_of(self._run.protocol, key.dataset_digest, self._dataset, render=self._render)
        except OtherImagesError as other:
            why = f"they are not those of the run: {other.recorded:.15}… then, {other.found:.15}… now."
        except VprBenchError as error:
            why = str(error)
        self._warn(f"The images of {key.source}/{key.pairing} cannot be shown: {why}")
        return None

    def query_name(self, query: int) -> str:
        """Return the file name of a query, with its traverse, or its number."""
        return f"query {query}" if self.case is None else self.case.queries.name_of(query)

    def reference_name(self, reference: int) -> str:
        """Return the file name of a reference, with its traverse, or its number."""
        return f"reference {reference}" if self.case is None else self.case.references.name_of(reference)

    def query_image(self, query: int) -> NDArray[np.uint8] | None:
        """Return a query, (H, W, 3) uint8 RGB, None if it is not here."""
        return self._decoded("queries", query)

    def reference_image(self, reference: int) -> NDArray[np.uint8] | None:
        """Return a reference, (H, W, 3) uint8 RGB, None if it is not here."""
        return self._decoded("references", reference)

    def _decoded(self, role: str, index: int) -> NDArray[np.uint8] | None:
        if self.case is None:
            return None
        try:
            return (self.case.queries if role == "queries" else self.case.references)[index]
        except DataError as error:
            self._warn(str(error))
            return None
