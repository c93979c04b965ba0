# SPDX-License-Identifier: MIT
"""What recording costs: the share of a run that goes into its H5MD file, every frame recorded."""

from __future__ import annotations

import importlib.util
import math
import os
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant import _bars, console

STEPS, REPEATS = 1000, 5
PERTURBATIONS = ("force", "force_all", "displacement")
TECHNIQUES = ("auto", "bfs_cycle")
LOOKED_AT = 20  #: frames of each file whose bars are measured anew
BLOCK = 1 << 20  #: bytes of one plain write


@dataclass
class RecordRow:
    """One perturbation with one technique. Times are medians over the rounds."""

    perturb: str
    technique: str
    frames: int = 0
    step_microseconds: float = math.nan  #: push and resolve, of the run's own summary
    record_microseconds: float = math.nan  #: a frame: measure it, gather it, write it
    seconds: float = math.nan  #: wall time of the run
    share: float = math.nan  #: of the run's wall time that recording took
    share_least: float = math.nan  #: over the rounds
    share_most: float = math.nan
    file_megabytes: float = math.nan
    megabytes_per_second: float = math.nan  #: of the file, in the time of recording
    plain_megabytes_per_second: float = math.nan  #: of as many bytes written without more
    over_plain: float = math.nan  #: time of recording over that of the plain writes
    faults: list[str] = field(default_factory=list)  #: what was wrong in a file


