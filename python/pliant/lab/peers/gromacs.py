# SPDX-License-Identifier: MIT
"""GROMACS' LINCS and SHAKE as ``mdrun`` uses them, on one thread, timed by its own log.

LINCS: Hess et al., J. Comput. Chem. 18 (1997) 1463; SHAKE: Ryckaert et al., J. Comput. Phys. 23
(1977) 327. GROMACS offers neither to callers, so that bars are constrained in a run of many steps,
each of which pushes all joints anew (see ``gromacs_files``). What a step costs is the row
"Constraints" of the log over its calls. That is wall time, in which the velocities are corrected
too; times the share of a processor that the run had, it is comparable to processor time.
"""

from __future__ import annotations

import contextlib
import os
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from pliant.base.new_file import write_text
from pliant.lab.peers.gromacs_files import (
    Setting,
    complaint,
    constraint_seconds,
    parameters_text,
    read_frames,
    write_input,
)

NM = 0.1  #: nanometres in an Angstrom
NAMES = {"double": "gmx_d", "single": "gmx"}  #: by the precision of positions
FRAMES = 10  #: looked at in a run
FIRST_STEPS, MOST_STEPS, MOST_GROWTH = 20, 10_000_000, 50.0
RESOLVED = 0.05  #: seconds of constraints that the log, which has thousandths, resolves well enough


@dataclass(frozen=True)
class Program:
    """One build of GROMACS."""

    path: str
    precision: str  #: of positions: "double" or "single"
    version: str
    simd: str  #: the vector instructions that it was compiled for


@dataclass
class Run:
    """What became of a run."""

    failure: str = ""  #: why it did not come to its end; "" if it did
    seconds: float = float("nan")  #: for the constraints of one step
    in_all: float = 0.0  #: wall seconds of constraints in the log
    steps: int = 0
    frames: list[np.ndarray] = field(default_factory=list)  #: (N, 3) Angstrom, after a step


def programs() -> list[Program]:
    """The builds that are installed, double precision first; none if none is."""
    found = [_program(name, precision) for precision, name in NAMES.items() if shutil.which(name)]
    return [program for program in found if program]


def _program(name: str, precision: str) -> Program | None:
    path = shutil.which(name) or name
    with contextlib.suppress(OSError, subprocess.TimeoutExpired):
        said = subprocess.run(
            [path, "-quiet", "--version"], capture_output=True, text=True, timeout=60, check=False
        ).stdout
        version = re.search(r"^GROMACS version: +(\S+)", said, re.MULTILINE)
        simd = re.search(r"^SIMD instructions: +(\S+)", said, re.MULTILINE)
        if version:
            return Program(path, precision, version[1], simd[1] if simd else "")
    return None


class Gromacs:
    """A molecule in a folder of its own, ready for runs; use as a context, which removes it.

    `positions` (N, 3) are whole, `rest_lengths` (B,) those of `bars` (B, 2), `push` is the standard
    deviation of what a step adds to each coordinate, all in Angstrom; `masses` (N,) u.
    """

    def __init__(
        self,
        positions: np.ndarray,
        masses: np.ndarray,
        bars: np.ndarray,
        rest_lengths: np.ndarray,
        push: float,
    ) -> None:
        self._masses, self._push = masses, push * NM
        self._folder = tempfile.TemporaryDirectory(prefix="pliant-gromacs-")
        write_input(self._folder.name, positions * NM, masses, bars, rest_lengths * NM, self._push)

    def __enter__(self) -> Gromacs:
        return self

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()

    def trial(self, program: Program, setting: Setting, time_limit: float) -> Run:
        """A run that is just long enough for the log to show what a step costs."""
        steps = FIRST_STEPS
        while True:
            run = self.run(program, setting, steps, 1, time_limit)
            if run.failure or run.in_all >= RESOLVED or steps >= MOST_STEPS:
                return run
            growth = min(1.5 * RESOLVED / max(run.in_all, 1e-3), MOST_GROWTH)
            steps = min(int(steps * growth) + 1, MOST_STEPS)

    def run(
        self, program: Program, setting: Setting, steps: int, seed: int, time_limit: float
    ) -> Run:
        """Runs so many steps; `time_limit` seconds for all of it."""
        steps = max(steps, FRAMES)
        parameters = parameters_text(
            setting, self._masses, self._push, steps, steps // FRAMES, seed
        )
        write_text(pathlib.Path(self._folder.name, "bars.mdp"), parameters, overwrite=True)
        try:
            files = {
                "f": "bars.mdp",
                "c": "bars.gro",
                "r": "bars.gro",
                "p": "bars.top",
                "n": "bars.ndx",
            }
            self._call(program, "grompp", time_limit, **files, o="bars.tpr", maxwarn=9)
            files = {
                "s": "bars.tpr",
                "o": "bars.trr",
                "g": "bars.log",
                "e": "bars.edr",
                "c": "after.gro",
            }
            one_core = {"ntmpi": 1, "ntomp": 1, "nb": "cpu", "pin": "off"}
            share = self._call(program, "mdrun", time_limit, **files, **one_core, cpt=-1)
            return self._read(share, steps)
        except _Failed as failed:
            return Run(str(failed), steps=steps)

    def _call(self, program: Program, name: str, time_limit: float, **options: object) -> float:
        """Runs one of GROMACS' programs; the share of a processor that it had."""
        words = [str(word) for key, value in options.items() for word in (f"-{key}", value)]
        surroundings = os.environ | {"GMX_MAXBACKUP": "-1", "GMX_SUPPRESS_DUMP": "1"}
        used, start = _processor_seconds(), time.monotonic()
        try:
            done = subprocess.run(
                [program.path, "-quiet", name, *words],
                cwd=self._folder.name,
                env=surroundings,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=time_limit,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise _Failed(f"{name} took more than {time_limit:g} s") from None
        if done.returncode != 0:
            said = (done.stderr + done.stdout).decode(errors="replace")
            raise _Failed(complaint(said) or f"{name} ended with {done.returncode}")
        return min((_processor_seconds() - used) / (time.monotonic() - start), 1.0)

    def _read(self, share: float, steps: int) -> Run:
        folder = pathlib.Path(self._folder.name)
        try:
            log = (folder / "bars.log").read_text(encoding="utf-8", errors="replace")
            calls, seconds = constraint_seconds(log)
            frames = [x / NM for step, x in read_frames(folder / "bars.trr") if step > 0]
        except (OSError, ValueError) as error:
            raise _Failed(f"mdrun's files cannot be read: {error}") from None
        return Run("", share * seconds / calls, seconds, steps, frames)


class _Failed(Exception):  # noqa: N818 - not an error: an outcome
    """Why a run did not come to its end."""


def _processor_seconds() -> float:
    """Of all children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def lincs_settings(order: int) -> Iterator[Setting]:
    """From what is quickest to what is most exact."""
    for iterations in (1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 20, 24):
        yield Setting("lincs", order=order, iterations=iterations)
