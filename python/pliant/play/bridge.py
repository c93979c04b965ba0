# SPDX-License-Identifier: MIT
"""Between a run (IMD) and the page (WebSocket), on this machine alone."""

from __future__ import annotations

import asyncio
import http
import json
import math
import socket
from collections.abc import Callable, Coroutine, Iterable
from contextlib import suppress
from typing import Any

import numpy as np
from websockets.asyncio.server import ServerConnection, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from pliant._core import InputError, OptionError
from pliant.base.input_files import json_object
from pliant.play.imd.client import ImdFrame
from pliant.play.server import HEADERS, is_same, secret_path
from pliant.play.upstream import Upstream

HOST = "127.0.0.1"
MOST_BYTES = 1 << 16  #: of a message of the page
REFUSED = 1008  #: code with which a WebSocket is closed
MOST_PAGES = 16  #: at once
OPENING = 5.0  #: seconds after the end of a run in which the first page may still come
LAST_WORD = 5.0  #: seconds that a page may take to hear of the end

#: Numbers before the positions of a frame, as page/live.mjs reads them; not a number: not sent.
FIELDS = ("total_energy", "potential_energy", "bonds_energy", "coulomb_energy")


def packed(frame: ImdFrame) -> bytes:
    """Step, time and FIELDS as 64-bit floats, positions (N, 3) as 32-bit ones, little endian.

    A run with a temperature is one of GROMACS or NAMD, whose energies tell of no bars.
    """
    energies = frame.energies or {}
    if energies.get("temperature"):
        energies = {}
    first = [math.nan if value is None else value for value in (frame.step, frame.time)]
    numbers = first + [energies.get(name, math.nan) for name in FIELDS]
    return np.array(numbers, "<f8").tobytes() + np.asarray(frame.positions, "<f4").tobytes()


class Bridge:
    """Serves a page at one address, and gives it the frames of a run at another.

    Both begin with a path that cannot be guessed. A page asks for each frame; it then gets the
    newest there is. Several pages may follow at once: what they pull with adds up, and each is told
    what the others pull with.

    Parameters
    ----------
    upstream : Upstream
        The run.
    make_page : function
        Gives the page for the address of its WebSocket.
    """

    def __init__(self, upstream: Upstream, make_page: Callable[[str], bytes]) -> None:
        self.upstream = upstream
        self.listener = socket.create_server((HOST, 0))
        self.host = f"{HOST}:{self.listener.getsockname()[1]}"
        self.path = secret_path()
        self.page = make_page(f"ws://{self.host}{self.path}live")
        self.pulls: dict[
            ServerConnection, dict[int, np.ndarray]
        ] = {}  #: of each page that is there
        self.told: dict[ServerConnection, list[list[float]]] = {}  #: pulls of others, to each
        self.sending: set[asyncio.Task[None]] = set()
        self.has_come = asyncio.Event()

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://{self.host}{self.path}"

    async def run(self, show: Callable[[str], None], tell_end: Callable[[str], None]) -> None:
        """Serves pages until the run has ended, and each of them knows how it ended."""
        self.upstream.start()
        server = await serve(
            self._talk,
            sock=self.listener,
            process_request=self._admit,
            compression=None,
            max_size=MOST_BYTES,
            server_header="pliant",
            close_timeout=2,
        )
        show(self.address)
        await self.upstream.end()
        tell_end(self.upstream.over)
        with suppress(asyncio.TimeoutError):  # nobody need ever open the page
            await asyncio.wait_for(self.has_come.wait(), OPENING)
        if self.sending:
            await asyncio.wait(self.sending, timeout=LAST_WORD)
        server.close()  # without waiting: browsers keep connections that say nothing

    def _admit(self, _: ServerConnection, request: Request) -> Response | None:
        """The page, an error, or None: a WebSocket may be opened."""
        headers = request.headers
        if headers.get_all("Host") != [self.host]:
            return _response(http.HTTPStatus.FORBIDDEN, b"expected another Host\n")
        if getattr(request, "method", "GET") != "GET":  # older websockets know GET alone
            return _response(http.HTTPStatus.METHOD_NOT_ALLOWED, b"expected GET\n")
        if is_same(request.path, self.path):
            return _response(http.HTTPStatus.OK, self.page, "text/html; charset=utf-8")
        if not is_same(request.path, f"{self.path}live"):
            return _response(http.HTTPStatus.NOT_FOUND, b"nothing is here\n")
        if headers.get_all("Origin") != [f"http://{self.host}"]:
            return _response(http.HTTPStatus.FORBIDDEN, b"expected another Origin\n")
        return None

    async def _talk(self, page: ServerConnection) -> None:
        """To one page, until it goes."""
        if len(self.pulls) >= MOST_PAGES:
            await page.close(REFUSED, f"{MOST_PAGES} pages follow already")
            return
        self.pulls[page] = {}
        asked = asyncio.Event()
        sending = asyncio.create_task(self._send(page, asked))
        self.sending.add(sending)
        self.has_come.set()
        try:
            async for message in page:
                await self._take(page, message, asked)
        except ConnectionClosed:
            pass
        except (InputError, OptionError) as error:
            await page.close(REFUSED, str(error)[:120])
        finally:
            sending.cancel()
            self.sending.discard(sending)
            await self._leave(page)

    async def _leave(self, page: ServerConnection) -> None:
        """What nobody holds any more is pulled no more."""
        pulled = self.pulls.pop(page, None)
        self.told.pop(page, None)
        if pulled:
            await self._share()

    async def _share(self) -> None:
        """The run is pulled by all pages together, and each is told what the others pull with."""
        total = _summed(self.pulls.values())
        forces = np.array(list(total.values())).reshape(-1, 3)
        await self.upstream.pull(np.array(list(total), np.int64), forces)
        for page in list(self.pulls):
            others = _summed(one for other, one in self.pulls.items() if other is not page)
            rows = [[atom, *force.tolist()] for atom, force in others.items()]
            if rows == self.told.get(page, []):
                continue
            self.told[page] = rows
            with suppress(ConnectionClosed):
                await page.send(json.dumps({"pulls": rows}))

    async def _send(self, page: ServerConnection, asked: asyncio.Event) -> None:
        """A frame each time that one was asked for; at the end the last, and why no more come.

        The end is sent unasked: a page that nobody looks at asks for nothing.
        """
        with suppress(ConnectionClosed):  # which ends _talk() too
            await self._send_frames(page, asked)
            why = {"over": self.upstream.over, "ended": self.upstream.has_ended}
            await page.send(json.dumps(why))
            await page.wait_closed()  # by the page: what it says meanwhile is no error

    async def _send_frames(self, page: ServerConnection, asked: asyncio.Event) -> None:
        seen = 0
        while True:
            await _first_of(asked.wait(), self.upstream.end())
            asked.clear()
            newest = await self.upstream.newer(seen)
            if newest is None:
                return
            seen = newest[0]
            await page.send(packed(newest[1]))

    async def _take(
        self, page: ServerConnection, message: str | bytes, asked: asyncio.Event
    ) -> None:
        """Raises InputError or OptionError for what no page of ours says."""
        said = _said(message)
        if said.get("do") == "next":
            asked.set()
        elif said.get("do") == "pull":
            atoms, forces = _forces(said.get("forces"), self.upstream.atoms)
            expect_once(atoms)
            self.pulls[page] = dict(zip(atoms.tolist(), forces, strict=True))
            await self._share()
        else:
            raise InputError("expected next or pull")


