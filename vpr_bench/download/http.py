"""One file over HTTP: resumed where it broke off, tried again when it breaks, verified before it is there."""

import time
from pathlib import Path

from vpr_bench.download.address import readable_url
from vpr_bench.download.partial import Partial
from vpr_bench.download.transfer import BY_HAND, MAX_REDIRECTS, BrokenOffError, transfer
from vpr_bench.errors import DataError
from vpr_bench.files.digest import check_digest, parse_digest
from vpr_bench.files.disk import disk_errors

_PROGRESS = 1024 * 1024  # bytes that a try must bring so as not to count as one of the attempts


def download(
    url: str,
    target: Path,
    *,
    sha256: str | None = None,
    max_bytes: int | None = None,
    attempts: int = 5,
    pause_s: float = 1.0,
    timeout_s: float = 30.0,
) -> Path:
    """Download one file.

    Bytes are collected in ``<target>.part``. A broken transfer, in this call or in an earlier one that was
    killed, continues there if the server can continue the same version of the file. ``target`` appears only
    when the file is complete and its digest is right. Callers that may collide hold a lock.

    Parameters
    ----------
    url
        An ``http`` or ``https`` address. User name, password and query never appear in messages.
    target
        Where the file goes; its folder is made if needed, a file of that name is replaced.
    sha256
        The digest that the file must have, as ``sha256:<hex>``.
    max_bytes
        The most that the file may hold.
    attempts
        Tries in a row that may fail with little or nothing gained. A server that cannot be reached at all
        is given up after two when nothing has arrived yet.
    pause_s
        Seconds before the second try, doubled before each further one.
    timeout_s
        Seconds of silence after which a connection counts as broken.

    Returns
    -------
    Path
        ``target``.

    Raises
    ------
    UsageError
        If the address is not ``http`` or ``https``, or ``sha256`` is not a digest.
    DataError
        If the file cannot be had, is larger than ``max_bytes``, has another digest, or cannot be written.
    """
    shown = readable_url(url)
    expected = None if sha256 is None else parse_digest(sha256)
    part = Partial(target, url)
    with disk_errors(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        _persist(url, part, max_bytes, attempts, pause_s, timeout_s)
        if expected is not None:
            try:
                check_digest(
                    part.path,
                    expected,
                    name=f"The file from {shown}",
                    advice="It was deleted. Try again; if it stays so, the file was changed at its source.",
                )
            except DataError:
                part.discard()
                raise
        part.become(target)
    return target


def _persist(url: str, part: Partial, max_bytes: int | None, attempts: int, pause_s: float, timeout_s: float) -> None:
    """Try until the part is complete, or give up."""
    import requests

    failures, best = 0, part.size
    with requests.Session() as session:
        session.max_redirects = MAX_REDIRECTS
        while True:
            try:
                transfer(session, url, part, max_bytes, timeout_s)
            except BrokenOffError as error:
                if part.size >= best + _PROGRESS:
                    failures, best = 0, part.size
                failures += 1
                if failures >= (attempts if error.connected or part.size else min(attempts, 2)):
                    raise DataError(f"Cannot download {readable_url(url)}: {error}. {BY_HAND}") from None
                time.sleep(pause_s * 2 ** (failures - 1))
            else:
                return
