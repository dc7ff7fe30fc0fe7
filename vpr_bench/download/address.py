"""Addresses of files, as they may be asked for and as they may be shown."""

from urllib.parse import urlsplit

from vpr_bench.errors import UsageError


def readable_url(url: str) -> str:
    """Return an address as it may be printed: without user name, password, query and fragment.

    Raises
    ------
    UsageError
        If the address is not ``http`` or ``https``.

    Examples
    --------
    >>> readable_url("https://me:secret@example.org/a.zip?token=secret")
    'https://example.org/a.zip'
    """
    try:
        parts = urlsplit(url)
        valid = parts.scheme in ("http", "https") and bool(parts.hostname)
    except ValueError:
        valid = False
    if not valid:
        scheme = url.partition(":")[0] if ":" in url else ""
        raise UsageError(f"Only http:// and https:// addresses can be downloaded. Got the scheme {scheme!r}.")
    return f"{parts.scheme}://{parts.netloc.rpartition('@')[2]}{parts.path}"
