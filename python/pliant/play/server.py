# SPDX-License-Identifier: MIT
"""Hands one page to one browser on this machine, at an address that nobody can guess."""

from __future__ import annotations

import secrets
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import Any

SLOWEST = 10.0  #: seconds that a client may take for its request

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


class PageServer(HTTPServer):
    """Serves on 127.0.0.1, at `path` alone: the first page once, then the second.

    Any other path is 404; a request whose Host header is not the address is 403, so that no page of
    another site reaches it under a name of its own (DNS rebinding).
    """

    def __init__(self, first: bytes, then: bytes) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.pages = [first, then]
        self.path = secret_path()

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
        return self.pages.pop(0) if len(self.pages) > 1 else self.pages[0]

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that went away is nobody's error."""


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    timeout = SLOWEST
    server_version = "pliant"
    sys_version = ""

    def do_GET(self) -> None:
        """The page, or an error."""
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
