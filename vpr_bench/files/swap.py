"""Putting one folder in the place of another, so that one of the two is there whenever a process is killed."""

import shutil
from pathlib import Path


def swap_in(new: Path, place: Path) -> None:
    """Move the folder ``new`` to ``place``, and delete what was there; whoever calls it holds a lock."""
    former = _former(place)
    if place.exists():
        place.replace(former)
    new.replace(place)
    shutil.rmtree(former, ignore_errors=True)


def recover(place: Path) -> None:
    """Undo what :func:`swap_in` had begun when its process was killed between its two renames."""
    former = _former(place)
    if former.exists():
        if place.exists():
            shutil.rmtree(former)
        else:
            former.replace(place)


def _former(place: Path) -> Path:
    return place.with_name(place.name + ".former")
