"""Where images and caches lie on this machine."""

import os
from pathlib import Path

from vpr_bench.errors import DataError

DATA_VARIABLE = "VPR_BENCH_DATA"
"""Environment variable that names the data root."""


def data_root() -> Path:
    """Return the folder that holds one folder per dataset: ``$VPR_BENCH_DATA``, else the user's data folder.

    Raises
    ------
    DataError
        If the variable names something that is not a folder.
    """
    named = os.environ.get(DATA_VARIABLE)
    if named:
        root = Path(os.path.expanduser(named)).resolve()  # noqa: PTH111 - Path's raises where there is no such user
        if not root.is_dir():
            raise DataError(f"{DATA_VARIABLE} names {root}, which is not a folder. Create it or unset the variable.")
        return root
    import platformdirs

    return Path(platformdirs.user_data_dir("vpr-bench", appauthor=False))


def cache_root() -> Path:
    """Return the folder for what can be made again, such as rendered images; it may be deleted at any time."""
    import platformdirs

    return Path(platformdirs.user_cache_dir("vpr-bench", appauthor=False))


def state_root() -> Path:
    """Return the folder for what this machine has learnt and cannot make again, such as digests of first contact."""
    import platformdirs

    return Path(platformdirs.user_state_dir("vpr-bench", appauthor=False))
