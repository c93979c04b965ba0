# SPDX-License-Identifier: MIT
"""Hands one page to one browser on this machine, at an address that nobody can guess."""

from __future__ import annotations

import contextlib
import secrets
import socket
import threading
import time
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, HTTPServer
from socketserver import ThreadingMixIn
from typing import Any

SLOWEST = 10.0  #: seconds that a client may take for its request, and for taking the page
MOST_WAITING = 32  #: clients that have not yet said what they ask for; of more the first go

#: Nobody keeps the page, frames it, or learns its address.
HEADERS = {
    "Cache-Control": "no-store",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


def secret_path() -> str:
    """A path that nobody can guess."""
    return f"/{secrets.token_urlsafe(24)}/"


def is_same(given: str, expected: str) -> bool:
    """Compares in a time that tells nothing of where they differ."""
    return secrets.compare_digest(given.encode(), expected.encode())


class PageServer(ThreadingMixIn, HTTPServer):
    """Serves on 127.0.0.1, at `path` alone: the first page once, then the second.

    Any other path is 404; a request whose Host header is not the address is 403, so that no page of
    another site reaches it under a name of its own (DNS rebinding). Clients that say nothing, or
    say it slowly, keep nobody waiting.
    """

    daemon_threads = True

    def __init__(self, first: bytes, then: bytes) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.pages = [first, then]
        self.path = secret_path()
        self.waiting: dict[Any, float] = {}  #: until when each client may say what it asks for
        self._taking = threading.Lock()

    @property
    def host(self) -> str:
        """What the Host header must be."""
        return f"127.0.0.1:{self.server_port}"

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://{self.host}{self.path}"

    def next_page(self) -> bytes:
        """The first page, once."""
        with self._taking:
            return self.pages.pop(0) if len(self.pages) > 1 else self.pages[0]

    def process_request(self, request: Any, client_address: Any) -> None:
        """Answers a client in a thread of its own."""
        if len(self.waiting) >= MOST_WAITING:
            self._leave(next(iter(self.waiting.copy())))
        self.waiting[request] = time.monotonic() + SLOWEST
        super().process_request(request, client_address)

    def service_actions(self) -> None:
        """Leaves clients that take too long: the limit of each read would not."""
        now = time.monotonic()
        for request, end in self.waiting.copy().items():
            if end < now:
                self._leave(request)

    def shutdown_request(self, request: Any) -> None:
        """Ends a connection."""
        self.waiting.pop(request, None)
        super().shutdown_request(request)

    def _leave(self, request: Any) -> None:
        """Whatever waits for the client hears that it has gone."""
        self.waiting.pop(request, None)
        with contextlib.suppress(OSError):
            request.shutdown(socket.SHUT_RDWR)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that went away is nobody's error."""


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    timeout = SLOWEST
    server_version = "pliant"
    sys_version = ""

    def do_GET(self) -> None:
        """The page, or an error."""
        self.server.waiting.pop(self.connection, None)
        if self.headers.get("Host") != self.server.host:
            self._answer(HTTPStatus.FORBIDDEN, b"expected another Host\n", "text/plain")
        elif not is_same(self.path, self.server.path):
            self._answer(HTTPStatus.NOT_FOUND, b"nothing is here\n", "text/plain")
        else:
            self._answer(HTTPStatus.OK, self.server.next_page(), "text/html; charset=utf-8")

    def _answer(self, status: HTTPStatus, body: bytes, kind: str) -> None:
        self.send_response(status)
        headers = {"Content-Type": kind, "Content-Length": str(len(body)), **HEADERS}
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: Any) -> None:
        """Writes nothing: requests are not shown on the terminal."""
