"""One request for one file: what is asked, what the answer means, and what becomes of its body."""

from typing import TYPE_CHECKING

from vpr_bench.download.address import readable_url
from vpr_bench.download.partial import Partial, parse_content_range
from vpr_bench.errors import DataError
from vpr_bench.files.disk import readable_size, require_space
from vpr_bench.progress import task

if TYPE_CHECKING:
    import requests

MAX_REDIRECTS = 5
BY_HAND = "Try again later, or get the file by hand from its publisher."
_CHUNK = 64 * 1024  # bytes
_CONNECT_TIMEOUT_S = 10.0
_PASSING = {408, 425, 429, 500, 502, 503, 504}  # statuses that may be gone at the next try


class BrokenOffError(Exception):
    """A try failed in a way that another one may mend.

    Parameters
    ----------
    reason
        What happened, for the message when no try is left.
    connected
        Whether the server could be reached.
    """

    def __init__(self, reason: str, *, connected: bool = True) -> None:
        super().__init__(reason)
        self.connected = connected


def transfer(session: "requests.Session", url: str, part: Partial, max_bytes: int | None, timeout_s: float) -> None:
    """Make one request and append what it brings to the part, which is complete on return.

    Raises
    ------
    BrokenOffError
        If the part is not complete and another try is worth it.
    DataError
        If the file cannot be had.
    """
    import requests
    import urllib3

    headers = {"Accept-Encoding": "identity", **part.request_headers()}
    try:
        with session.get(
            url, headers=headers, stream=True, timeout=(min(timeout_s, _CONNECT_TIMEOUT_S), timeout_s)
        ) as response:
            _receive(response, readable_url(url), part, max_bytes)
    except requests.exceptions.SSLError:
        raise DataError(
            f"Cannot download {readable_url(url)}: no secure connection could be made. "
            "Check the address, and the machine's clock and certificates."
        ) from None
    except requests.TooManyRedirects:
        raise DataError(
            f"Cannot download {readable_url(url)}: more than {MAX_REDIRECTS} redirects. {BY_HAND}"
        ) from None
    except (requests.ConnectionError, requests.Timeout, urllib3.exceptions.HTTPError) as error:
        raise _broken_off(error) from None
    except requests.RequestException as error:
        raise DataError(
            f"Cannot download {readable_url(url)}: it leads to an address that cannot be followed "
            f"({type(error).__name__}). {BY_HAND}"
        ) from None


def _broken_off(error: Exception) -> BrokenOffError:
    """Tell what broke, without the library's own words, which may contain the whole address."""
    import requests
    import urllib3

    reason = getattr(error.args[0] if error.args else None, "reason", None)
    unreachable = isinstance(reason, urllib3.exceptions.NewConnectionError)
    if unreachable or isinstance(error, requests.ConnectTimeout):
        return BrokenOffError("the server cannot be reached from here", connected=False)
    if isinstance(error, requests.exceptions.ProxyError):
        return BrokenOffError("the proxy cannot be reached or refuses", connected=False)
    if isinstance(error, requests.Timeout | urllib3.exceptions.TimeoutError):
        return BrokenOffError("the server stopped answering")
    return BrokenOffError("the connection broke off")


def _receive(response: "requests.Response", shown: str, part: Partial, max_bytes: int | None) -> None:
    """Append a response's body to the part; return only if the part is then complete."""
    total = _agree(response, shown, part)
    if max_bytes is not None and (total or 0) > max_bytes:
        raise _too_large(shown, part, max_bytes)
    arrived = part.size
    if total is not None:
        require_space(part.path.parent, total - arrived)
    name = shown.rpartition("/")[2] or shown
    with task(f"Downloading {name}", total) as advance, part.path.open("ab") as file:
        advance(arrived)
        if response.status_code != 416:
            for chunk in response.raw.stream(_CHUNK, decode_content=False):
                arrived += len(chunk)
                if max_bytes is not None and arrived > max_bytes:
                    raise _too_large(shown, part, max_bytes)
                file.write(chunk)
                advance(len(chunk))
    if total is not None and arrived != total:
        raise BrokenOffError(f"{arrived} of {total} bytes arrived")


def _agree(response: "requests.Response", shown: str, part: Partial) -> int | None:
    """Settle where the response continues; return the size of the whole file, None if it is not known."""
    status = response.status_code
    if status in (206, 416):
        first, total = parse_content_range(response.headers.get("Content-Range", ""))
        continues = first == part.size if status == 206 else total == part.size > 0
        if continues and part.same_version(response.headers):
            return total
        part.discard()
        raise BrokenOffError("the server could not continue the download where it broke off")
    if status == 200:
        part.start(response.headers)
        length = response.headers.get("Content-Length", "")
        return int(length) if length.isdecimal() else None
    if status in _PASSING:
        raise BrokenOffError(f"the server answers with status {status}")
    meaning = {401: "access is refused", 403: "access is refused", 404: "there is no such file"}
    raise DataError(
        f"Cannot download {shown}: {meaning.get(status, 'unexpected answer')} (status {status}). "
        "Check the address, or get the file by hand from its publisher."
    )


def _too_large(shown: str, part: Partial, max_bytes: int) -> DataError:
    part.discard()
    return DataError(
        f"The file from {shown} is larger than the {readable_size(max_bytes)} allowed. "
        "Check that the address is right, or raise the limit."
    )
