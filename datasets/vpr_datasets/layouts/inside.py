"""Files that a card names, which may be anybody's: they lie in the folder where they are looked for."""

from pathlib import Path, PurePosixPath

from vpr_bench.errors import DataError


def inside(folder: Path, name: object) -> Path:
    """Return a file in a folder, by the name that an option gives it.

    Raises
    ------
    DataError
        If it is no name, or leads out of the folder.

    Examples
    --------
    >>> inside(Path("data"), "more/GT.npz").as_posix()
    'data/more/GT.npz'
    """
    path = PurePosixPath(name) if isinstance(name, str) else PurePosixPath()
    if not path.parts or path.is_absolute() or ".." in path.parts or any(mark in str(path) for mark in "\\:\0"):
        raise DataError(
            f"An option names {name!r:.100}, which is no file in {folder}. Write it relative to the folder."
        )
    return folder / path
