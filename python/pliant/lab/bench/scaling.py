# SPDX-License-Identifier: MIT
"""Whole jobs of the command on one thread and on several: frames, walkers, conformers."""

from __future__ import annotations

import hashlib
import math
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import h5py

from pliant._core import InputError
from pliant.base import console
from pliant.lab.results import Cell, Results, print_table

FRAMES, STEPS, WALKERS = 1000, 300, 64

#: Words of the command by job: those of proteins, and those of libraries of small molecules.
PROTEIN_JOBS: Mapping[str, Sequence[str]] = {
    "frames of modes": ("sample", "--sampler", "modes", "--frames", "{frames}"),
    "frames of reach": ("sample", "--sampler", "reach", "--frames", "{frames}"),
    "walkers with contacts": (
        *("run", "--model", "protein", "--steps", "{steps}"),
        *("--walkers", str(WALKERS)),
    ),
}
LIBRARY_JOBS: Mapping[str, Sequence[str]] = {"conformers": ("conformers",)}
LIBRARIES = (".sdf", ".sdf.gz", ".smi", ".smi.gz")


@dataclass
class ScalingRow:
    """One job on one number of threads."""

    job: str
    input: str
    threads: int
    seconds: float = math.inf  #: on the clock, least of the rounds, all of the command
    cpu_seconds: float = math.inf  #: least of the rounds; not a number where no system says it
    faster: float = math.nan  #: seconds on the fewest threads, over these
    efficiency: float = math.nan  #: `faster` over the share of threads
    same_bits: bool = True  #: results are those of the fewest threads, bit by bit
    digest: str = ""


@dataclass
class Scaling(Results):
    """All jobs on all numbers of threads."""

    cores: int
    rows: list[ScalingRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Results that depend on the number of threads."""
        return [
            f"{row.job} of {row.input}, {row.threads} threads: other bits than on fewer"
            for row in self.rows
            if not row.same_bits
        ]

    def print_report(self) -> None:
        """A line a job and number of threads, and what is wrong."""
        print(f"whole jobs, reading and writing included; {self.cores} cores")
        print_table(self.rows, COLUMNS)
        for fault in self.faults:
            print(f"wrong: {fault}")


COLUMNS: dict[str, Cell] = {
    "job": "job",
    "of": "input",
    "threads": "threads",
    "seconds": "seconds:.2f",
    "CPU seconds": "cpu_seconds:.2f",
    "times as fast": "faster:.2f",
    "efficiency": "efficiency:.2f",
    "same bits": lambda row: "yes" if row.same_bits else "no",
}


def scaling(
    files: Sequence[str | os.PathLike[str]],
    *,
    threads: Sequence[int] = (1, 2),
    frames: int = FRAMES,
    steps: int = STEPS,
    rounds: int = 1,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Scaling:
    """Does the jobs of proteins and of libraries (SDF, SMILES), in rounds that take turns.

    Raises InputError with what the command says where it fails.
    """
    found = Scaling(os.cpu_count() or 1)
    sizes = {"frames": frames, "steps": steps}
    asked = [
        (ScalingRow(name, os.path.basename(file), count), file, [w.format(**sizes) for w in words])
        for file in [os.fspath(one) for one in files]
        for name, words in (LIBRARY_JOBS if file.endswith(LIBRARIES) else PROTEIN_JOBS).items()
        for count in sorted(threads)
    ]
    for k in range(rounds):
        for number, (row, file, words) in enumerate(asked):
            progress(k * len(asked) + number, rounds * len(asked))
            _do(row, file, words)
    found.rows = [row for row, *_ in asked]
    for row in found.rows:
        least = next(r for r in found.rows if (r.job, r.input) == (row.job, row.input))
        row.faster = least.seconds / row.seconds
        row.efficiency = row.faster * least.threads / row.threads
        row.same_bits = row.digest == least.digest
    return found


def _do(row: ScalingRow, file: str, words: Sequence[str]) -> None:
    """One round of one row."""
    with tempfile.TemporaryDirectory() as folder:
        library = file.endswith(LIBRARIES)
        output = os.path.join(folder, "out.sdf" if library else "out.h5md")
        more = [file, "-o", output, "--threads", str(row.threads), "--quiet"]
        began, used = time.perf_counter(), cpu_seconds_of_others()
        done = subprocess.run(
            [console.command_path(), *words, *more], capture_output=True, text=True, check=False
        )
        row.seconds = min(row.seconds, time.perf_counter() - began)
        row.cpu_seconds = min(row.cpu_seconds, cpu_seconds_of_others() - used)
        if done.returncode not in (0, 3):
            raise InputError(f"{row.job} of {file}: {done.stderr.strip()}")
        row.digest = _digest(Path(folder))


def cpu_seconds_of_others() -> float:
    """Of all processes that ended; not a number where the system does not say."""
    times = os.times()
    return times.children_user + times.children_system if os.name == "posix" else math.nan


def _digest(folder: Path) -> str:
    """Of positions in H5MD files, of all of other files."""
    digest = hashlib.sha256()
    for path in sorted(folder.iterdir()):
        digest.update(path.name.encode())
        if path.suffix != ".h5md":
            digest.update(path.read_bytes())
            continue
        with h5py.File(path) as h5:
            for name in sorted(h5["particles"]):
                values = h5[f"particles/{name}/position/value"]
                for first in range(0, len(values), 100):
                    digest.update(values[first : first + 100].tobytes())
    return digest.hexdigest()
