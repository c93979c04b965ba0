# SPDX-License-Identifier: MIT
"""A run that is followed for a page: its newest frame, and what is asked of it."""

from __future__ import annotations

import asyncio
import threading
import time
from contextlib import suppress

import numpy as np
from numpy.typing import ArrayLike

from pliant._core import Error, InputError
from pliant.play.imd.client import Client, ImdFrame

FRAMES = 30  #: that are asked for a second: a drag is fluent, and the run hardly feels it
FIRST_LOOK, LOOK = 0.02, 0.25  #: seconds between two looks at how fast the run is
HANDSHAKE = 10.0  #: seconds that a server may take for its first frame


class Upstream:
    """One connection to a run. A thread reads all that it sends and keeps the newest frame.

    So nobody who is slow to look holds the run up, and what is looked at is never old.

    Raises
    ------
    OSError
        Nobody listens there, or no frame comes.
    InputError
        What is sent is no IMD, or the run ends before its first frame.
    """

    def __init__(self, host: str, port: int) -> None:
        self._client = Client(host, port, timeout=HANDSHAKE)
        try:
            self.newest = (1, _first(self._client))  #: how many frames there were, and the last
            self._client.set_timeout(None)
        except BaseException:
            self._client.close()
            raise
        self.over = ""  #: why no more come; empty while they do
        self.has_ended = False  #: the run itself, and not the connection
        self._rate = _Rate()
        self._sending = threading.Lock()
        self._news, self._end = asyncio.Event(), asyncio.Event()
        self._is_awaited = False

    @property
    def atoms(self) -> int:
        """That the run has."""
        positions = self.newest[1].positions
        return 0 if positions is None else len(positions)

    def start(self) -> None:
        """Follows, from a running event loop."""
        self._loop = asyncio.get_running_loop()
        threading.Thread(target=self._follow, daemon=True).start()

    def close(self) -> None:
        """Leaves; the run goes on."""
        self._client.close()

    async def newer(self, seen: int) -> tuple[int, ImdFrame] | None:
        """`newest` once there are more frames than `seen`; None once no more come."""
        while self.newest[0] <= seen and not self.over:
            self._news.clear()
            self._is_awaited = True
            if self.newest[0] <= seen and not self.over:  # nothing came meanwhile
                await self._news.wait()
        return self.newest if self.newest[0] > seen else None

    async def end(self) -> None:
        """Returns once no more frames come."""
        await self._end.wait()

    async def pull(self, atoms: ArrayLike, forces: ArrayLike) -> None:
        """As Client.pull; a run that has gone is not pulled."""
        await asyncio.to_thread(self._pull, atoms, forces)

    async def release(self) -> None:
        """Nothing pulls any more."""
        await self.pull(np.empty(0, int), np.empty((0, 3)))

    def _pull(self, atoms: ArrayLike, forces: ArrayLike) -> None:
        with self._sending, suppress(OSError):
            self._client.pull(atoms, forces)

    def _follow(self) -> None:
        try:
            for frame in self._client:
                self._take(frame)
            self.has_ended = True
            self.over = "the run has ended"
        except (Error, OSError, ValueError) as error:  # ValueError: closed by ourselves
            self.over = f"the connection is lost: {error}"
        self._client.close()  # a run waits at its end until its client has gone
        self._tell(self._news, self._end)

    def _take(self, frame: ImdFrame) -> None:
        self.newest = (self.newest[0] + 1, frame)
        if self._is_awaited:
            self._is_awaited = False
            self._tell(self._news)
        every = self._rate.wanted(frame)
        if every and self._sending.acquire(blocking=False):
            try:
                self._client.set_rate(every)
            finally:
                self._sending.release()

    def _tell(self, *events: asyncio.Event) -> None:
        with suppress(RuntimeError):  # the loop has gone
            for event in events:
                self._loop.call_soon_threadsafe(event.set)


def _first(client: Client) -> ImdFrame:
    frame = client.read()
    if frame is None or frame.positions is None:
        raise InputError("IMD: the run sent no positions")
    return frame


class _Rate:
    """One step in how many to ask for, by how many steps a second a run takes.

    The first look comes soon: until then a run sends all that it can, which slows it down.
    """

    def __init__(self) -> None:
        self._every, self._look = 0, FIRST_LOOK
        self._since = time.monotonic()
        self._step: int | None = None

    def wanted(self, frame: ImdFrame) -> int:
        """0: as before."""
        now = time.monotonic()
        if frame.step is None or (self._step is not None and now - self._since < self._look):
            return 0
        self._look = min(2 * self._look, LOOK)
        steps = frame.step - (frame.step if self._step is None else self._step)
        every = max(1, round(steps / (now - self._since) / FRAMES))
        self._since, self._step = now, frame.step
        if steps <= 0 or self._every / 1.5 < every < self._every * 1.5:
            return 0
        self._every = every
        return every
