# SPDX-License-Identifier: MIT
"""What a frame of `pliant sample` costs, over a list of proteins: with polar and all hydrogens."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.lab.bench.step import worst_limit
from pliant.lab.results import Cell, Results, print_table
from pliant.lab.structures import protein_model
from pliant.measure import bars as _bars

FRAMES, ROUNDS = 100, 5
HYDROGENS = ("polar", "all")
SAMPLER = "modes"
TOLERANCE = 1e-6  #: relative, of bars
CONTACT_TOLERANCE = 0.08  #: Angstrom, of contacts and overlaps: what a frame may be off


@dataclass
class FrameRow:
    """One protein with polar or with all hydrogens. Times are medians over the rounds."""

    input: str
    hydrogens: str
    atoms: int = 0
    frames: int = 0  #: of a round
    milliseconds: float = math.nan  #: of a core, a frame, without what comes before frames
    quarter: float = math.nan
    three_quarters: float = math.nan
    milliseconds_before: float = math.nan  #: of a core: the model's modes, and the first frame
    redrawn: int = 0  #: frames of all rounds
    failed: int = 0  #: frames of all rounds
    max_residual: float = math.nan  #: relative, of all bars in all frames, measured anew
    max_limit: float = math.nan  #: Angstrom, measured anew
    max_overlap: float = math.nan  #: Angstrom, by pliant.measure_bars
    refused: str = ""  #: why no frame was made
    faults: list[str] = field(default_factory=list)


@dataclass
class FrameCosts(Results):
    """All rows, and how time grows with size."""

    sampler: str
    rows: list[FrameRow] = field(default_factory=list)
    slopes: dict[str, float] = field(default_factory=dict)  #: of log time on log atoms

    @property
    def faults(self) -> list[str]:
        """Which frames are broken."""
        return [f"{r.input}, {r.hydrogens}: {f}" for r in self.rows for f in r.faults]

    def print_report(self) -> None:
        """A line a protein, and how time grows with size."""
        print(
            f"frames of sampler {self.sampler}, one thread, ms of a core without what comes before"
        )
        made = [row for row in self.rows if not row.refused]
        print_table(made, COLUMNS)
        for name, value in self.slopes.items():
            mine = [row.milliseconds for row in made if row.hydrogens == name]
            if math.isfinite(value):
                print(
                    f"{name} hydrogens: time grows with atoms to the power {value:.2f}; "
                    f"{max(mine):.2f} ms at most, of {len(mine)} files"
                )
        for row in self.rows:
            if row.refused:
                print(f"refused: {row.input}, {row.hydrogens}: {row.refused}")
        for fault in self.faults:
            print(f"wrong: {fault}")


COLUMNS: dict[str, Cell] = {
    "protein": "input",
    "hydrogens": "hydrogens",
    "atoms": "atoms",
    "ms a frame": "milliseconds:.2f",
    "half of the rounds": lambda row: f"{row.quarter:.2f} to {row.three_quarters:.2f}",
    "before, ms": "milliseconds_before:.0f",
    "drawn again": "redrawn",
    "failed": "failed",
}


class _Subject:
    """A model of which frames are made again and again, on one thread."""

    def __init__(self, path: str | os.PathLike[str], hydrogens: str, sampler: str) -> None:
        self.row = FrameRow(os.path.basename(os.fspath(path)), hydrogens)
        polar = hydrogens == "polar"
        self._model = protein_model(path, polar_hydrogens=polar, all_hydrogens=not polar)
        framework = self._model.framework
        self._bars = np.array(framework.bars, dtype=np.int64).reshape(-1, 2)
        self._sampler = sampler
        self.row.atoms = framework.joint_count
        self._each: list[float] = []
        self._before: list[float] = []

    def run(self, frames: int, seed: int) -> None:
        """One round: `frames` less one."""
        begin, _ = self._timed(1, seed)
        whole, found = self._timed(frames, seed)
        self._before.append(begin)
        self._each.append(max(whole - begin, 0.0) / max(frames - 1, 1))
        self.row.frames = frames
        self.row.redrawn += found.redrawn
        self.row.failed += found.failed
        self._judge(np.asarray(found.positions))

    def _timed(self, frames: int, seed: int) -> tuple[float, pliant.SampledEnsemble]:
        began = time.process_time()
        options: dict[str, Any] = {"sampler": self._sampler, "seed": seed, "threads": 1}
        found = pliant.sample(self._model, frames, **options)
        return time.process_time() - began, found

    def _judge(self, frames: np.ndarray) -> None:
        framework, row = self._model.framework, self.row
        lengths = np.array(framework.rest_lengths)
        limits = framework.limits
        for x in frames:
            figures = (
                _bars.worst_residual(x, self._bars, lengths),
                worst_limit(x, limits),
                float(pliant.measure_bars(framework, x).max_overlap),
            )
            row.max_residual, row.max_limit, row.max_overlap = (
                float(np.fmax(old, new))
                for old, new in zip(
                    (row.max_residual, row.max_limit, row.max_overlap), figures, strict=True
                )
            )

    def finish(self, warm_up: int) -> None:
        """Fills the row; the first rounds do not count."""
        row = self.row
        row.quarter, row.milliseconds, row.three_quarters = (
            1e3 * float(x) for x in np.percentile(self._each[warm_up:], (25, 50, 75))
        )
        row.milliseconds_before = 1e3 * float(np.median(self._before[warm_up:]))
        if not row.max_residual <= TOLERANCE * (1 + 1e-9):
            row.faults.append(f"a bar is off by {row.max_residual:.1e}")
        if not row.max_limit <= CONTACT_TOLERANCE * (1 + 1e-9):
            row.faults.append(f"a contact is off by {row.max_limit:.1e} Angstrom")
        if not row.max_overlap <= CONTACT_TOLERANCE * (1 + 1e-9):
            row.faults.append(f"two atoms overlap by {row.max_overlap:.1e} Angstrom")


def frame_costs(
    files: Sequence[str | os.PathLike[str]],
    *,
    sampler: str = SAMPLER,
    frames: int = FRAMES,
    rounds: int = ROUNDS,
    seed: int = 0,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> FrameCosts:
    """Makes frames of every file in rounds that take turns; what is refused has a row that says so.

    Raises OptionError for an unknown sampler.
    """
    known = [entry.name for entry in pliant.samplers()]
    if sampler not in known:
        raise pliant.OptionError(f"sampler {sampler}: must be one of {', '.join(known)}")
    found, subjects = FrameCosts(sampler), []
    for path in files:
        for name in HYDROGENS:
            subject, row = _begin(path, name, sampler)
            found.rows.append(row)
            subjects += [subject] if subject is not None else []
    for k in range(rounds + 1):
        progress(k, rounds + 1)
        for subject in subjects:
            subject.run(frames, seed + k)
    for subject in subjects:
        subject.finish(warm_up=1)
    found.slopes = {name: slope(found.rows, name) for name in HYDROGENS}
    return found


def _begin(
    path: str | os.PathLike[str], hydrogens: str, sampler: str
) -> tuple[_Subject | None, FrameRow]:
    try:
        subject = _Subject(path, hydrogens, sampler)
    except pliant.Error as error:
        name = os.path.basename(os.fspath(path))
        return None, FrameRow(name, hydrogens, refused=str(error))
    return subject, subject.row


def slope(rows: Sequence[FrameRow], hydrogens: str) -> float:
    """Of log time on log atoms by least squares; not a number with fewer than two sizes."""
    mine = [row for row in rows if row.hydrogens == hydrogens and row.milliseconds > 0]
    if len({row.atoms for row in mine}) < 2:
        return math.nan
    logs = np.log([[row.atoms, row.milliseconds] for row in mine])
    return float(np.polyfit(logs[:, 0], logs[:, 1], 1)[0])
