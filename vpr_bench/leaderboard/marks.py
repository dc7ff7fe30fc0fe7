"""The marks that stand beside names and numbers, the same in every table."""

from vpr_bench.leaderboard.entry import Entry

TIED, SEQUENTIAL, NO_TIME = "=", "†", "‡"


def name_marks(entry: Entry) -> str:
    """Return what follows the name of a method that sees more than one image: ``†``, or ``†+5`` if it waits for 5."""
    if entry.future:
        return f" {SEQUENTIAL}+{entry.future}"
    return f" {SEQUENTIAL}" if entry.sequential else ""


def name_notes(entries: list[Entry]) -> list[str]:
    """Explain those marks, as far as they occur."""
    notes = []
    if any(one.sequential for one in entries):
        notes.append(f"`{SEQUENTIAL}` uses the queries before the one that is asked; the others see one image.")
    if any(one.future for one in entries):
        notes.append(f"`{SEQUENTIAL}+N` waits for N further frames before it answers; its times are without the wait.")
    return notes
