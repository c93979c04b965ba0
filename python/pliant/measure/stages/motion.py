# SPDX-License-Identifier: MIT
"""The stages that measure each frame: bars, sweeps, RMSD, RMSF, size, torsions, components."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.flexibility import STILL
from pliant.measure.gyration import RadiusOfGyration
from pliant.measure.pca import PrincipalComponents
from pliant.measure.residuals import BarResiduals
from pliant.measure.rmsd import RmsdToStart
from pliant.measure.rmsf import Rmsf
from pliant.measure.stages.parts import (
    AtomFluctuations,
    Components,
    Gyration,
    ReferenceStructure,
    Residuals,
    Rmsd,
    Sweeps,
    Torsions,
    Units,
    UnitsInComponents,
)
from pliant.measure.torsions import TorsionDistributions
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.superposition import superpose_onto

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis
    from pliant.measure.stages.runner import Runner

#: the table of coordinates that the PCA makes may be this large
PCA_BYTES = 1 << 29
#: frames that are superposed at a time, and bytes of their positions
AT_ONCE = 32
AT_ONCE_BYTES = 1 << 22


def bar_residuals(analysis: Analysis, runner: Runner) -> Iterator[Residuals]:
    """How far each bar is from its rest length, in each frame."""
    record, stored = analysis.record, analysis.stored
    if record is None or record.bars is None:
        raise ValueError("the trajectory holds no bars with rest lengths")
    measured = BarResiduals(
        analysis.universe,
        record.bars,
        record.rest_lengths,
        tolerance=record.tolerance,
        tolerance_length=record.tolerance_length,
        positions=stored if analysis.held is None else stored.renumbered(analysis.frames),
    )
    within, converged = runner.run(measured).within, analysis.converged
    yield Residuals(measured, None if converged is None else converged & ~within)


def sweeps(analysis: Analysis, runner: Runner) -> Iterator[Sweeps]:
    """The sweeps that the run counted."""
    counts = analysis.observable("sweeps")
    if counts is None:
        raise ValueError("the file holds no /observables/sweeps")
    yield Sweeps(counts)


def rmsd(analysis: Analysis, runner: Runner) -> Iterator[Rmsd]:
    """RMSD from the first frame; of independent frames, from the reference structure."""
    if analysis.kind == ENSEMBLE:
        yield _rmsd_to_reference(analysis)
        return
    atoms, fitted, first = analysis.atoms, analysis.fitted, runner.first
    of_fitted = runner.run(RmsdToStart(fitted, reference_frame=first)).rmsd
    if set(atoms.ix) == set(fitted.ix):
        yield Rmsd(of_fitted, None)
    else:
        every = RmsdToStart(atoms, superpose_on=fitted, reference_frame=first)
        yield Rmsd(of_fitted, runner.run(every).rmsd)


def _rmsd_to_reference(analysis: Analysis) -> Rmsd:
    """RMSD of the fitted atoms, and of all that are analysed if there are others."""
    atoms = analysis.atoms.ix
    fitted = np.isin(atoms, analysis.fitted.ix)
    target = analysis[ReferenceStructure].positions[atoms]
    values = np.empty((2, len(analysis.frames)))
    size = min(AT_ONCE, max(1, AT_ONCE_BYTES // (24 * len(atoms))))
    for first in range(0, len(analysis.frames), size):
        part = range(first, min(first + size, len(analysis.frames)))
        frames = np.array([analysis.positions(k)[atoms] for k in part])
        squares = np.sum((superpose_onto(frames, fitted, target[fitted]) - target) ** 2, axis=2)
        values[:, part] = np.sqrt([squares[:, fitted].mean(axis=1), squares.mean(axis=1)])
    return Rmsd(values[0], None if fitted.all() else values[1])


def fluctuations(analysis: Analysis, runner: Runner) -> Iterator[AtomFluctuations]:
    """RMSF of atoms and residues."""
    if len(analysis.frames) < 2:
        raise ValueError("a single frame does not fluctuate")
    measured = Rmsf(analysis.atoms, superpose_on=analysis.fitted)
    runner.run_around_start(measured)
    yield AtomFluctuations(measured, _frames_around_start(analysis))


def _frames_around_start(analysis: Analysis) -> tuple[int, int] | None:
    """How many frames those are, and how many there are; None: all."""
    near = analysis.around_start
    return None if near is None else (int(np.count_nonzero(near)), len(near))


def radius_of_gyration(analysis: Analysis, runner: Runner) -> Iterator[Gyration]:
    """How spread out the atoms are."""
    atoms = analysis.atoms
    weights = "mass" if hasattr(atoms, "masses") and atoms.masses.sum() > 0 else None
    measured = RadiusOfGyration(atoms, weights=weights)
    yield Gyration(runner.run(measured).radius, weights or "equal")


def torsions(analysis: Analysis, runner: Runner) -> Iterator[Torsions]:
    """Angles of the rotatable bonds; of bars, where the file has no bonds."""
    record, bonds = analysis.record, None
    if not hasattr(analysis.universe, "bonds"):
        if analysis.stored.joints_of_whole:
            raise ValueError("there are no bonds among the recorded atoms")
        bonds = record.bars if record else None
    measured = TorsionDistributions(analysis.atoms, bonds=bonds, heavy_only=True)
    if not measured.torsions:
        raise ValueError("no bond is rotatable: each is in a ring or at an end of the molecule")
    runner.run(measured)
    yield Torsions(measured, of_bars=bonds is not None)


def principal_components(
    analysis: Analysis, runner: Runner
) -> Iterator[Components | UnitsInComponents]:
    """The directions of largest motion, and the units that move along them."""
    stride = _stride_of_components(analysis)
    weighted, known = analysis.options.mass_weighted, analysis.get(AtomFluctuations)
    may_share = not weighted and stride == 1 and analysis.around_start is None
    measured = PrincipalComponents(
        analysis.fitted,
        mass_weighted=weighted,
        average=known.found.fitted_average if may_share and known else None,
        in_memory=False,
    )
    if len(runner.run(measured, stride).eigenvalues) == 0:
        raise ValueError("the atoms do not move")
    yield Components(measured, stride)
    units = analysis[Units].of_atoms(analysis.fitted.ix)
    if units is not None:
        yield UnitsInComponents(units)


def _stride_of_components(analysis: Analysis) -> int:
    """Every so many frames fit into memory; ValueError where that is none, or nothing moves."""
    if len(analysis.frames) < 3:
        raise ValueError("it needs at least 3 frames")
    found = analysis.get(AtomFluctuations)
    if found is not None:
        fitted = np.isin(analysis.atoms.ix, analysis.fitted.ix)
        if np.all(found.found.rmsf[fitted] < STILL):
            raise ValueError("nothing moves")
    stride = -(-24 * len(analysis.fitted) * len(analysis.frames) // PCA_BYTES)
    if len(analysis.frames) < 3 * stride:
        raise ValueError("too many atoms: choose fewer with --superpose")
    return stride
