"""Digests of files, written as ``sha256:<64 hexadecimal digits>``."""

import hashlib
import re
from pathlib import Path

from vpr_bench.errors import DataError, UsageError
from vpr_bench.files.disk import disk_errors


def sha256_of_file(path: Path) -> str:
    """Return the digest of a file's content, as ``sha256:<hex>``.

    Raises
    ------
    DataError
        If the file cannot be read.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "hello.txt")
    ...     _ = path.write_bytes(b"hello")
    ...     sha256_of_file(path)[:20]
    'sha256:2cf24dba5fb0a'
    """
    with disk_errors(path, "read"), path.open("rb") as file:
        return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}"


def parse_digest(text: str) -> str:
    """Return a digest in its canonical (lower-case) form.

    Raises
    ------
    UsageError
        If ``text`` is not of the form ``sha256:<64 hexadecimal digits>``.

    Examples
    --------
    >>> parse_digest("sha256:" + "AB" * 32) == "sha256:" + "ab" * 32
    True
    >>> parse_digest("md5:0123")
    Traceback (most recent call last):
    vpr_bench.errors.UsageError: A digest is written as 'sha256:<64 hexadecimal digits>'. Got 'md5:0123'.
    """
    digest = text.strip().lower()
    if not re.fullmatch(r"sha256:[0-9a-f]{64}", digest):
        raise UsageError(f"A digest is written as 'sha256:<64 hexadecimal digits>'. Got {text!r}.")
    return digest


def check_digest(path: Path, expected: str, *, name: str | None = None, advice: str | None = None) -> None:
    """Compare a file with the digest that it should have.

    Parameters
    ----------
    path
        The file.
    expected
        Its digest, as ``sha256:<hex>``.
    name
        What the message calls the file (default: its path).
    advice
        What the message tells the reader to do when the digest differs.

    Raises
    ------
    DataError
        If the digest differs, or the file cannot be read.
    UsageError
        If ``expected`` is not a digest.
    """
    expected = parse_digest(expected)
    found = sha256_of_file(path)
    if found != expected:
        advice = advice or "The file is damaged or another version: delete it and get it again."
        raise DataError(f"{name or path} has digest {found}, expected {expected}.\n{advice}")
