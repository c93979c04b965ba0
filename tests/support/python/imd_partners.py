# SPDX-License-Identifier: MIT
"""Runs that are served over IMD, and a client that does what VMD's sources do."""

import re
import socket
import struct
import subprocess
from contextlib import contextmanager

import numpy as np
from real_files import MOLECULES
from support_program import program

ENERGIES, COORDINATES, GO, HANDSHAKE, KILL, FORCES, PAUSE = 1, 2, 3, 4, 5, 6, 7


class Job:
    """A run of its own process; `port` once it listens."""

    def __init__(self, words, folder):
        self.process = subprocess.Popen(
            [str(word) for word in words],
            cwd=folder,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self.said = ""

    def wait_for(self, pattern, stream):
        while line := stream.readline():
            self.said += line
            if found := re.search(pattern, line):
                return found[1]
        raise AssertionError(f"ended without {pattern}: {self.said}")

    def end(self):
        out, err = self.process.communicate(timeout=900)
        return self.process.returncode, out, self.said + err


@contextmanager
def job(words, folder):
    started = Job(words, folder)
    try:
        yield started
    finally:
        started.process.kill()
        started.process.wait(timeout=900)
        for stream in (started.process.stdout, started.process.stderr):
            stream.close()  # not read to the end: whoever else holds it would be waited for


@contextmanager
def served_run(command, folder, *options, molecule="peptide_20.pdb"):
    """`pliant run` that listens; its output is run.h5md."""
    words = [command, "run", MOLECULES / molecule, "-o", "run.h5md", "--imd", "0", *options]
    with job(words, folder) as run:
        run.port = int(run.wait_for(r"IMD version \d on \S+:(\d+)", run.process.stderr))
        yield run


@contextmanager
def served_sample(joints, frames, version=3, order="native", folder=None):
    """The program imd_sample, whose frames sample_positions() gives."""
    words = [program("imd_sample"), joints, frames, version, order]
    with job(words, folder) as run:
        run.port = int(run.wait_for(r"^(\d+)$", run.process.stdout))
        yield run


def sample_positions(joints, frame):
    i = np.arange(joints)
    return np.column_stack([1.5 * i, frame + i, np.full(joints, 0.001 * frame)]).astype("f4")


class VmdLike:
    """IMD as VMD has it: version 2 only, the byte order of the handshake, forces as it drags.

    After the handshake VMD knows energies and coordinates, and reads a header it does not know as
    if it had no body: one packet of version 3 and all that follows is garbage. So here.
    """

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=900)
        kind, version = struct.unpack(">ii", self.take(8))
        assert kind == HANDSHAKE
        swapped = struct.unpack("<i", struct.pack(">i", version))[0]
        assert 2 in (version, swapped)
        self.order = ">" if version == 2 else "<"
        self.send(GO)

    def take(self, size):
        data = b""
        while len(data) < size:
            some = self.socket.recv(size - len(data))
            if not some:
                raise EOFError
            data += some
        return data

    def send(self, kind, value=0, body=b""):
        self.socket.sendall(struct.pack(">ii", kind, value) + body)

    def read(self):
        """Step and nine energies, then positions."""
        kind, value = struct.unpack(">ii", self.take(8))
        assert (kind, value) == (ENERGIES, 1)
        energies = struct.unpack(f"{self.order}i9f", self.take(40))
        kind, atoms = struct.unpack(">ii", self.take(8))
        assert kind == COORDINATES
        return energies, np.frombuffer(self.take(12 * atoms), f"{self.order}f4").reshape(-1, 3)

    def drag(self, atoms, forces):
        """Forces in kcal/(mol Angstrom)."""
        body = np.array(atoms, f"{self.order}i4").tobytes()
        body += np.array(forces, f"{self.order}f4").tobytes()
        self.send(FORCES, len(atoms), body)
