# SPDX-License-Identifier: MIT
"""A path: what is moved, how it goes on where it sticks, and what is kept and written of it."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass

import numpy as np

from pliant._core import Frame, H5mdRecorder, OptionError, Structure, read
from pliant.path.backtrack import go
from pliant.path.ends import Ends
from pliant.path.found import ARRIVED, MolecularPath
from pliant.path.march import begin
from pliant.path.meeting import meet
from pliant.path.table import Table
from pliant.path.walker import Walker, kept

MOST_ATTEMPTS = 1000  #: that backtrack may ask for


@dataclass(frozen=True)
class _Asked:
    """Options of path(), checked."""

    atoms: str
    step: float
    both: bool
    backtrack: int
    seed: int

    def __post_init__(self) -> None:
        if self.atoms not in ("CA", "heavy"):
            raise OptionError(f'atoms: expected "CA" or "heavy", found "{self.atoms}"')
        if not 0.0 < self.step <= 2.0:
            raise OptionError(f"step: expected above 0, at most 2 Angstrom, found {self.step}")
        if not 0 <= self.backtrack <= MOST_ATTEMPTS:
            raise OptionError(f"backtrack: expected 0 to {MOST_ATTEMPTS}, found {self.backtrack}")
        if not 0 <= self.seed < 2**64:
            raise OptionError(f"seed: expected 0 to 2^64 - 1, found {self.seed}")


def path(
    start: Structure | str | os.PathLike[str],
    end: Structure | str | os.PathLike[str],
    *,
    atoms: str = "CA",
    step: float = 0.2,
    both: bool = False,
    backtrack: int = 0,
    seed: int = 0,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
) -> MolecularPath:
    """Moves a molecule towards another structure of itself, every frame whole.

    Parameters
    ----------
    start, end : Structure or file
        Of proteins or nucleic acids; matched by chain and number, else by sequence.
    atoms : str
        Which are asked to arrive: ``CA`` (P of nucleotides) or ``heavy``, those of matched residues
        that have the same name.
    step : float
        r.m.s. distance of a step, Angstrom, above 0, at most 2.
    both : bool
        Moves both structures towards each other first. Where they meet, or neither comes nearer,
        `start` goes on along the frames that `end` has made. All frames are of `start`, with its
        bars.
    backtrack : int
        How often to go back and try again by a detour where the path is stuck, 0 to 1000. What is
        not kept is not part of the path.
    seed : int
        Of the detours.
    output : str or path, optional
        H5MD file to write frames to, when all are made; those that there are after Ctrl-C.
    overwrite : bool
        Replace it.

    Raises
    ------
    OptionError
        An option out of range.
    InputError
        A file that cannot be read, or structures that do not match.
    FileError
        The output exists or cannot be written.
    """
    asked = _Asked(atoms, step, both, backtrack, seed)
    begun = time.perf_counter()
    ends = Ends(_structure(start), _structure(end), atoms)
    recorder = None if output is None else _recorder(ends, asked, output, overwrite)
    found = MolecularPath(
        ends.start.model, np.empty(0), [], ends.matched, atoms, len(ends.start.model.contacts),
        len(ends.only_start), ends.only_end, list(ends.notes),
    )  # fmt: skip
    course = _Course(ends, asked)
    try:
        found.attempts = course.run()
    finally:  # after Ctrl-C what there is of the path is written as well
        frames = course.frames()
        if recorder is not None:
            _write(frames, recorder)
    found.notes += course.notes + course.way.notes
    found.positions = np.array([frame.positions for frame in frames])
    table = Table(ends)
    found.frames = [table.row(frame) for frame in frames]
    found.seconds = time.perf_counter() - begun
    return found


def _structure(given: Structure | str | os.PathLike[str]) -> Structure:
    return given if isinstance(given, Structure) else read(os.fspath(given))


def _write(frames: list[Frame], recorder: H5mdRecorder) -> None:
    for frame in frames:
        recorder.record(frame)
    recorder.close()


class _Course:
    """The way of the molecule of the start."""

    def __init__(self, ends: Ends, asked: _Asked) -> None:
        self._ends, self._asked = ends, asked
        self._walker = Walker(ends.start)
        self.way = begin(self._walker, ends.goal)
        self.notes: list[str] = []

    def run(self) -> int:
        """To where it ends; how often it went back."""
        asked, goals = self._asked, [self._ends.goal]
        if asked.both:
            self.way, meeting = meet(self._ends, self._walker, asked.step)
            goals = meeting.goals
            self.notes.append(meeting.told())
        near = ARRIVED[asked.atoms]
        self.way, attempts = go(
            self._walker, self.way, goals, asked.step, asked.backtrack, asked.seed, near
        )
        return attempts

    def frames(self) -> list[Frame]:
        """Numbered from the start."""
        return [kept(frame, number) for number, frame in enumerate(self.way.frames)]


def _recorder(
    ends: Ends, asked: _Asked, output: str | os.PathLike[str], overwrite: bool
) -> H5mdRecorder:
    model = ends.start.model
    parameters = {
        "path/end": os.path.basename(ends.source_of_end),
        "path/atoms": asked.atoms,
        "path/step": asked.step,
        "path/both": int(asked.both),
        "path/backtrack": asked.backtrack,
        "path/seed": asked.seed,
    }
    return H5mdRecorder(
        output, model.framework, structure=model.structure, parameters=parameters,
        overwrite=overwrite,
    )  # fmt: skip
