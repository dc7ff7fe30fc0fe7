"""Images that are not quite usual."""

from collections.abc import Sequence

import numpy as np

from vpr_bench.check.method.answers import expect_matches
from vpr_bench.check.method.asking import ask, fit
from vpr_bench.check.method.subject import Subject
from vpr_bench.check.method.world import HEIGHT, WIDTH, Image, as_map, picture
from vpr_bench.check.suite import check

_SIZES = ((WIDTH, HEIGHT), (HEIGHT, WIDTH), (127, 95), (32, 24))


def _expect_answers(subject: Subject, references: Sequence[Image], queries: Sequence[Image], what: str) -> None:
    method = subject.make()
    fit(method, as_map(references), f"on {what}")
    expect_matches(ask(method, queries, len(references), f"on {what}"), len(references), len(references), f"on {what}")


@check("grey-images", "answers-are-matches")
def grey_images(subject: Subject) -> None:
    """Check that images may be without colour: three equal channels."""
    first, second = (np.repeat(picture(place)[:, :, :1], 3, axis=2) for place in (0, 1))
    _expect_answers(subject, [first, second], [second, picture(0, again=True)], "grey images")


@check("odd-sizes", "answers-are-matches")
def odd_sizes(subject: Subject) -> None:
    """Check that images may be upright, of odd width, tiny, and of another size than their neighbours."""
    references = [picture(place, width=width, height=height) for place, (width, height) in enumerate(_SIZES)]
    queries = [
        picture(place, again=True, width=width, height=height) for place, (width, height) in enumerate(_SIZES[::-1])
    ]
    _expect_answers(subject, references, queries, "images of mixed and odd sizes")


@check("featureless-images", "answers-are-matches")
def featureless_images(subject: Subject) -> None:
    """Check that there is a valid answer to an image that is all black, as in a tunnel, or all white."""
    black, white = np.zeros((HEIGHT, WIDTH, 3), np.uint8), np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    _expect_answers(
        subject, [picture(0), black, white], [black, white, picture(0, again=True)], "black or white images"
    )


CHECKS = (grey_images, odd_sizes, featureless_images)
