"""Writing what a method has learnt, whatever the method does while it writes."""

import shutil
from pathlib import Path

from vpr_bench.errors import blaming, one_line
from vpr_bench.files.disk import DiskError
from vpr_bench.method.interfaces import Method, Persistent


def save_fitted(method: Method, folder: Path, called: str) -> bool:
    """Write a fitted method into a new folder; return whether it can be kept on disk at all.

    Parameters
    ----------
    method : Method
        Fitted.
    folder : Path
        What is there is deleted.
    called : str
        What to call the method in errors.

    Raises
    ------
    DataError
        If the disk refuses.
    VprBenchError
        If the method fails.
    """
    if not isinstance(method, Persistent):
        return False
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with blaming(f"The method {called!r} failed while saving its map to {folder}"):
        try:
            method.save(folder)
        except NotImplementedError:  # a wrapper around a method that is not persistent
            return False
        except OSError as error:  # NumPy's has no errno when the disk is full
            raise DiskError(
                f"Cannot write {folder}: {one_line(error)}. Free some space, or choose another --output."
            ) from error
    return True
