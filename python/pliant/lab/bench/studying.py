# SPDX-License-Identifier: MIT
"""What a study takes: the whole command, and each of its stages alone, on one processor."""

from __future__ import annotations

import contextlib
import json
import math
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import pliant
from pliant._core import InputError
from pliant.base import console
from pliant.lab.bench.scaling import cpu_seconds_of_others
from pliant.lab.results import Cell, Results, print_table

FRAMES, ROUNDS = 400, 1
WHOLE = "the command"  #: with what it imports
NOT_COMPARED = ("page", "files")  #: answers that name the folder


@dataclass
class StudyRow:
    """The command or a stage: least of the rounds, of processes that it starts too."""

    what: str
    seconds: float = math.inf
    cpu_seconds: float = math.inf


@dataclass
class Studying(Results):
    """All rows of one molecule."""

    input: str
    frames: int
    cores: int
    rows: list[StudyRow] = field(default_factory=list)
    #: question -> the answer of the first round
    answers: dict[str, str] = field(default_factory=dict)
    #: questions whose answer was another in a later round, or in this process
    changed: list[str] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Answers that did not repeat."""
        return [f"{what}: not the same answer each time" for what in self.changed]

    def print_report(self) -> None:
        """A line a stage, and what is wrong."""
        print(f"{self.input}, {self.frames} frames; {self.cores} cores")
        print_table(self.rows, COLUMNS)
        for fault in self.faults:
            print(f"wrong: {fault}")

    def compare(self, answers: Mapping[str, str]) -> None:
        """Those of a round with those of the first."""
        found = {what: text for what, text in answers.items() if what not in NOT_COMPARED}
        self.answers = self.answers or found
        others = (what for what, text in found.items() if self.answers.get(what) != text)
        self.changed += [what for what in others if what not in self.changed]


COLUMNS: dict[str, Cell] = {
    "stage": "what",
    "seconds": "seconds:.2f",
    "CPU seconds": "cpu_seconds:.2f",
}


def studying(
    path: str,
    *,
    frames: int = FRAMES,
    rounds: int = ROUNDS,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Studying:
    """Studies a molecule without the check by OpenMM, in rounds of the command and in this process.

    Raises InputError with what the command says where it fails.
    """
    found = Studying(os.path.basename(path), frames, os.cpu_count() or 1)
    rows: dict[str, StudyRow] = {}
    for k in range(rounds):
        progress(k, rounds)
        with tempfile.TemporaryDirectory() as folder:
            clock = Clock(rows)
            clock(WHOLE)
            answers = _by_command(path, frames, Path(folder) / "command")
            clock.stop()
            found.compare(answers)
            with _one_processor():  # else stages are measured beside others
                study = pliant.study(
                    path, output=Path(folder) / "here", frames=frames, check=False, on_stage=clock
                )
            clock.stop()
            found.compare(study.answers)
    found.rows = [*rows.values()]
    return found


@contextlib.contextmanager
def _one_processor() -> Iterator[None]:
    """For this process and those that it starts, where the system can do that."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    usual = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(usual)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, usual)


def _by_command(path: str, frames: int, folder: Path) -> dict[str, str]:
    """The answers."""
    words = [path, "--no-check", "--json", "--frames", str(frames), "-o", str(folder)]
    done = subprocess.run(
        [console.command_path(), "study", *words], capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise InputError(f"study of {path}: {done.stderr.strip()}")
    answers: dict[str, str] = json.loads(done.stdout)["answers"]
    return answers


class Clock:
    """Measures stages, each from its name to the next."""

    def __init__(self, rows: dict[str, StudyRow]) -> None:
        self._rows = rows
        self._open: tuple[StudyRow, float, float] | None = None

    def __call__(self, name: str) -> None:
        """A stage begins."""
        self.stop()
        self._open = (self._rows.setdefault(name, StudyRow(name)), *self._now())

    def stop(self) -> None:
        """The last stage ends."""
        if self._open is not None:
            row, seconds, used = self._open
            now = self._now()
            row.seconds = min(row.seconds, now[0] - seconds)
            row.cpu_seconds = min(row.cpu_seconds, now[1] - used)
        self._open = None

    @staticmethod
    def _now() -> tuple[float, float]:
        return time.perf_counter(), time.process_time() + cpu_seconds_of_others()
