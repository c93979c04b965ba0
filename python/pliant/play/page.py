# SPDX-License-Identifier: MIT
"""The page's file, and the page with a molecule inside."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from pliant._core import Error, FileError, InputError
from pliant.base.input_files import open_file

PAGE = Path(__file__).with_name("pliant.html")
PLACE = b"<!-- GIVEN -->"  #: in the page, where a molecule goes
GIVEN = '<script type="application/json" id="given">'
MOST_BYTES = 256 * 1024**2


def page_file() -> Path:
    """The page. Raises Error where the package was built without it."""
    if not PAGE.is_file():
        raise Error(f"{PAGE}: not there: ./dev play makes the page, ./dev build then installs it")
    return PAGE


def read_given(path: Path) -> bytes:
    """A file to be played with. Raises FileError, and InputError if it is too large for a page."""
    try:
        with open(path, "rb", opener=open_file) as file:
            size = os.fstat(file.fileno()).st_size
            if size > MOST_BYTES:
                found = f"found {size / 1024**2:.0f}"
                raise InputError(f"{path}: expected at most {MOST_BYTES // 1024**2} MB, {found}")
            return file.read()
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None


def with_connection(page: bytes, address: str) -> bytes:
    """The page whose policy lets it ask for this one address, and for nothing else as before."""
    policy = b"default-src 'none'"
    return page.replace(policy, policy + f"; connect-src {address}".encode("ascii"), 1)


def with_block(page: bytes, facts: Mapping[str, object]) -> bytes:
    """The page with `facts` as a block of data, which its policy takes for no script."""
    import json

    text = json.dumps(facts).replace("<", "\\u003c")
    block = f"{GIVEN}{text}</script>"
    return page.replace(PLACE, block.encode("ascii"), 1)


def with_file(page: bytes, name: str, data: bytes, **facts: object) -> bytes:
    """The page with a file inside, which it opens; `facts` tell how."""
    import base64

    file = {"name": name, "data": base64.b64encode(data).decode("ascii")}
    return with_block(page, {**file, **facts})


def with_session(page: bytes, session: bytes) -> bytes:
    """A page with a file inside that goes on from a session, packed as the page tells it."""
    import base64

    start = f"{GIVEN}{{".encode("ascii")
    text = b'"session": "' + base64.b64encode(session) + b'", '
    return page.replace(start, start + text, 1)


def without_file(page: bytes, name: str) -> bytes:
    """The page that says that the file has been handed out."""
    return with_block(page, {"name": name, "gone": True})
