# SPDX-License-Identifier: MIT
"""A client of IMD that follows a run, pulls on its atoms, and holds or ends it."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pliant._core import InputError, OptionError
from pliant.play.imd import packets
from pliant.play.imd.packets import Type


@dataclass
class ImdFrame:
    """What a server sends of one step. What it does not send is None."""

    step: int | None = None
    time: float | None = None  #: ps
    timestep: float | None = None  #: ps
    energies: dict[str, float] | None = None  #: kJ/mol (version 3); of Pliant: its README's table
    box: NDArray[np.float32] | None = None  #: (3, 3) Angstrom
    positions: NDArray[np.float32] | None = None  #: (N, 3) Angstrom
    velocities: NDArray[np.float32] | None = None  #: (N, 3) Angstrom/ps
    forces: NDArray[np.float32] | None = None  #: (N, 3) kJ/(mol Angstrom)


#: Packets of a frame of version 3, by their place in the session's information.
_ANNOUNCED = (
    Type.TIME,
    Type.ENERGIES,
    Type.BOX,
    Type.COORDINATES,
    None,
    Type.VELOCITIES,
    Type.FORCES,
)


class Client:
    """Follows a run over IMD: ``for frame in Client("localhost", 8888): ...``.

    Parameters
    ----------
    host, port
        Of the server: ``pliant run --imd``, ``gmx mdrun -imdwait``, LAMMPS' ``fix imd``, NAMD.
    timeout : float
        Seconds to wait for the server's next byte; TimeoutError after that.

    Attributes
    ----------
    version : int
        2 or 3, as the server speaks.

    Raises
    ------
    OSError
        Nobody listens there, or the connection breaks.
    InputError
        What is sent is no IMD.
    """

    def __init__(self, host: str = "127.0.0.1", port: int = 8888, *, timeout: float = 60.0) -> None:
        self._socket = socket.create_connection((host, port), timeout=timeout)
        self._is_paused = False
        self._atoms: int | None = None
        try:
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._stream = self._socket.makefile("rb")
            self.version, self._order = packets.read_handshake(self._handshake())
            self._last = self._last_of_frame()
            self._send(Type.GO)
        except BaseException:
            self._socket.close()
            raise

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Iterator[ImdFrame]:
        """Frames until the server ends."""
        while (frame := self.read()) is not None:
            yield frame

    def read(self) -> ImdFrame | None:
        """The next frame; None once the server has ended. Raises as the class does."""
        frame = ImdFrame()
        is_first = True
        while True:
            data = self._stream.read(8)
            if is_first and not data:
                return None
            if len(data) < 8:
                raise InputError("IMD: the server stopped within a frame")
            kind, value = packets.read_header(data)
            self._read_body(kind, value, frame)
            if kind == self._last:
                return frame
            is_first = False

    def pull(self, atoms: ArrayLike, forces: ArrayLike) -> None:
        """Pulls until the next pull() or release().

        Parameters
        ----------
        atoms : (n) int
            Indices, from 0; each at most once.
        forces : (n, 3) float
            kJ/(mol Angstrom).

        Raises
        ------
        OptionError
            Sizes that do not fit, an atom twice or below 0, a force that is not finite.
        """
        indices, vectors = _checked(atoms, forces)
        unit = 1.0 if self.version >= 3 else 1.0 / packets.KILOJOULES_IN_KILOCALORIE
        self._socket.sendall(packets.force_packet(indices, unit * vectors, self._order))

    def release(self) -> None:
        """Nothing pulls any more.

        Of other servers than Pliant's, too: those of version 2 keep forces until others come.
        """
        self.pull(np.empty(0, np.int32), np.empty((0, 3)))

    def set_timeout(self, seconds: float | None) -> None:
        """How long to wait for the server's next byte from now on; None: for ever."""
        self._socket.settimeout(seconds)

    def pause(self) -> None:
        """The run waits. Frames under way still come."""
        if not self._is_paused:
            self._send(Type.PAUSE)
        self._is_paused = True

    def resume(self) -> None:
        """The run goes on."""
        if self._is_paused:
            self._send(Type.RESUME if self.version >= 3 else Type.PAUSE)
        self._is_paused = False

    def set_rate(self, every: int) -> None:
        """A frame in so many steps; below 1: as the server likes."""
        self._send(Type.RATE, every)

    def set_wait(self, waits: bool) -> None:
        """Whether the run shall wait while no client is there. Raises OptionError in version 2."""
        if self.version < 3:
            raise OptionError("IMD version 2 cannot ask a run to wait")
        self._send(Type.WAIT, int(waits))

    def kill(self) -> None:
        """Asks the run to end; ``pliant run`` does, unless other machines can reach it.

        Frames under way still come.
        """
        self._send(Type.KILL)

    def close(self) -> None:
        """Leaves; the run goes on."""
        try:
            self._send(Type.DISCONNECT)
            self._socket.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass  # it has gone before us
        self._stream.close()
        self._socket.close()

    def _send(self, kind: Type, value: int = 0) -> None:
        self._socket.sendall(packets.header(kind, value))

    def _handshake(self) -> bytes:
        try:
            data = self._stream.read(8)
        except ConnectionResetError:
            data = b""
        if not data:
            raise InputError(
                "IMD: the server closed the connection without a word: it may have as many clients "
                "as it serves"
            )
        if len(data) < 8:
            raise InputError("IMD: the server stopped within a packet")
        return data

    def _take(self, size: int) -> bytes:
        data = self._stream.read(size)
        if len(data) < size:
            raise InputError("IMD: the server stopped within a packet")
        return data

    def _last_of_frame(self) -> Type:
        """The packet with which a frame ends."""
        if self.version < 3:
            return Type.COORDINATES
        kind, size = packets.read_header(self._take(8))
        if kind != Type.SESSION_INFO or size != len(_ANNOUNCED):
            raise InputError("IMD: expected 7 bytes of session information after the handshake")
        flags = zip(_ANNOUNCED, self._take(size), strict=True)
        announced = [kind for kind, is_sent in flags if is_sent and kind is not None]
        if not announced:
            raise InputError("IMD: the server announces frames without anything in them")
        return announced[-1]

    def _read_body(self, kind: Type, value: int, frame: ImdFrame) -> None:
        if kind == Type.TIME:
            frame.timestep, frame.time, frame.step = packets.read_time(self._take(24), self._order)
        elif kind == Type.ENERGIES:
            step, frame.energies = packets.read_energies(self._take(40), self._order)
            frame.step = step if frame.step is None else frame.step
        elif kind == Type.BOX:
            frame.box = packets.read_vectors(self._take(36), self._order)
        elif kind == Type.COORDINATES:
            frame.positions = self._vectors(value)
        elif kind == Type.VELOCITIES:
            frame.velocities = self._vectors(value)
        elif kind == Type.FORCES:
            frame.forces = self._vectors(value)
        else:
            raise InputError(f"IMD: the server sent a packet {kind.name}")

    def _vectors(self, count: int) -> NDArray[np.float32]:
        if not 0 <= count <= packets.MOST_ATOMS:
            raise InputError(f"IMD: the server speaks of {count} atoms")
        if self._atoms not in (None, count):
            raise InputError(f"IMD: expected {self._atoms} atoms as before, found {count}")
        self._atoms = count
        return packets.read_vectors(self._take(12 * count), self._order)


def _checked(atoms: ArrayLike, forces: ArrayLike) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    indices, vectors = np.asarray(atoms), np.asarray(forces, np.float64)
    if indices.ndim != 1 or vectors.shape != (len(indices), 3):
        raise OptionError(
            f"pull: expected n atoms and forces (n, 3), found {indices.shape} and {vectors.shape}"
        )
    if not np.issubdtype(indices.dtype, np.integer):
        raise OptionError(f"pull: expected indices of atoms, found {indices.dtype}")
    if len(np.unique(indices)) < len(indices) or (indices < 0).any():
        raise OptionError("pull: expected each atom once, and from 0")
    with np.errstate(over="ignore"):  # what is too large is refused
        narrow = vectors.astype(np.float32)
    if not np.isfinite(narrow).all():
        raise OptionError("pull: expected forces that are finite as 32-bit floats")
    return indices.astype(np.int32), vectors
