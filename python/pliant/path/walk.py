# SPDX-License-Identifier: MIT
"""The steps of a path: ask residues to go towards the end, then make the frame whole."""

from __future__ import annotations

import os
import time
from typing import Any

import numpy as np

from pliant._core import (
    H5mdRecorder,
    InputError,
    MolecularModel,
    Motion,
    OptionError,
    Structure,
    build_model,
    read,
)
from pliant._superposition import Superposition
from pliant.compare.matching import match
from pliant.compare.traces import trace_of_structure
from pliant.path.contacts import (
    BROKEN,
    furthest_off,
    is_there,
    keys,
    names_of,
    off,
    rms,
    with_ligands,
)
from pliant.path.found import MolecularPath, PathFrame

TOLERANCE = 1e-10  #: of bars, share of their length
MOST_SWEEPS = 300  #: a step that takes more ends the path
#: a path ends where so many steps together gain less than LEAST_GAIN, Angstrom
PATIENCE, LEAST_GAIN = 8, 0.02
ROUNDING = 1e-6  #: nearer to the end than this there is no way to go, Angstrom
LEAST_SHARE = 0.05  #: of the way that those steps were asked to go, if that is less

MOST_STEPS = 2000


def path(
    start: Structure | str | os.PathLike[str],
    end: Structure | str | os.PathLike[str],
    *,
    atoms: str = "CA",
    step: float = 0.2,
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
    output : str or path, optional
        H5MD file to write frames to.
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
    if atoms not in ("CA", "heavy"):
        raise OptionError(f'atoms: expected "CA" or "heavy", found "{atoms}"')
    if not 0.0 < step <= 2.0:
        raise OptionError(f"step: expected above 0, at most 2 Angstrom, found {step}")
    begun = time.perf_counter()
    walk = _Walk(_structure(start), _structure(end), atoms, step)
    found = walk.run(output, overwrite)
    found.seconds = time.perf_counter() - begun
    return found


def _structure(given: Structure | str | os.PathLike[str]) -> Structure:
    return given if isinstance(given, Structure) else read(os.fspath(given))


class _Walk:
    """Takes the steps of a path."""

    def __init__(self, start: Structure, end: Structure, atoms: str, step: float) -> None:
        self.atoms, self.step = atoms, step
        whole, self.goal_model = build_model(start), build_model(end)
        self._match(whole.structure, self.goal_model.structure)
        self._share_contacts(whole)
        self.model = build_model(start, contacts=whole.contacts[self.is_shared])
        self.only_start = whole.contacts[self.is_only_start]
        self._choose_atoms()
        self.start = np.array(self.model.positions)
        self.goal = np.array(self.goal_model.positions)[self.theirs]
        self.leader = self._leaders()

    def _match(self, ours: Structure, theirs: Structure) -> None:
        """Residues (numbers of residue_of) of ours and theirs that stand for each other."""
        our_trace, their_trace = trace_of_structure(ours), trace_of_structure(theirs)
        if len(our_trace) == 0:
            raise InputError(f"{ours.source}: has no residues of proteins or nucleic acids")
        found = match(our_trace, their_trace, theirs.source)
        self.notes = list(found.notes)
        self.our_residues = ours.residue_of[our_trace.atoms[found.ours]]
        self.their_residues = theirs.residue_of[their_trace.atoms[found.theirs]]
        self.our_traced = our_trace.atoms[found.ours]
        self.their_traced = their_trace.atoms[found.theirs]

    def _named(self, structure: Structure, residues: np.ndarray) -> dict[tuple[int, str], int]:
        """Atoms of matched residues by the number of the match and their name."""
        number = {int(residue): k for k, residue in enumerate(residues)}
        return {
            (number[int(residue)], str(name)): atom
            for atom, (residue, name) in enumerate(
                zip(structure.residue_of, structure.names, strict=True)
            )
            if int(residue) in number
        }

    def _share_contacts(self, whole: MolecularModel) -> None:
        """Which contacts of the start the end has as well; those that only one has.

        Ligands and metals are matched by chain, number and name. Contacts of what is not matched
        are let go, and counted for neither.
        """
        our_structure, their_structure = whole.structure, self.goal_model.structure
        ours, theirs = with_ligands(
            our_structure, their_structure, self.our_residues, self.their_residues
        )
        our_names = names_of(self._named(our_structure, ours))
        their_names = names_of(self._named(their_structure, theirs))
        at_start = keys(whole.contacts, our_names, our_structure)
        at_end = keys(self.goal_model.contacts, their_names, their_structure)
        shared = {key for key in at_start if key is not None} & set(at_end)
        self.is_shared = np.array([key in shared for key in at_start], dtype=bool)
        is_named = np.array([key is not None for key in at_start], dtype=bool)
        self.is_only_start = is_named & ~self.is_shared
        self.only_end = [
            (their_names[int(row["a"])], their_names[int(row["b"])], row["least"], row["most"])
            for key, row in zip(at_end, self.goal_model.contacts, strict=True)
            if key is not None and key not in shared
        ]

    def _choose_atoms(self) -> None:
        """Atoms of ours that are asked to arrive, and where: atoms of theirs."""
        ours = self._named(self.model.structure, self.our_residues)
        theirs = self._named(self.goal_model.structure, self.their_residues)
        self.atom_of = ours
        if self.atoms == "CA":
            self.ours, self.theirs = self.our_traced, self.their_traced
            return
        elements = self.model.structure.elements
        pairs = [(a, theirs[k]) for k, a in ours.items() if k in theirs and elements[a] > 1]
        self.ours, self.theirs = np.array(pairs, dtype=np.int64).T

    def _leaders(self) -> np.ndarray:
        """(N,) of each atom the matched residue that it goes with: its own, else the nearest."""
        number = {int(residue): k for k, residue in enumerate(self.our_residues)}
        residue_of = self.model.structure.residue_of
        traced = self.start[self.our_traced]
        leader = np.empty(len(residue_of), dtype=np.int64)
        for residue in np.unique(residue_of):
            members = np.flatnonzero(residue_of == residue)
            found = number.get(int(residue))
            if found is None:
                middle = self.start[members].mean(axis=0)
                found = int(np.argmin(np.linalg.norm(traced - middle, axis=1)))
            leader[members] = found
        return leader

    def _towards(self, positions: np.ndarray) -> tuple[np.ndarray, float]:
        """(K, 3) from each asked atom to where it should be, and the r.m.s. distance."""
        here = positions[self.ours]
        placed = Superposition(here, np.ones(len(here))).apply(self.goal)
        moves = placed - here
        return moves, rms(moves)

    def _push(self, _step: int, positions: np.ndarray, _previous: np.ndarray) -> None:
        moves, apart = self._towards(positions)
        moves = moves * (min(1.0, self.step / apart) if apart > 0.0 else 0.0)
        leaders = self.leader[self.ours]
        count = np.bincount(leaders, minlength=len(self.our_residues))
        common = (
            np.stack(
                [np.bincount(leaders, moves[:, k], minlength=len(count)) for k in range(3)], axis=1
            )
            / np.maximum(count, 1)[:, None]
        )
        positions += common[self.leader]
        positions[self.ours] += moves - common[leaders]

    def run(self, output: str | os.PathLike[str] | None, overwrite: bool) -> MolecularPath:
        """Steps until the end, or until nothing is gained."""
        motion = Motion(
            self.model.framework, self.start, technique="froda", push=[],
            tolerance=TOLERANCE, max_sweeps=MOST_SWEEPS,
        )  # fmt: skip
        motion.add(self._push)
        recorder = self._recorder(output, overwrite)
        path = MolecularPath(
            self.model, np.empty(0), [], len(self.our_residues), self.atoms,
            int(self.is_shared.sum()), len(self.only_start), len(self.only_end), self.notes,
        )  # fmt: skip
        frame, positions = motion.start(), []
        while True:
            if recorder is not None:
                recorder.record(frame)
            positions.append(np.array(frame.positions))
            path.frames.append(self._look(len(path.frames), frame, positions[-1]))
            if self._is_over(path.frames):
                break
            frame = motion.step()
            if len(path.frames) > MOST_STEPS:
                path.notes.append(f"ended after {MOST_STEPS} steps")
                break
            if not frame.converged:
                path.notes.append("the last step could not be made whole, and is left out")
                break
        if recorder is not None:
            recorder.close()
        path.positions = np.array(positions)
        return path

    def _recorder(self, output: str | os.PathLike[str] | None, overwrite: bool) -> Any:
        if output is None:
            return None
        parameters = {"path/end": os.path.basename(self.goal_model.structure.source),
                      "path/atoms": self.atoms, "path/step": self.step}  # fmt: skip
        return H5mdRecorder(
            output,
            self.model.framework,
            structure=self.model.structure,
            parameters=parameters,
            overwrite=overwrite,
        )

    def _is_over(self, frames: list[PathFrame]) -> bool:
        if len(frames) <= PATIENCE:
            return frames[-1].to_end < ROUNDING
        least = min(LEAST_GAIN, LEAST_SHARE * PATIENCE * self.step)
        return frames[-1 - PATIENCE].to_end - frames[-1].to_end < least

    def _look(self, step: int, frame: Any, positions: np.ndarray) -> PathFrame:
        here, start = positions[self.ours], self.start[self.ours]
        moved = Superposition(here, np.ones(len(here))).apply(start) - here
        return PathFrame(
            step,
            self._towards(positions)[1],
            rms(moved),
            int(np.sum(off(positions, self.only_start) > BROKEN)),
            sum(self._is_made(positions, *contact) for contact in self.only_end),
            float(frame.max_residual),
            furthest_off(positions, self.model.contacts),
        )  # fmt: skip

    def _is_made(
        self,
        positions: np.ndarray,
        one: tuple[int, str],
        other: tuple[int, str],
        least: float,
        most: float,
    ) -> bool:
        if one not in self.atom_of or other not in self.atom_of:
            return False
        return is_there(positions, self.atom_of[one], self.atom_of[other], least, most)