async def _first_of(*waits: Coroutine[Any, Any, Any]) -> None:
    """Returns once one of them has."""
    tasks = [asyncio.create_task(wait) for wait in waits]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()


def _said(message: str | bytes) -> dict[str, Any]:
    try:
        return json_object(message)
    except ValueError:
        raise InputError("expected a JSON object") from None


def _forces(rows: Any, atoms: int) -> tuple[np.ndarray, np.ndarray]:
    """Atoms (n) and forces (n, 3) of rows [atom, x, y, z]."""
    is_list = isinstance(rows, list) and all(isinstance(row, list) for row in rows)
    if not is_list or not all(_is_force(row, atoms) for row in rows):
        raise InputError("expected forces as rows of atom, x, y, z")
    table = np.array(rows, float).reshape(-1, 4)
    return table[:, 0].astype(int), table[:, 1:]


def expect_once(atoms: np.ndarray) -> None:
    """Raises InputError where a page pulls one atom twice."""
    if len(np.unique(atoms)) < len(atoms):
        raise InputError("expected each atom once")


def _summed(pulls: Iterable[dict[int, np.ndarray]]) -> dict[int, np.ndarray]:
    """The force on each atom that is pulled."""
    total: dict[int, np.ndarray] = {}
    for one in pulls:
        for atom, force in one.items():
            total[atom] = total[atom] + force if atom in total else force
    return total


def _is_force(row: list[Any], atoms: int) -> bool:
    """Whether it is an atom that there is, and three numbers that are finite as 32-bit floats."""
    if len(row) != 4 or type(row[0]) is not int or not 0 <= row[0] < atoms:
        return False
    return all(type(value) in (int, float) and abs(value) < 1e30 for value in row[1:])


def _response(status: http.HTTPStatus, body: bytes, kind: str = "text/plain") -> Response:
    headers = Headers({"Content-Type": kind, "Content-Length": str(len(body)), **HEADERS})
    headers["Connection"] = "close"
    return Response(status.value, status.phrase, headers, body)
