"""A web server on this machine that misbehaves on request, small archives, and a method that can do everything."""

import hashlib
import io
import sys
import tarfile
import threading
import types
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

from vpr_bench.method.build import METHODS
from vpr_bench.registry import Entry


@dataclass
class Page:
    """One file of the server. Change its fields while the server runs."""

    body: bytes
    url: str
    etag: str | None = '"v1"'
    modified: str | None = None
    ranges: bool = True
    if_range: bool = True
    """Whether a changed ETag is noticed when a range is asked for, as it should be."""
    sized: bool = True
    """Whether Content-Length is stated."""
    cut_after: list[int] = field(default_factory=list)
    """Bytes sent before the connection drops, for one answer after another."""
    statuses: list[int] = field(default_factory=list)
    """Statuses answered instead of the file, one after another."""
    location: str | None = None
    hold_after: int | None = None
    """Bytes sent before the answer stalls until ``released`` is set."""
    released: threading.Event = field(default_factory=threading.Event)
    requests: list[dict[str, str]] = field(default_factory=list)
    """The headers of each request."""
    sent: list[int] = field(default_factory=list)
    """The bytes of body sent in each answer."""

    @property
    def sha256(self) -> str:
        return f"sha256:{hashlib.sha256(self.body).hexdigest()}"


class Server:
    """The pages, by path."""

    def __init__(self, port: int) -> None:
        self.root = f"http://127.0.0.1:{port}"
        self.pages: dict[str, Page] = {}

    def add(self, path: str, body: bytes = b"", **options) -> Page:
        page = self.pages[path] = Page(body, self.root + path, **options)
        return page


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    shared: Server

    def log_message(self, *args: object) -> None:
        """Stay silent."""

    def do_GET(self) -> None:
        page = self.shared.pages.get(self.path.partition("?")[0])
        if page is None:
            self._answer(404)
            return
        page.requests.append(dict(self.headers))
        if page.location is not None:
            self._answer(302, {"Location": page.location})
        elif page.statuses:
            self._answer(page.statuses.pop(0))
        else:
            self._send(page)

    def _send(self, page: Page) -> None:
        first, body = self._range(page), page.body
        version = {"ETag": page.etag, "Last-Modified": page.modified}
        headers = {name: value for name, value in version.items() if value is not None}
        if first is None:
            self._answer(200, headers, body, page)
        elif first >= len(body):
            self._answer(416, {**headers, "Content-Range": f"bytes */{len(body)}"})
        else:
            span = {"Content-Range": f"bytes {first}-{len(body) - 1}/{len(body)}"}
            self._answer(206, {**headers, **span}, body[first:], page)

    def _range(self, page: Page) -> int | None:
        asked, condition = self.headers.get("Range"), self.headers.get("If-Range")
        changed = page.if_range and condition not in (None, page.etag, page.modified)
        return int(asked[len("bytes=") : -1]) if asked and page.ranges and not changed else None

    def _answer(
        self, status: int, headers: dict[str, str] | None = None, body: bytes = b"", page: Page | None = None
    ) -> None:
        self.send_response(status)
        self.send_header("Connection", "close")
        if page is None or page.sized:
            self.send_header("Content-Length", str(len(body)))
        for name, value in (headers or {}).items():
            self.send_header(name, value)
        self.end_headers()
        if page is None:
            return
        if page.cut_after:
            body = body[: page.cut_after.pop(0)]
        hold = len(body) if page.hold_after is None else page.hold_after
        page.sent.append(len(body))
        self.wfile.write(body[:hold])
        if body[hold:]:
            self.wfile.flush()
            page.released.wait(10)
            self.wfile.write(body[hold:])


class QuietServer(ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, request: object, client_address: object) -> None:
        """Stay silent when a client was killed."""


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[Server]:
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    handler = type("BoundHandler", (Handler,), {})
    with QuietServer(("127.0.0.1", 0), handler) as http:
        handler.shared = Server(http.server_port)
        thread = threading.Thread(target=http.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield handler.shared
        for page in handler.shared.pages.values():
            page.released.set()
        http.shutdown()
        thread.join()


@pytest.fixture
def pauses(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Collect the pauses between tries instead of making them."""
    collected: list[float] = []
    monkeypatch.setattr("vpr_bench.download.http.time.sleep", collected.append)
    return collected


@pytest.fixture
def make_zip():
    """Return a maker of zip archives out of names and contents."""

    def make(files: dict[str, bytes]) -> bytes:
        buffer = io.BytesIO()
        with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in files.items():
                archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
        return buffer.getvalue()

    return make


@pytest.fixture
def make_tar():
    """Return a maker of tar archives out of entries, of contents or of anything that ``TarInfo`` can say."""

    def make(files: dict[str, bytes | dict], mode: str = "w") -> bytes:
        buffer = io.BytesIO()
        with tarfile.open(fileobj=buffer, mode=mode) as archive:
            for name, content in files.items():
                info = tarfile.TarInfo(name)
                if isinstance(content, bytes):
                    info.size = len(content)
                    archive.addfile(info, io.BytesIO(content))
                else:
                    for key, value in content.items():
                        setattr(info, key, value)
                    archive.addfile(info)
        return buffer.getvalue()

    return make


@pytest.fixture
def colours(monkeypatch: pytest.MonkeyPatch) -> types.ModuleType:
    """Register the methods ``colours`` and ``forgetful``; what the first did is in ``done`` of the module."""
    spec = spec_from_file_location("colours_plugin", Path(__file__).with_name("colours_plugin.py"))
    module = module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "colours_plugin", module)
    spec.loader.exec_module(module)
    new = {
        name: [Entry(name, f"colours_plugin:{name.title()}", "colours-plugin 1.0")] for name in ("colours", "forgetful")
    }
    monkeypatch.setitem(vars(METHODS), "_found", {**METHODS._found, **new})
    return module
