# SPDX-License-Identifier: MIT
"""Runs all contenders on all molecules, in processes of their own, and measures what they made."""

from __future__ import annotations

import signal
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
from rdkit import rdBase
from rdkit.Chem import MolToMolBlock

from pliant.checks.openmm.child import Job, Outcome, run_jobs
from pliant.lab.conformers.contenders import CONTENDERS, Contender
from pliant.lab.conformers.crystal_ligands import crystal_ligands
from pliant.lab.conformers.faults import energies, faults_of
from pliant.lab.conformers.known import Known, KnownSet, read_known
from pliant.lab.conformers.rows import Made, Run, Table
from pliant.lab.conformers.summary import summarise
from pliant.lab.conformers.symmetric_rmsd import nearest_rmsd, symmetry_maps
from pliant.lab.options import chosen

WORKER = Path(__file__).with_name("contenders.py")
COUNTS = (50, 250, 1000)
LIMIT = 120.0  #: CPU seconds for a molecule
_WALL = 10  #: times as long by the clock, for what waits without computing
MOST_MINIMISED = 20  #: conformers of a molecule and contender


@dataclass(frozen=True)
class Subject:
    """A molecule, and what is worked out once for it."""

    known: Known
    maps: npt.NDArray[np.int64]  #: of its symmetry

    def distances(self, frames: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(F,) Angstrom from the known conformer."""
        return nearest_rmsd(self.known.molecule.GetConformer().GetPositions(), frames, self.maps)


def conformers(
    data: str | None = None,
    ring: int = 0,
    only: Sequence[str] = (),
    counts: Sequence[int] = COUNTS,
    no_strain: bool = False,
    progress: Callable[[int, int], object] = lambda *_: None,
) -> Table:
    """The table of molecules of a file or folder (`data`), else of ligands in crystals.

    Raises OptionError for a contender that there is not, InputError as `read_known` does.
    """
    asked = chosen(CONTENDERS, only)
    with rdBase.BlockLogs():
        found = read_known(Path(data), ring) if data else crystal_ligands(ring)
        able = [one for one in asked if one.is_installed]
        runs = run_all(found, able, counts, strain=not no_strain, progress=progress)
    table = Table(len(found.molecules), skipped=found.skipped)
    table.left_out = [one.how_to_install for one in asked if not one.is_installed]
    summarise(table, runs)
    return table


def run_all(
    found: KnownSet,
    contenders: Sequence[Contender] = CONTENDERS,
    counts: Sequence[int] = COUNTS,
    *,
    limit: float = LIMIT,
    strain: bool = True,
    progress: Callable[[int, int], object] = lambda *_: None,
) -> list[Run]:
    """A row for each contender, each of the counts that is not more than it makes, each molecule.

    A molecule that a contender fails at, or takes more than `limit` CPU seconds for, is a row with
    the failure. `strain`: minimises some conformers of each contender, those of the least count.
    """
    subjects = [Subject(one, symmetry_maps(one.molecule)) for one in found.molecules]
    tasks = [(one, asked) for one in contenders for asked in _runs_of(one, counts)]
    runs: list[Run] = []
    for number, (contender, asked) in enumerate(tasks):
        progress(number, len(tasks))
        outcomes = _made_by(contender, asked, subjects, limit)
        rows = [n for n in counts if n <= asked] if contender.is_prefix else [asked]
        for count in rows:
            runs += [_run(contender, count, *pair) for pair in zip(subjects, outcomes, strict=True)]
    return _with_strain(runs, subjects, min(counts)) if strain else runs


def _runs_of(contender: Contender, counts: Sequence[int]) -> list[int]:
    if contender.is_prefix:
        return [contender.most]
    return [count for count in counts if count <= contender.most]


def _made_by(
    contender: Contender, asked: int, subjects: Sequence[Subject], limit: float
) -> list[Outcome]:
    blocks = [MolToMolBlock(one.known.start) for one in subjects]
    wanted = {"count": asked, "limit": limit}
    jobs = [Job(contender.name, {"block": block, **wanted}, {}) for block in blocks]
    return run_jobs(jobs, _WALL * limit, worker=WORKER)[0]


def _run(contender: Contender, count: int, subject: Subject, outcome: Outcome) -> Run:
    known = subject.known
    start = subject.distances(known.start.GetConformer().GetPositions()[None])
    row = Made(known.name, contender.name, count, float(start[0]))
    frames = outcome.arrays["frames"][:count] if outcome.done else np.zeros((0, 0, 3))
    if not len(frames):
        return Run(replace(row, failure=_failure(outcome)))
    distances = subject.distances(frames)
    faults = faults_of(known.start, frames)
    row = replace(
        row,
        made=len(frames),
        nearest=float(distances.min()),
        seconds=float(outcome.arrays["seconds"]),
        start_seconds=float(outcome.arrays["start_seconds"]),
        handedness=int(faults.handedness.sum()),
        double_bonds=int(faults.double_bonds.sum()),
        amides=int(faults.amides.sum()),
        contacts=int(faults.contacts.sum()),
    )
    return Run(row, distances, frames)


def _failure(outcome: Outcome) -> str:
    if outcome.event == "died" and signal.SIGVTALRM.name in outcome.message:
        return "over the limit of CPU time"
    return "nothing made" if outcome.done else outcome.brief()


def _with_strain(runs: list[Run], subjects: Sequence[Subject], count: int) -> list[Run]:
    """Those of the least count with their strain: above the lowest minimum of all contenders."""
    found = list(runs)
    for subject in subjects:
        mine = [
            k
            for k, run in enumerate(runs)
            if run.row.molecule == subject.known.name and run.row.asked == count and run.row.made
        ]
        levels = [energies(subject.known.start, runs[k].frames[:MOST_MINIMISED]) for k in mine]
        lowest = min((float(low.min()) for _, low in levels if len(low)), default=np.nan)
        for k, (raw, _) in zip(mine, levels, strict=True):
            if len(raw):
                strain = float(np.median(raw) - lowest)
                found[k] = replace(runs[k], row=replace(runs[k].row, strain=strain))
    return found
