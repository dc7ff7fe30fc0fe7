"""The part of a download that has arrived so far, and what is needed to ask for the rest of it."""

import hashlib
import json
import re
from collections.abc import Mapping
from pathlib import Path


class Partial:
    """``<target>.part``, with a note beside it (``<target>.part.json``) about the version that it is part of.

    The note holds the server's validator (a strong ETag, else Last-Modified), sent as ``If-Range`` so that
    the server continues the same version or starts anew, and a digest of the address, which may contain
    credentials and is therefore not written down itself.

    Parameters
    ----------
    target
        The file that the download becomes when it is complete.
    url
        Where it comes from.
    """

    def __init__(self, target: Path, url: str) -> None:
        self.path = target.with_name(f"{target.name}.part")
        self._note = target.with_name(f"{target.name}.part.json")
        self._source = hashlib.sha256(url.encode()).hexdigest()

    @property
    def size(self) -> int:
        """Bytes that have arrived."""
        return self.path.stat().st_size if self.path.exists() else 0

    def request_headers(self) -> dict[str, str]:
        """Return the headers that ask for the missing bytes; none if only the whole file will do."""
        validator = self._validator()
        if self.size == 0 or validator is None:
            return {}
        return {"Range": f"bytes={self.size}-", "If-Range": validator}

    def same_version(self, headers: Mapping[str, str]) -> bool:
        """Tell whether a response's headers are about the version that the part is from."""
        validator = validator_of(headers)
        return validator is None or validator == self._validator()

    def start(self, headers: Mapping[str, str]) -> None:
        """Begin anew with a response that brings the whole file."""
        self.discard()
        validator = validator_of(headers)
        if validator is not None:
            self._note.write_text(json.dumps({"source": self._source, "validator": validator}))
        self.path.touch()

    def become(self, target: Path) -> None:
        """Put the complete file in its place."""
        self.path.replace(target)
        self._note.unlink(missing_ok=True)

    def discard(self) -> None:
        """Forget what has arrived."""
        self.path.unlink(missing_ok=True)
        self._note.unlink(missing_ok=True)

    def _validator(self) -> str | None:
        try:
            note = json.loads(self._note.read_text())
            validator = note["validator"] if note["source"] == self._source else None
        except (FileNotFoundError, ValueError, KeyError, TypeError):
            return None
        return validator if isinstance(validator, str) else None


def validator_of(headers: Mapping[str, str]) -> str | None:
    """Return what identifies a version of a file for ``If-Range``, which admits no weak ETags.

    Examples
    --------
    >>> validator_of({"ETag": '"v1"', "Last-Modified": "Thu, 01 Jan 1970 00:00:00 GMT"})
    '"v1"'
    >>> validator_of({"ETag": 'W/"v1"', "Last-Modified": "Thu, 01 Jan 1970 00:00:00 GMT"})
    'Thu, 01 Jan 1970 00:00:00 GMT'
    """
    etag = headers.get("ETag", "")
    return etag if etag.startswith('"') else headers.get("Last-Modified")


def parse_content_range(text: str) -> tuple[int | None, int | None]:
    """Return the first byte and the size of the whole file that a ``Content-Range`` header states.

    Only a range that reaches to the end of the file is of use here; anything else gives ``(None, None)``.

    Examples
    --------
    >>> parse_content_range("bytes 10-99/100")
    (10, 100)
    >>> parse_content_range("bytes */100")
    (None, 100)
    >>> parse_content_range("bytes 10-49/100")
    (None, None)
    """
    found = re.fullmatch(r"bytes\s+(?:(\d+)-(\d+)|\*)/(\d+)", text.strip(), re.ASCII)
    if found is None:
        return None, None
    first, last, size = found.groups()
    if first is None:
        return None, int(size)
    return (int(first), int(size)) if int(last) + 1 == int(size) else (None, None)
