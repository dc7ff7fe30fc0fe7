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
    named = folder_named_by(DATA_VARIABLE)
    if named is not None:
        return named
    import platformdirs

    return Path(platformdirs.user_data_dir("vpr-bench", appauthor=False))


def folder_named_by(variable: str) -> Path | None:
    """Return the folder that an environment variable names, None if it is empty or not set.

    Raises
    ------
    DataError
        If the variable names something that is not a folder.
    """
    named = os.environ.get(variable)
    if not named:
        return None
    folder = Path(os.path.expanduser(named)).resolve()  # noqa: PTH111 - Path's raises where there is no such user
    if not folder.is_dir():
        raise DataError(f"{variable} names {folder}, which is not a folder. Create it or unset the variable.")
    return folder


def cache_root() -> Path:
    """Return the folder for what can be made again, such as rendered images; it may be deleted at any time."""
    import platformdirs

    return Path(platformdirs.user_cache_dir("vpr-bench", appauthor=False))


def state_root() -> Path:
    """Return the folder for what this machine has learnt and cannot make again, such as digests of first contact."""
    import platformdirs

    return Path(platformdirs.user_state_dir("vpr-bench", appauthor=False))
