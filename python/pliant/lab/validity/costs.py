# SPDX-License-Identifier: MIT
"""Time and memory of the whole command, from a file to a trajectory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from pliant._core import FileError
from pliant.base.console import command_path
from pliant.lab.validity.goals import goal_of
from pliant.lab.validity.rows import Row
from pliant.lab.validity.subject import Subject

# A process takes over the largest resident size of the one that started it: a small one does.
STARTER = """\
import json, resource, subprocess, sys, time
began = time.perf_counter()
code = subprocess.call(sys.argv[1:], stdout=subprocess.DEVNULL)
seconds = time.perf_counter() - began
used = resource.getrusage(resource.RUSAGE_CHILDREN)
unit = 1 if sys.platform == "darwin" else 1024
print(json.dumps([code, seconds, used.ru_utime + used.ru_stime, used.ru_maxrss * unit / 1e6]))
"""
SOME_FRAMES_LEFT_OUT = 3  #: exit code
RATIO = "a frame of turns for one of modes, times of a core"


@dataclass(frozen=True)
class Cost:
    """Of one call of the command."""

    seconds: float  #: by the clock on the wall
    core_seconds: float  #: of processor time
    megabytes: float  #: largest resident size


def cost_of(path: str | os.PathLike[str], frames: int) -> Cost:
    """Of ``pliant sample`` on one thread. Raises FileError with what it said if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        words = [command_path(), "sample", os.fspath(path), "-o", os.path.join(folder, "x.h5md")]
        words += ["--frames", str(frames), "--sampler", "modes", "--threads", "1", "--quiet"]
        done = subprocess.run(
            [sys.executable, "-c", STARTER, *words], capture_output=True, text=True, check=True
        )
    code, *figures = json.loads(done.stdout)
    if code not in (0, SOME_FRAMES_LEFT_OUT):
        raise FileError(f"pliant sample {os.fspath(path)} failed: {done.stderr.strip()[-300:]}")
    return Cost(*figures)


def cost_rows(
    subject: Subject, protease: Subject, path: Path, small: Path, frames: int
) -> list[Row]:
    """Of the open kinase (`subject`, `path`), of ubiquitin (`small`) and of turns."""
    polar = Subject(path, frames, polar_hydrogens=True)
    large, whole = cost_of(path, frames), cost_of(small, frames)
    name, each = "AdK, open to closed", "ms of a core a frame"
    atoms, fewer = (f"{len(s.model.structure)} atoms" for s in (subject, polar))
    figures = (
        (name, f"{each}, polar hydrogens", 1e3 * polar.seconds_a_frame(), fewer),
        (name, each, 1e3 * subject.seconds_a_frame(), atoms),
        (name, "MB, whole command", large.megabytes, f"{frames} frames"),
        (
            "ubiquitin",
            f"s, whole command, {frames} frames",
            whole.seconds,
            f"{whole.core_seconds:.2f} s of a core, {whole.megabytes:.0f} MB",
        ),
    )
    rows = [Row(s, f, value, note=note, **goal_of(s, f)) for s, f, value, note in figures]
    return [*rows, ratio_row(polar, "AdK, open, polar hydrogens"), ratio_row(protease, "4E43")]


def ratio_row(subject: Subject, name: str) -> Row:
    """Time of a frame of turns over that of one of modes."""
    turns, modes = (1e3 * subject.seconds_a_frame(one) for one in ("turns", "modes"))
    note = f"{turns:.1f} and {modes:.1f} ms, {len(subject.model.structure)} atoms"
    return Row(name, RATIO, turns / modes, note=note, **goal_of(name, RATIO))
