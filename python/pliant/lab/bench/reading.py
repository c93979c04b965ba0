# SPDX-License-Identifier: MIT
"""What MDAnalysis takes to read a frame: of our H5MD files, and of DCD files of the same frames."""

from __future__ import annotations

import tempfile
import time
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import MDAnalysis
import numpy as np

import pliant
import pliant.mdanalysis
from pliant.lab.bench.target import Target, read_target
from pliant.lab.results import Cell, Results, print_table

FRAMES, REPEATS = 1000, 5
DISPLACEMENT = 0.1  #: Angstrom, of each coordinate in each frame

#: What goes over all frames -> those frames.
WAYS: dict[str, slice] = {"all": slice(None), "every third": slice(None, None, 3)}


@dataclass
class ReadingRow:
    """One molecule, read in one way. Times are the least of all rounds."""

    input: str
    atoms: int
    frames: int
    way: str
    microseconds: float  #: of processor time, for a frame of ours
    microseconds_dcd: float  #: for one of DCD
    same: bool  #: whether positions are those of the DCD file, bit by bit

    @property
    def ratio(self) -> float:
        """To DCD."""
        return self.microseconds / self.microseconds_dcd


@dataclass
class Reading(Results):
    """All rows."""

    rows: list[ReadingRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """What was read wrong."""
        return [f"{r.input}, {r.way}: other positions than DCD" for r in self.rows if not r.same]

    def print_report(self) -> None:
        """A line a row, and what is wrong."""
        print_table(self.rows, COLUMNS)
        for fault in self.faults:
            print(fault)


COLUMNS: dict[str, Cell] = {
    "input": "input",
    "atoms": "atoms",
    "frames": lambda row: f"{row.frames}, {row.way}",
    "microseconds a frame": "microseconds:.1f",
    "of DCD": "microseconds_dcd:.1f",
    "ratio": "ratio:.2f",
    "same": lambda row: "yes" if row.same else "no",
}


def reading(paths: Sequence[str], *, frames: int = FRAMES, repeats: int = REPEATS) -> Reading:
    """Measures all molecules in all ways, ours and DCD in turns."""
    found = Reading()
    for path in paths:
        target = read_target(path)
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")  # MDAnalysis says what DCD files lack
            names = _written(target, frames, Path(folder))
            pair = [MDAnalysis.Universe(names[0], name).trajectory for name in names]
            for way, choice in WAYS.items():
                found.rows.append(_row(target, pair, way, choice, repeats))
            for trajectory in pair:
                trajectory.close()
    return found


def _written(target: Target, frames: int, folder: Path) -> list[str]:
    """An H5MD file of ours, and a DCD file of the same frames."""
    ours, dcd = str(folder / "frames.h5md"), str(folder / "frames.dcd")
    empty = MDAnalysis.Universe.empty(len(target.positions), trajectory=True)
    with (
        pliant.H5mdRecorder(ours, target.framework) as recorder,
        MDAnalysis.Writer(dcd, len(target.positions)) as writer,
    ):
        for k in range(frames):
            positions = target.broken(DISPLACEMENT, k)
            recorder.record(pliant.Frame(k, float(k), positions))
            empty.atoms.positions = positions
            writer.write(empty.atoms)
    return [ours, dcd]


def _row(target: Target, pair: list[Any], way: str, choice: slice, repeats: int) -> ReadingRow:
    ours, dcd = pair
    rounds = [[_seconds(trajectory, choice) for trajectory in pair] for _ in range(repeats)]
    count = len(ours[choice])
    mine, others = (1e6 * min(times) / count for times in zip(*rounds, strict=True))
    both = zip(ours[choice], dcd[choice], strict=True)
    same = all(np.array_equal(one.positions, other.positions) for one, other in both)
    return ReadingRow(target.name, ours.n_atoms, count, way, mine, others, same)


def _seconds(trajectory: Any, choice: slice) -> float:
    """Processor time in which all positions are looked at."""
    start = time.process_time()
    for frame in trajectory[choice]:
        _ = frame.positions
    return time.process_time() - start
