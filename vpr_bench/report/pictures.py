"""The images that a stored run was asked about, found again."""

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.load import Case, load_case
from vpr_bench.errors import DataError, VprBenchError
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
    """

    def __init__(self, run: StoredRun, warn: Callable[[str], None], dataset: str | None = None) -> None:
        self._run = run
        self._warn = warn
        self._dataset = dataset

    @cached_property
    def case(self) -> Case | None:
        """The images and places, None if they are not here as they were."""
        key, protocol = self._run.record.key, self._run.protocol
        try:
            case = (
                load_case(self._dataset, f"{protocol.pairing}@{protocol.reach}")
                if self._dataset
                else load_case(str(protocol))
            )
            if case.digest != key.dataset_digest:
                raise DataError(
                    f"they are not those of the run: {key.dataset_digest:.15}… then, {case.digest:.15}… now."
                )
        except VprBenchError as error:
            self._warn(f"The images of {key.source}/{key.pairing} cannot be shown: {error}")
            return None
        return case

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
