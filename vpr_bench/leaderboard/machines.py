"""The machines of a leaderboard, by letters."""

import string
from collections.abc import Iterable

from vpr_bench.leaderboard.entry import Entry, moment


def machine_letters(entries: Iterable[Entry]) -> dict[str, str]:
    """Give every machine a letter, by fingerprint: A to Z, then AA, AB and so on.

    New rows of the same machines change no letter.

    Returns
    -------
    dict
        Fingerprint to letter.
    """
    machines = sorted({entry.machine for entry in entries})
    return {machine: _letter(number) for number, machine in enumerate(machines)}


def machine_names(entries: Iterable[Entry]) -> dict[str, str]:
    """Say in a few words which machine a fingerprint stands for."""
    return {entry.machine: entry.machine_about for entry in sorted(entries, key=lambda one: moment(one.created))}


def _letter(number: int) -> str:
    r"""Write a number from 0 as spreadsheets name their columns.

    Examples
    --------
    >>> _letter(0), _letter(25), _letter(26)
    ('A', 'Z', 'AA')
    """
    more, rest = divmod(number, len(string.ascii_uppercase))
    return (_letter(more - 1) if more else "") + string.ascii_uppercase[rest]
