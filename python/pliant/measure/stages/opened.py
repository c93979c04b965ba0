# SPDX-License-Identifier: MIT
"""Opens a trajectory, and chooses its atoms and frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

from MDAnalysis.exceptions import NoDataError, SelectionError

from pliant._core import OptionError
from pliant.measure.frames import HAS_BACKENDS
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.frames_held import choose_frames
from pliant.measure.stages.units import trace_atoms
from pliant.trajectory.universe import open_frames

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe

    from pliant.measure.stages.analysis import AnalysisOptions


def opened(options: AnalysisOptions) -> Analysis:
    """The atoms and frames of a trajectory, before any stage.

    Raises InputError (one line) when the file cannot be used, OptionError when the choice of atoms
    or frames is wrong or empty.
    """
    source, universe = open_frames(options.path, options.topology)
    atoms = _select(universe, options.select, "--select")
    fitted, name = _fitted(universe, atoms, options.superpose)
    chosen, remarks = choose_frames(options, universe, source)
    if source.joints_of_whole:
        remarks.append(
            f"the file holds {len(universe.atoms)} of the molecule's {source.joints_of_whole} "
            "atoms (--save): bars and stereochemistry are looked at among these only"
        )
    if min(options.workers, len(chosen.frames)) > 1 and not HAS_BACKENDS:
        remarks.append("one process: MDAnalysis runs analyses in several from 2.8 on")
    which = (chosen.frames, chosen.times, chosen.steps, chosen.held)
    return Analysis(options, universe, source, atoms, fitted, name, *which, tuple(remarks))


def _fitted(universe: Universe, atoms: AtomGroup, selection: str | None) -> tuple[AtomGroup, str]:
    """The atoms to superpose, and what to call them.

    Where none are named, one atom a residue (CA, P) of a chain, else what is no hydrogen.
    """
    if selection is not None:
        return _select(universe, selection, "--superpose"), f"atoms '{selection}'"
    trace = trace_atoms(atoms)
    if len(trace) >= 4:
        return trace, " and ".join(sorted(set(trace.names))) + " atoms"
    heavy = atoms[~is_hydrogen(atoms)]
    return (heavy, "heavy atoms") if 3 <= len(heavy) < len(atoms) else (atoms, "all atoms")


def _select(universe: Universe, selection: str, option: str) -> AtomGroup:
    try:
        atoms = universe.select_atoms(selection)
    except (SelectionError, NoDataError, AttributeError, ValueError, TypeError) as error:
        raise OptionError(f"{option} '{selection}': {' '.join(str(error).split())}") from error
    if len(atoms) == 0:
        raise OptionError(f"{option} '{selection}': selects no atoms")
    return atoms
