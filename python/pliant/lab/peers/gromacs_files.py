# SPDX-License-Identifier: MIT
"""What GROMACS reads and writes: its input written from bars, its log and trajectory read.

Units are those of GROMACS: nm, ps, u, kJ/mol. Bars become constraints of type 2 (which make no
bond); atoms have no charge, attract nobody and feel but a tether. How they are pushed:

Brownian dynamics with a friction of mass / tau moves an atom by f tau dt / m + s xi in a step dt,
xi a normal deviate and s^2 = 2 k T tau dt / m. Atoms of one mass make a temperature group with T in
proportion to the mass, so that s is the same for all, and constraints weigh by the true masses. The
tether is a spring of k = a m / (tau dt) to the intact place, which makes each step

    x <- x - a (x - x0) + s xi,    constrained along the bars that x has.

Without it the angles between bars, which nothing else holds, would wander to where LINCS' series
converges badly, and it would be judged on what is no molecule any more. By stationarity a
coordinate is then (a, xi together) pushed by s / sqrt(1 - a / 2) in a step, standard deviation, and
is s / sqrt(2 a - a^2) from its intact place: with a = 1/2 both are s times 1.155.
"""

from __future__ import annotations

import math
import os
import re
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np

from pliant.base.new_file import write_text

BOLTZMANN = 0.00831446261815324  #: kJ/(mol K)
TETHER = 0.5  #: a above
MARGIN = 0.5  #: nm of nothing around the molecule, and ten pushes more
TRR_MAGIC = 1993  #: first number of a frame


@dataclass(frozen=True)
class Setting:
    """One of the ways to constrain; what does not concern its algorithm is not looked at."""

    algorithm: str  #: "lincs" or "shake"
    order: int = 4  #: of LINCS' series
    iterations: int = 1  #: of LINCS, against bars that turn
    tolerance: float = 1e-4  #: of SHAKE, relative

    def __str__(self) -> str:
        if self.algorithm == "shake":
            return f"tolerance {self.tolerance:.0e}"
        return f"order {self.order}, {self.iterations} iteration{'s' * (self.iterations > 1)}"


