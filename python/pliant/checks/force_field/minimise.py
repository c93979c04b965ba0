# SPDX-License-Identifier: MIT
"""Minimises the start, frames of a file and frames of a short MD, each alike."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pliant import _core
from pliant._core import InputError, Structure
from pliant.base.console import counted
from pliant.base.force_field_options import USUAL, ForceFieldOptions
from pliant.base.output_names import start_beside
from pliant.checks.force_field.jobs import Bench, Progress, deadline_in
from pliant.checks.force_field.minimised import (
    LONG,
    SHORT,
    ForceFieldReport,
    LigandFound,
    Minimised,
    handedness,
)
from pliant.checks.force_field.molecule import Molecule, molecule_of, why_not
from pliant.checks.openmm.child import Job, Outcome
from pliant.checks.sample import NM
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.opened import one_file
from pliant.trajectory.superposition import Superposition

MD_FRAMES = 3
INCOMPLETE = " (if its side chain lacks atoms, pliant sample --fill-side-chains builds them)"
MD_STEP = 0.004  #: ps

#: frames of a quick look, of a small protein and of a larger one: 20 to 40 s of one core up to 200
#: residues
QUICK_STARTS = (5, 3)
SMALL = 2000  #: atoms


@dataclass(frozen=True)
class Wanted:
    """How much is minimised."""

    starts: int | str | None = None  #: frames for 100 steps, spread evenly, or "all"; None: few
    long_starts: int = 0  #: of these, minimised for 500
    md_steps: int = 0  #: of 4 fs; 0 for no MD
    start: str | os.PathLike[str] | None = None  #: structure file; default: the PDB beside
    time_limit: float = 300.0  #: seconds of one job
    total_limit: float = 1200.0  #: seconds after which no structure is begun
    force_field: ForceFieldOptions = USUAL

    def starts_of(self, atoms: int) -> int | str:
        """`starts`, or as many as a quick look has for a molecule of so many atoms."""
        return QUICK_STARTS[atoms > SMALL] if self.starts is None else self.starts


#: what is minimised by default, and by a thorough check
QUICK = Wanted()
THOROUGH = Wanted(starts=20, long_starts=3, md_steps=250)


def why_not_file(path: str) -> str:
    """Why the force field cannot be asked of an ensemble; "" where it can."""
    try:
        structure = one_file(path).structure
        reason = why_not(structure)
        if not reason:
            start_of(path, structure, None)
        return reason
    except InputError as error:
        return str(error)


def start_of(path: str, structure: Structure, named: str | os.PathLike[str] | None) -> np.ndarray:
    """Positions (N, 3) of the structure that the ensemble began with.

    A molecule that the cell of the file cuts is made whole.

    Raises InputError when there is no such file, it has other atoms, or a periodic box has cut it.
    """
    file = start_beside(path) if named is None else Path(named)
    if not file.is_file():
        hint = "" if named is not None else "; name the start structure with --reference"
        raise InputError(f"{file}: no such file{hint}")
    other = _core.read(os.fspath(file))
    if len(other) != len(structure):
        raise InputError(f"{file}: expected {len(structure)} atoms, found {len(other)}")
    unlike = np.flatnonzero(np.asarray(other.names) != np.asarray(structure.names))
    if len(unlike):
        k = int(unlike[0])
        raise InputError(
            f"{file}: atom {k}: expected '{structure.names[k]}', found '{other.names[k]}'"
        )
    other.framework()  # refuses what is still cut
    return np.array(other.positions)


def minimise_file(
    path: str, wanted: Wanted, show: Progress, say: Callable[[str], None] = lambda _: None
) -> ForceFieldReport:
    """Minimises frames of an H5MD file; `say` is called with what is about to be done.

    Raises InputError as start_of does, and for a file without residues.
    """
    source = one_file(path)
    structure = source.structure
    reason = why_not(structure)
    if reason:
        raise InputError(f"{path}: the force field is for proteins: {reason}")
    start = start_of(path, structure, wanted.start)
    numbers = choose_frames(len(source), wanted.starts_of(len(structure)))
    frames = source.read(numbers)
    return minimise_frames(structure, start, frames, wanted, show, numbers, say)


def minimise_frames(
    structure: Structure,
    start: np.ndarray,
    frames: np.ndarray,
    wanted: Wanted,
    show: Progress = lambda *_: None,
    numbers: np.ndarray | None = None,
    say: Callable[[str], None] = lambda _: None,
) -> ForceFieldReport:
    """Minimises frames (F, N, 3) of a structure with bonds; start: (N, 3); Angstrom."""
    began = time.monotonic()
    molecule = molecule_of(structure, wanted.force_field, say)
    bench = Bench(molecule, wanted.time_limit, deadline_in(wanted.total_limit), show)
    numbers = np.arange(len(frames)) if numbers is None else numbers
    names = [Minimised(f"frame {int(k)}", int(k)) for k in numbers]
    report = ForceFieldReport(
        start=Minimised("start"),
        frames=names,
        dynamics=[],
        residues=len(molecule.labels),
        atoms=len(molecule.elements),
        placed_hydrogens=molecule.placed,
        md_picoseconds=MD_STEP * wanted.md_steps,
        long_starts=wanted.long_starts,
        left_out=molecule.left_out,
        why_left_out=molecule.why,
        ligands=[one.label for one in molecule.whole_ligands],
        notes=molecule.notes,
    )
    matched = bench.match()
    if matched.done:
        bench.choose(wanted.force_field.platform, matched.arrays["platforms"].tolist())
        report.platform = bench.platform
        say(_plan(report))
        _Minimisation(report, molecule, bench, wanted).minimise(start, frames)
    else:
        report.why_not = _short(matched) + (INCOMPLETE if "template" in matched.message else "")
    report.seconds = time.monotonic() - began
    return report


def _plan(report: ForceFieldReport) -> str:
    """What is about to be done, and to what."""
    without = f", without {report.without}: no parameters" if report.left_out else ""
    frames, how = counted(len(report.frames), "frame"), f"on its platform {report.platform}"
    return f"OpenMM minimises the start and {frames}, {report.atoms} atoms each, {how}{without}"


def _short(outcome: Outcome) -> str:
    """What happened; of OpenMM's words on a residue without a template, not the link at the end."""
    text = outcome.message if outcome.event == "raised" else outcome.brief()
    return " ".join(text.partition("  For more information")[0].split())


