"""What lies in the folders of a dataset and is no image: litter of operating systems, and pickles."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from vpr_bench.dataset.card import Card
from vpr_bench.dataset.lint.finding import Finding, counted, listed
from vpr_bench.dataset.recording import Recording

_LITTER = frozenset({".ds_store", "thumbs.db", "ehthumbs.db", "desktop.ini", "__macosx", ".directory", "@eadir"})
_PICKLES = frozenset({".pkl", ".pickle", ".p"})
_MATLAB = frozenset({".mat"})


def find_junk(card: Card, folder: Path, traverses: Mapping[str, Recording]) -> list[Finding]:
    """Look through a dataset's folder, those of its traverses and those of their images; nothing is opened.

    Parameters
    ----------
    card : Card
        Names the files that belong there.
    folder : Path
        Holds the traverses.
    traverses : dict of str to Recording
        By name.
    """
    known = set(_texts(card.loader.options)) | {text for one in card.given for text in _texts(one.options)}
    known |= {text for one in card.traverses for text in _texts(one.options)}
    findings = []
    places = [folder, *(folder / card.traverse(name).path for name in traverses)]
    sources = (source for one in traverses.values() for source in one.traverse.sources)
    places += [source.parent for source in sources if isinstance(source, Path)]
    for place in dict.fromkeys(places):
        called = str(place.relative_to(folder)) if place.is_relative_to(folder) and place != folder else str(place)
        names = sorted(entry.name for entry in place.iterdir()) if place.is_dir() else []
        litter = [name for name in names if name.lower() in _LITTER or name.startswith("._")]
        pickles = [name for name in names if Path(name).suffix.lower() in _PICKLES and name not in litter]
        matlab = [name for name in names if Path(name).suffix.lower() in _MATLAB and name not in {*litter, *known}]
        if litter:
            message = f"{counted(len(litter), 'file')} of an operating system, passed by: {listed(litter)}"
            findings.append(Finding("junk-files", "note", called, message))
        if pickles:
            message = (
                f"{counted(len(pickles), 'pickle')}, never read, since to read one is to run it: {listed(pickles)}"
            )
            findings.append(Finding("junk-files", "warning", called, message))
        if matlab:
            message = f"{counted(len(matlab), 'MATLAB file')} that nothing here names: {listed(matlab)}"
            findings.append(Finding("junk-files", "note", called, message))
    return findings


def _texts(options: Any) -> Iterator[str]:
    """Go through all texts in the options of a layout: some name files."""
    if isinstance(options, str):
        yield options.rpartition("/")[2]
    elif isinstance(options, dict | list):
        for value in options.values() if isinstance(options, dict) else options:
            yield from _texts(value)
