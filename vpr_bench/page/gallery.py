"""Pictures of what a run got wrong, and of what it got right by little: what each one shows and says."""

from collections.abc import Callable
from typing import Any

from vpr_bench.errors import one_line
from vpr_bench.page.album import Album
from vpr_bench.page.examples import Example, examples_of
from vpr_bench.page.radii import distance
from vpr_bench.report.pictures import RunPictures
from vpr_bench.runner.store import StoredRun
from vpr_bench.types.protocol import Protocol
from vpr_bench.types.traverse import Traverse


class Galleries:
    """Makes the galleries of runs; the images of a pairing are looked for once, and each is embedded once.

    Parameters
    ----------
    album : Album
        Takes the pictures.
    warn : callable
        Told once, in one line, why there are no images.
    """

    def __init__(self, album: Album, warn: Callable[[str], None]) -> None:
        self._album = album
        self._warn = warn
        self._pictures: dict[tuple[str, str, str], RunPictures] = {}

    def gallery(self, run: StoredRun, protocol: Protocol) -> dict[str, Any]:
        """Return what the page's script needs to show the examples of a run.

        Parameters
        ----------
        run : StoredRun
            Whose examples.
        protocol : Protocol
            Says what is right.

        Returns
        -------
        dict
            ``failures`` and ``successes``, each a list of panels: query, answer, truth.
        """
        key = run.record.key
        images = (key.source, key.pairing, key.dataset_digest)
        pictures = self._pictures.setdefault(images, RunPictures(run, self._warn))
        found, k = examples_of(run, protocol), run.indices.shape[1]
        return {
            name: [self._panels(one, pictures, protocol, k) for one in examples]
            for name, examples in (("failures", found.failures), ("successes", found.successes))
        }

    def has_images(self, run: StoredRun) -> bool:
        """Say whether the images of a run are here."""
        key = run.record.key
        pictures = self._pictures.get((key.source, key.pairing, key.dataset_digest))
        return pictures is not None and pictures.case is not None

    def _panels(self, one: Example, pictures: RunPictures, protocol: Protocol, k: int) -> list[dict[str, Any]]:
        return [
            self._panel("Query", pictures, "query", one.query, ""),
            self._panel("Answer", pictures, "reference", one.answer, _answer_note(one, protocol)),
            self._panel("True place", pictures, "reference", one.truth, _truth_note(one, k)),
        ]

    def _panel(self, title: str, pictures: RunPictures, role: str, index: int | None, note: str) -> dict[str, Any]:
        if index is None:
            return {"title": title, "name": "", "note": note, "picture": None}
        name = (pictures.query_name if role == "query" else pictures.reference_name)(index)
        picture = None
        if (case := pictures.case) is not None:
            traverse = case.queries if role == "query" else case.references
            decode = pictures.query_image if role == "query" else pictures.reference_image
            picture = self._album.add(_identity(traverse, index, case.digest), lambda: decode(index))
        return {"title": title, "name": one_line(name), "note": note, "picture": picture}


def _identity(traverse: Traverse, index: int, digest: str) -> tuple[str, str]:
    """Tell a picture from all others: by its file, which several pairings may share."""
    source = traverse.sources[index]
    return ("file", str(source)) if hasattr(source, "suffix") else (digest, traverse.name_of(index))


def _answer_note(one: Example, protocol: Protocol) -> str:
    if one.score is None:
        return "nothing answered"
    away = "" if one.away is None else f", {distance(one.away, protocol)} away"
    return f"score {one.score:.4g}{away}"


def _truth_note(one: Example, k: int) -> str:
    if one.truth is None:
        return "the map does not show this place"
    if one.truth_rank is None or one.truth_score is None:
        return f"not among the first {k} answers"
    return f"score {one.truth_score:.4g}, answer {one.truth_rank} of {k}"