@dataclass
class Record:
    """All rows, and what they belong to."""

    input: str
    joints: int
    bars: int
    tolerance: float
    single: bool
    compress: bool
    folder: str
    cores: int  #: that this process may use: frames are written beside the run if there are two
    rows: list[RecordRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """What was wrong in any file."""
        return [f"{r.perturb}, {r.technique}: {text}" for r in self.rows for text in r.faults]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


def default_molecule() -> str:
    """Adenylate kinase of MDAnalysisTests, 3341 atoms. Raises InputError where it is missing."""
    package = importlib.util.find_spec("MDAnalysisTests")
    if package is None or not package.submodule_search_locations:
        raise pliant.InputError(
            "no FILE is given, and MDAnalysisTests, which has adenylate kinase, is not installed"
        )
    return os.path.join(package.submodule_search_locations[0], "data", "adk_open.pdb")


@dataclass
class _Subject:
    """What all rows share."""

    structure: pliant.Structure
    framework: pliant.Framework
    options: dict[str, Any]  #: of run, but for perturb and technique
    folder: Path

    def run(self, row: RecordRow) -> tuple[pliant.RunSummary, Path]:
        """One recorded run."""
        path = self.folder / f"{row.perturb}-{row.technique}.h5md"
        start = pliant.State(self.structure.positions)
        summary = pliant.run(
            self.framework, start, path, structure=self.structure, overwrite=True,
            perturb=row.perturb, technique=row.technique, **self.options
        )  # fmt: skip
        return summary, path


def record(
    path: str | os.PathLike[str] = "",
    *,
    perturbations: Sequence[str] = PERTURBATIONS,
    techniques: Sequence[str] = TECHNIQUES,
    tolerance: float = 1e-6,
    steps: int = STEPS,
    repeats: int = REPEATS,
    seed: int = 0,
    single: bool = False,
    compress: bool = False,
    folder: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Record:
    """Runs and records every pair in rounds that take turns, and looks into the files."""
    path = path or default_molecule()
    structure = pliant.read(path)
    framework = structure.framework("bonds")
    options = {"steps": steps, "tolerance": tolerance, "seed": seed,
               "single": single, "compress": compress}  # fmt: skip
    with tempfile.TemporaryDirectory(prefix="pliant-bench-", dir=folder) as own:
        found = Record(os.path.basename(os.fspath(path)), framework.joint_count,
                       framework.bar_count, tolerance, single, compress, os.path.dirname(own),
                       len(os.sched_getaffinity(0)))  # fmt: skip
        found.rows = [RecordRow(p, t) for p in perturbations for t in techniques]
        subject = _Subject(structure, framework, options, Path(own))
        rounds: list[list[_Round]] = [[] for _ in found.rows]
        for turn in range(repeats + 1):
            for k, row in enumerate(found.rows):
                progress(turn * len(found.rows) + k, (repeats + 1) * len(found.rows))
                rounds[k].append(_round(subject, row))
        for row, all_rounds in zip(found.rows, rounds, strict=True):
            _fill(row, all_rounds[1:])  # the first warms up
    return found


@dataclass
class _Round:
    """One recorded run, and plain writes of as many bytes right after it."""

    summary: pliant.RunSummary
    bytes: int
    plain_seconds: float


def _round(subject: _Subject, row: RecordRow) -> _Round:
    summary, path = subject.run(row)
    size = path.stat().st_size
    row.faults = faults_of(path, summary, subject.framework, subject.options)
    path.unlink()
    return _Round(summary, size, _plain_write(path, size))


def _plain_write(path: Path, size: int) -> float:
    """Seconds to write so many bytes to a new file, a megabyte a write, and to close it."""
    block = np.random.default_rng(0).bytes(BLOCK)
    start = time.perf_counter()
    with open(path, "wb", buffering=0) as file:
        for _ in range(size // BLOCK):
            file.write(block)
        file.write(block[: size % BLOCK])
    seconds = time.perf_counter() - start
    path.unlink()
    return seconds


def _fill(row: RecordRow, rounds: Sequence[_Round]) -> None:
    runs = [r.summary for r in rounds]
    row.frames = runs[0].frames
    row.seconds = _median([s.seconds for s in runs])
    steps = max(runs[0].steps, 1)
    row.step_microseconds = _median(
        [1e6 * (s.perturb_seconds + s.resolve_seconds) / steps for s in runs]
    )
    row.record_microseconds = _median([1e6 * s.observe_seconds / s.frames for s in runs])
    shares = [s.observe_seconds / s.seconds for s in runs]
    row.share, row.share_least, row.share_most = _median(shares), min(shares), max(shares)
    row.file_megabytes = rounds[0].bytes / 1e6
    row.megabytes_per_second = _median([1e-6 * r.bytes / r.summary.observe_seconds for r in rounds])
    row.plain_megabytes_per_second = _median([1e-6 * r.bytes / r.plain_seconds for r in rounds])
    row.over_plain = _median([r.summary.observe_seconds / r.plain_seconds for r in rounds])


def _median(values: Sequence[float]) -> float:
    return float(np.median(values))


def faults_of(
    path: Path, summary: pliant.RunSummary, framework: pliant.Framework, options: dict[str, Any]
) -> list[str]:
    """What of a file is not what the run said, looked at with h5py."""
    import h5py

    faults = []
    with h5py.File(path) as file:
        position = file["particles/trajectory/position"]
        steps = np.array(position["step"])
        if not np.array_equal(steps, np.arange(summary.steps + 1)):
            faults.append(f"{len(steps)} frames for {summary.steps} steps and the start")
            return faults
        last = position["value"][-1]
        expected = summary.state.positions.astype(last.dtype)
        if not np.array_equal(last, expected):
            faults.append("the last frame is not where the run ended")
        whole = np.array(file["observables/converged/value"])
        if np.count_nonzero(~whole) != summary.unconverged_steps:
            faults.append("frames that are not whole are not those that the run counted")
        # 32-bit floats keep a coordinate to 2^-24 of itself.
        slack = 2.0**-22 * float(np.abs(last).max()) if last.dtype == np.float32 else 0.0
        for k in np.unique(np.linspace(0, len(steps) - 1, LOOKED_AT).astype(int)):
            worst = _residual(framework, position["value"][k])
            if whole[k] and not worst <= options["tolerance"] * (1 + 1e-9) + slack:
                faults.append(f"step {k} counts as whole, but its worst bar is off by {worst:.1e}")
    return faults


def _residual(framework: pliant.Framework, positions: np.ndarray) -> float:
    bars = np.asarray(framework.bars, dtype=np.int64)
    return _bars.worst_residual(positions.astype(float), bars, framework.rest_lengths)


def print_report(found: Record) -> None:
    """The table for people."""
    print(
        f"{found.input}: {found.joints} joints, {found.bars} bars, tolerance {found.tolerance:g}, "
        f"{32 if found.single else 64}-bit positions; {found.cores} cores; files in {found.folder}"
    )
    columns = ["perturbation, technique", "us a step", "us a frame", "share of the run",
               "least to most", "MB/s", "plain MB/s", "time over plain"]  # fmt: skip
    table = console.Table("", columns)
    table.rows = [_cells(row) for row in found.rows]
    table.print()
    print("plain: as many bytes written to a new file, a megabyte a write")
    for fault in found.faults:
        print(f"wrong: {fault}")


def _cells(row: RecordRow) -> list[str]:
    return [
        f"{row.perturb}, {row.technique}",
        f"{row.step_microseconds:.1f}",
        f"{row.record_microseconds:.1f}",
        f"{100 * row.share:.0f} %",
        f"{100 * row.share_least:.0f} to {100 * row.share_most:.0f} %",
        f"{row.megabytes_per_second:.0f}",
        f"{row.plain_megabytes_per_second:.0f}",
        f"{row.over_plain:.2f}",
    ]