class _Minimisation:
    """Minimises the structures in two stages: the short one of all first, so that a time limit
    leaves something of each."""

    def __init__(
        self, report: ForceFieldReport, molecule: Molecule, bench: Bench, wanted: Wanted
    ) -> None:
        self.report, self.bench, self.wanted = report, bench, wanted
        self.molecule = molecule
        self.corners, self.labels = molecule.corners()

    def minimise(self, start: np.ndarray, frames: np.ndarray) -> None:
        complete = self.molecule.complete
        self.given = [complete(start), *(complete(frame) for frame in frames)]
        self.hands = handedness(self.given[0], self.corners)
        self.targets = [self.report.start, *self.report.frames]
        chosen = choose_frames(len(frames), self.wanted.long_starts)
        long = [0, *(1 + chosen).tolist()] if self.wanted.long_starts else []
        moving = self._moving()
        md_frames = MD_FRAMES if moving else 0
        self.bench.planned = len(moving) + len(self.given) + len(long) + md_frames
        shorts, moved = self._minimise_shortly(moving)
        self._minimise_longer(shorts, long, moved)

    def _minimise_shortly(self, moving: list[Job]) -> tuple[list[Outcome], list[np.ndarray]]:
        """Outcomes of the start and the frames, and frames of the MD beside them."""
        jobs = [*moving, *(self.bench.minimising(x, [SHORT]) for x in self.given)]
        outcomes = self.bench.run(jobs)
        shorts = outcomes[len(moving) :]
        for target, given, outcome in zip(self.targets, self.given, shorts, strict=True):
            self._note(target, given, outcome)
        return shorts, self._dynamics(outcomes[: len(moving)])

    def _minimise_longer(
        self, shorts: list[Outcome], long: list[int], moved: list[np.ndarray]
    ) -> None:
        """Start and chosen frames go on from where they are; frames of MD begin."""
        stages = [SHORT, LONG - SHORT] if long else [SHORT]
        long = [k for k in long if self.targets[k].is_finite]
        jobs = [self._longer(shorts[k]) for k in long]
        jobs += [self.bench.minimising(x, stages) for x in moved]
        outcomes = self.bench.run(jobs) if jobs else []
        late = [k for k, outcome in zip(long, outcomes, strict=False) if not outcome.done]
        for k, outcome in zip(long, outcomes, strict=False):
            if outcome.done:
                self.targets[k].after_long = float(outcome.arrays["energies"][-1])
        if late:
            self.report.notes.append(
                f"partial: {len(long) - len(late)} of {len(long)} structures, the start among "
                f"them, were minimised for {LONG} steps"
            )
        md = zip(self.report.dynamics, moved, outcomes[len(long) :], strict=True)
        for target, given, outcome in md:
            self._note(target, given, outcome)

    def _moving(self) -> list[Job]:
        steps = self.wanted.md_steps
        return [self.bench.moving(self.given[0], SHORT, steps, MD_FRAMES)] if steps else []

    def _longer(self, outcome: Outcome) -> Job:
        return self.bench.minimising(outcome.arrays["positions"][-1] / NM, [LONG - SHORT])

    def _dynamics(self, outcomes: Sequence[Outcome]) -> list[np.ndarray]:
        """Frames of the MD, Angstrom; how it failed goes into the notes."""
        if not outcomes:
            return []
        if not outcomes[0].done:
            self.report.notes.append(f"partial: no frames of MD ({outcomes[0].brief()})")
            return []
        frames = outcomes[0].arrays["positions"] / NM
        half = self.report.md_picoseconds / 2
        self.report.dynamics = [
            Minimised(f"MD {half * (1 + (k + 1) / len(frames)):.3g} ps") for k in range(len(frames))
        ]
        return list(frames)

    def _note(self, target: Minimised, given: np.ndarray, outcome: Outcome) -> None:
        if not outcome.done:
            target.outcome = _short(outcome)
            return
        energies, after = outcome.arrays["energies"], outcome.arrays["positions"][0] / NM
        target.worst_force = float(outcome.arrays["worst_force"])
        target.before, target.after_short = (float(e) for e in energies[:2])
        if len(energies) > 2:
            target.after_long = float(energies[2])
        if not np.isfinite(after).all():
            return
        target.moved = self._moved(given, after)
        turned = handedness(after, self.corners) != self.hands
        target.inverted = [self.labels[k] for k in np.flatnonzero(turned)]
        rows = zip(self.molecule.whole_ligands, outcome.arrays["ligands"].tolist(), strict=True)
        for ligand, (energy, contacts, strain) in rows:
            atoms = self.molecule.atoms_of(ligand)
            heavy = atoms[self.molecule.elements[atoms] > 1]
            moved = self._moved(given, after, heavy)
            target.ligands[ligand.label] = LigandFound(energy, contacts, strain, moved)

    def _moved(self, given: np.ndarray, after: np.ndarray, of: np.ndarray | None = None) -> float:
        """RMSD of atoms, superposed on alpha carbons; by default of these themselves."""
        atoms = self.molecule.alpha_carbons
        atoms = atoms if len(atoms) > 2 else np.arange(len(given))
        of = atoms if of is None else of
        fit = Superposition(given[atoms], np.ones(len(atoms)))
        apart = fit.apply(after[of], after[atoms]) - given[of]
        return float(np.sqrt((apart**2).sum(axis=1).mean()))
