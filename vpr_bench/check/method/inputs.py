"""What a method is shown belongs to others."""

import numpy as np

from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import Image, picture, revisited
from vpr_bench.check.outcome import Failed
from vpr_bench.check.suite import check
from vpr_bench.types.traverse import Traverse


class _Lent:
    """Images that were handed out, with a copy of how they were.

    Parameters
    ----------
    writable : bool
        Whether they can be written to.
    """

    def __init__(self, *, writable: bool) -> None:
        self._writable = writable
        self._images: list[tuple[Image, Image]] = []

    def __call__(self, image: Image) -> Image:
        """Lend an image."""
        image = image.copy()
        self._images.append((image, image.copy()))
        image.flags.writeable = self._writable
        return image

    def changed(self) -> bool:
        """Say whether one of them is no longer what it was."""
        return any(not np.array_equal(image, before) for image, before in self._images)


@check("input-unmodified", "answers-are-matches")
def input_unmodified(subject: Subject) -> None:
    """Check that references and queries are left as they are, and may be read-only."""
    sources = [picture(place) for place in range(2)]
    lent = _Lent(writable=True), _Lent(writable=True)
    method = subject.make()
    fit(method, Traverse("made-up map", sources, lent[0]))
    ask(method, [lent[1](image) for image in revisited([0, 1])], 2)
    for what, images in zip(("references in fit", "the query in match"), lent, strict=True):
        if images.changed():
            raise Failed(f"it writes into {what}: work on a copy")
    sealed, method = _Lent(writable=False), subject.make()
    fit(method, Traverse("made-up map", sources, sealed), "on read-only images")
    ask(method, [sealed(image) for image in revisited([0, 1])], 2, "on read-only images")


CHECKS = (input_unmodified,)
