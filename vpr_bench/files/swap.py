"""Putting one folder in the place of another, so that one of the two is there whenever a process is killed."""

import shutil
from pathlib import Path


def swap_in(new: Path, place: Path) -> None:
    """Move the folder ``new`` to ``place``, and delete what was there; whoever calls it holds a lock."""
    former = former_of(place)
    if not place.exists():
        new.replace(place)
        return
    place.replace(former)
    new.replace(place)
    shutil.rmtree(former, ignore_errors=True)


def recover(place: Path) -> None:
    """Undo what :func:`swap_in` had begun when its process was killed between its two renames."""
    former = former_of(place)
    if former.exists():
        if place.exists():
            shutil.rmtree(former)
        else:
            former.replace(place)


def former_of(place: Path) -> Path:
    """Return where what was in a place is, until the swap is complete."""
    return place.with_name(place.name + ".former")
