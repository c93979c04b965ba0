# SPDX-License-Identifier: MIT
"""Packets of IMD, version 2 (VMD) and version 3 (imdclient): headers, bodies, byte orders."""

from __future__ import annotations

import enum
import struct

import numpy as np
from numpy.typing import NDArray

from pliant._core import InputError


class Type(enum.IntEnum):
    """What a packet is."""

    DISCONNECT = 0
    ENERGIES = 1
    COORDINATES = 2
    GO = 3
    HANDSHAKE = 4
    KILL = 5
    FORCES_OF_CLIENT = 6
    PAUSE = 7
    RATE = 8
    IO_ERROR = 9
    SESSION_INFO = 10
    RESUME = 11
    TIME = 12
    BOX = 13
    VELOCITIES = 14
    FORCES = 15
    WAIT = 16


#: Names of the nine numbers of an energy packet, as MDAnalysis has them.
ENERGIES = (
    *("temperature", "total_energy", "potential_energy", "van_der_walls_energy"),
    *("coulomb_energy", "bonds_energy", "angles_energy", "dihedrals_energy"),
    "improper_dihedrals_energy",
)

MOST_ATOMS = 100_000_000  #: that a server may speak of

KILOJOULES_IN_KILOCALORIE = 4.184


def header(kind: Type, value: int = 0) -> bytes:
    """The eight bytes before a body."""
    return struct.pack(">ii", kind, value)


def read_header(data: bytes) -> tuple[Type, int]:
    """Raises InputError for a type that there is not."""
    kind, value = struct.unpack(">ii", data)
    try:
        return Type(kind), value
    except ValueError:
        raise InputError(f"IMD: packet of type {kind}, which there is not") from None


def read_handshake(data: bytes) -> tuple[int, str]:
    """Version and byte order ("<" or ">") of a server."""
    kind, big = struct.unpack(">ii", data)
    (little,) = struct.unpack("<i", data[4:])
    for version, order in ((big, ">"), (little, "<")):
        if kind == Type.HANDSHAKE and version in (2, 3):
            return version, order
    raise InputError("IMD: expected a handshake of version 2 or 3: is this an IMD server?")


def read_vectors(data: bytes, order: str) -> NDArray[np.float32]:
    """(N, 3) of a body."""
    return np.frombuffer(data, f"{order}f4").reshape(-1, 3).astype(np.float32)


def read_energies(data: bytes, order: str) -> tuple[int, dict[str, float]]:
    """Step, and the nine energies by name."""
    step, *values = struct.unpack(f"{order}i9f", data)
    return step, dict(zip(ENERGIES, values, strict=True))


def read_time(data: bytes, order: str) -> tuple[float, float, int]:
    """Timestep (ps), time (ps) and step."""
    timestep, time, step = struct.unpack(f"{order}ddq", data)
    return timestep, time, step


def force_packet(atoms: NDArray[np.int32], forces: NDArray[np.float64], order: str) -> bytes:
    """Forces (n, 3) on atoms (n), in the units of the session."""
    return (
        header(Type.FORCES_OF_CLIENT, len(atoms))
        + atoms.astype(f"{order}i4").tobytes()
        + forces.astype(f"{order}f4").tobytes()
    )