def coordinates_text(positions: np.ndarray, push: float) -> str:
    """A .gro file of positions (N, 3) nm amid a box that no push leads out of."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    margin = MARGIN + 10 * push
    placed = positions - low + margin
    lines = ["bars", str(len(positions))]
    for number, place in enumerate(placed, 1):
        number %= 100_000
        lines.append(f"    1BARS     A{number:5d}" + "".join(f"{x:20.15f}" for x in place))
    lines.append("".join(f"{x:20.15f}" for x in high - low + 2 * margin))
    return "\n".join(lines) + "\n"


def topology_text(masses: np.ndarray, bars: np.ndarray, rest_lengths: np.ndarray) -> str:
    """A .top file: one molecule of atoms (N,) u with bars (B, 2) of lengths (B,) nm, tethered."""
    atoms = [f"{k} A 1 BARS A {k} 0 {m:.10g}" for k, m in enumerate(masses, 1)]
    pairs = zip(bars.tolist(), rest_lengths.tolist(), strict=True)
    constraints = [f"{a + 1} {b + 1} 2 {length:.17g}" for (a, b), length in pairs]
    springs = [f"{k} 1" + 3 * f" {TETHER * m:.10g}" for k, m in enumerate(masses, 1)]
    sections = {
        "defaults": ["1 1"],
        "atomtypes": ["A 1 1.0 0.0 A 0.0 0.0"],
        "moleculetype": ["BARS 0"],
        "atoms": atoms,
        "constraints": constraints,
        "position_restraints": springs,
        "system": ["bars"],
        "molecules": ["BARS 1"],
    }
    return "\n".join(f"[ {name} ]\n" + "\n".join(rows) for name, rows in sections.items()) + "\n"


def groups_text(masses: np.ndarray) -> str:
    """A .ndx file: all atoms, and those of each mass, lightest first, as M0, M1 and so on."""
    _, which = np.unique(masses, return_inverse=True)
    groups = {"System": np.arange(len(masses))}
    groups |= {f"M{k}": np.flatnonzero(which == k) for k in range(which.max() + 1)}
    return "".join(f"[ {name} ]\n{_wrapped(atoms + 1)}\n" for name, atoms in groups.items())


def _wrapped(numbers: np.ndarray) -> str:
    rows = [numbers[k : k + 15] for k in range(0, len(numbers), 15)]
    return "\n".join(" ".join(map(str, row)) for row in rows)


def temperatures(masses: np.ndarray, push: float) -> np.ndarray:
    """K of the group of each mass at which a step moves a coordinate by `push` nm."""
    noise = push * math.sqrt(1 - TETHER / 2)
    return noise**2 * np.unique(masses) / (2 * BOLTZMANN)


def parameters_text(
    setting: Setting, masses: np.ndarray, push: float, steps: int, every: int, seed: int
) -> str:
    """An .mdp file: `steps` pushes of `push` nm, a frame `every` so many. dt and tau are 1 ps.

    Bars may turn by up to 90 degrees without a warning (by default 30, which hydrogens pushed by
    0.1 Angstrom do now and then), so that no warning is printed at GROMACS' cost.
    """
    heat = temperatures(masses, push)
    values = {
        "integrator": "bd", "bd-fric": 0, "dt": 1, "nsteps": steps, "ld-seed": seed,
        "continuation": "yes", "gen-vel": "no", "comm-mode": "none", "pbc": "xyz",
        "cutoff-scheme": "Verlet", "nstlist": 1_000_000_000, "verlet-buffer-tolerance": -1,
        "rlist": 0.1, "rvdw": 0.1, "rcoulomb": 0.1, "coulombtype": "cut-off",
        "vdwtype": "cut-off", "nstxout": every, "nstenergy": 0, "nstlog": 0,
        "nstcalcenergy": 1_000_000_000, "tc-grps": " ".join(f"M{k}" for k in range(len(heat))),
        "tau-t": " ".join("1" for _ in heat), "ref-t": " ".join(f"{t:.10g}" for t in heat),
        "constraints": "none", "constraint-algorithm": setting.algorithm,
        "lincs-order": setting.order, "lincs-iter": setting.iterations, "lincs-warnangle": 90,
        "shake-tol": f"{setting.tolerance:.10g}",
    }  # fmt: skip  # some pairs a line
    return "".join(f"{name} = {value}\n" for name, value in values.items())


def constraint_seconds(log: str) -> tuple[int, float]:
    """Calls, and wall seconds of them all, from the row "Constraints" of a log's accounting.

    Raises ValueError if the log has none.
    """
    row = re.search(r"^ Constraints +\d+ +\d+ +(\d+) +([\d.]+) ", log, re.MULTILINE)
    if row is None:
        raise ValueError("the log has no row of times for constraints")
    return int(row[1]), float(row[2])


def complaint(said: str) -> str:
    """First sentence, within a line, of the error that a program printed; "" if it printed none."""
    in_input = re.search(r"^ERROR \d+ .*:\n(.+)$", said, re.MULTILINE)
    fatal = re.search(r"^Source file:.*(?:\n.+)*\n\n.+:\n(.+)$", said, re.MULTILINE)
    found = in_input or fatal
    return found[1].strip().partition(". ")[0] if found else ""


def read_frames(path: str | os.PathLike[str]) -> Iterator[tuple[int, np.ndarray]]:
    """Steps and positions (N, 3) nm of a .trr file, in double precision whatever the file's is.

    XDR, big-endian: a magic number, a version, sizes in bytes of each part, then the parts. Raises
    ValueError at a frame that is not whole.
    """
    with open(path, "rb") as file:
        while head := file.read(12):
            yield _frame(file, head)


def _frame(file: BinaryIO, head: bytes) -> tuple[int, np.ndarray]:
    magic, _, letters = struct.unpack(">3i", _whole(head, 12))
    if magic != TRR_MAGIC:
        raise ValueError(f"a frame begins with {magic} instead of {TRR_MAGIC}")
    file.seek((letters + 3) // 4 * 4, os.SEEK_CUR)
    *sizes, atoms, step, _ = struct.unpack(">13i", _whole(file.read(52), 52))
    before, (positions, *after) = sum(sizes[:7]), sizes[7:]
    real = positions // (3 * max(atoms, 1))
    if real not in (4, 8):
        raise ValueError(f"{positions} bytes of positions for {atoms} atoms")
    file.seek(2 * real + before, os.SEEK_CUR)
    values = np.frombuffer(_whole(file.read(positions), positions), f">f{real}")
    file.seek(sum(after), os.SEEK_CUR)
    return step, values.astype(float).reshape(-1, 3)


def _whole(read: bytes, size: int) -> bytes:
    if len(read) != size:
        raise ValueError("the file ends within a frame")
    return read


def write_input(
    folder: str | os.PathLike[str],
    positions: np.ndarray,
    masses: np.ndarray,
    bars: np.ndarray,
    rest_lengths: np.ndarray,
    push: float,
) -> None:
    """Writes bars.gro, bars.top and bars.ndx, all that does not depend on the setting; nm."""
    _write(folder, "bars.gro", coordinates_text(positions, push))
    _write(folder, "bars.top", topology_text(masses, bars, rest_lengths))
    _write(folder, "bars.ndx", groups_text(masses))


def _write(folder: str | os.PathLike[str], name: str, text: str) -> None:
    write_text(os.path.join(folder, name), text, overwrite=True)
