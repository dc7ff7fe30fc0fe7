"""Whether a run's times can be held against others: only what ran on a quiet machine can."""

BUSY = 0.1
"""Share of the machine's processor time that other processes may take before times say little about the method."""


def doubt(elsewhere: float | None) -> str:
    """Say what speaks against a run's times, as the beginning of a sentence; nothing if they are fair.

    Parameters
    ----------
    elsewhere : float or None
        As in :class:`~vpr_bench.runner.provenance.Provenance`.

    Examples
    --------
    >>> doubt(0.02), doubt(0.25)
    ('', "other processes took 25% of the machine's processor time")
    """
    if elsewhere is None:
        return "what else the machine did was not noted"
    if elsewhere > BUSY:
        return f"other processes took {elsewhere:.0%} of the machine's processor time"
    return ""
