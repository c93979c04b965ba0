# SPDX-License-Identifier: MIT
"""Runs every analysis that a trajectory allows."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from MDAnalysis.exceptions import NoDataError, SelectionError

from pliant._core import OptionError
from pliant.analyse import biology
from pliant.analyse.found import ENSEMBLE
from pliant.analyse.frames_held import choose_frames
from pliant.analyse.load import open_universe
from pliant.analyse.study import MAX_ANGLES, Study
from pliant.analysis import (
    BarResiduals,
    PrincipalComponents,
    RadiusOfGyration,
    RmsdToStart,
    Rmsf,
    RunRecord,
    TorsionDistributions,
    read_record,
)
from pliant.analysis.flexibility import STILL
from pliant.analysis.frames import HAS_BACKENDS
from pliant.analysis.rotatable import is_hydrogen
from pliant.analysis.stored import StoredPositions
from pliant.ensemble.frames import EnsembleFrames, folder_of
from pliant.ensemble.plan import is_ensemble

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe
    from MDAnalysis.analysis.base import Results

    from pliant.analyse.study import StudyOptions
    from pliant.analysis.frames import FrameAnalysis


#: the table of coordinates that the PCA makes may be this large
PCA_BYTES = 1 << 29


def study_trajectory(
    options: StudyOptions, on_stage: Callable[[str], None] = lambda name: None
) -> Study:
    """Opens the trajectory and runs everything on it; `on_stage` is told what is under way.

    Raises InputError (one line) when the file cannot be used, OptionError when the choice of atoms
    or frames is wrong or empty.
    """
    on_stage("reading")
    study = opened_study(options)
    biology.basics(study)
    runner = Runner(study)
    for name, stage in STAGES.items():
        on_stage(name)
        try:
            stage(study, runner)
        except OptionError:  # which is a ValueError, but the user's
            raise
        except (ValueError, NoDataError) as error:
            study.skipped[name] = " ".join(str(error).split())
    return study


def opened_study(options: StudyOptions) -> Study:
    """The study with its atoms and frames chosen, before any analysis; raises as the above."""
    universe = open_universe(options.path, options.topology)
    stored = StoredPositions(universe.trajectory)
    study = Study(options, universe, _record(options.path), stored)
    study.atoms = _select(universe, options.select, "--select")
    study.fitted, study.fitted_name = _fitted(study)
    choose_frames(study)
    if stored.joints_of_whole:
        study.notes.append(
            f"the file holds {len(universe.atoms)} of the molecule's {stored.joints_of_whole} "
            "atoms (--save): bars and stereochemistry are looked at among these only"
        )
    return study


def fitted_atoms(atoms: AtomGroup) -> tuple[AtomGroup, str]:
    """The atoms to superpose when none are named, and what to call them.

    One atom a residue where there is a chain of them (CA, P), else what is no hydrogen.
    """
    if hasattr(atoms, "names") and hasattr(atoms, "resnames"):
        trace = atoms.select_atoms("(protein and name CA) or (nucleic and name P)")
        if len(trace) >= 4:
            return trace, " and ".join(sorted(set(trace.names))) + " atoms"
    heavy = atoms[~is_hydrogen(atoms)]
    return (heavy, "heavy atoms") if 3 <= len(heavy) < len(atoms) else (atoms, "all atoms")


class Runner:
    """Runs analyses over the frames of a study, in as many processes as were asked for."""

    def __init__(self, study: Study) -> None:
        held = study.held is not None
        self._frames = np.arange(len(study.frames)) if held else study.frames
        self._backend = {}
        workers = min(study.options.workers, len(self._frames))
        if workers > 1 and not HAS_BACKENDS:
            study.notes.append("one process: MDAnalysis runs analyses in several from 2.8 on")
        elif workers > 1:
            self._backend = {"backend": "multiprocessing", "n_workers": workers}

    def run(self, analysis: FrameAnalysis, stride: int = 1) -> Results:
        """`analysis` after its run over the frames of the study, or every `stride`-th."""
        analysis.run(frames=self._frames[::stride], **self._backend)
        return analysis.results

    @property
    def first(self) -> int:
        """Number of the first frame, as the universe counts now."""
        return int(self._frames[0])


def _record(path: str) -> RunRecord | None:
    if is_ensemble(path):
        return _record_of_ensemble(path)
    try:
        return read_record(path)
    except OSError:
        return None


def _record_of_ensemble(path: str) -> RunRecord | None:
    """The options alone, which all shards share: bars and observables would be of one shard."""
    record = _record(str(EnsembleFrames(folder_of(Path(path))).paths[0]))
    return None if record is None else RunRecord(path, parameters=record.parameters)


def _select(universe: Universe, selection: str, option: str) -> AtomGroup:
    try:
        atoms = universe.select_atoms(selection)
    except (SelectionError, NoDataError, AttributeError, ValueError, TypeError) as error:
        raise OptionError(f"{option} '{selection}': {' '.join(str(error).split())}") from error
    if len(atoms) == 0:
        raise OptionError(f"{option} '{selection}': selects no atoms")
    return atoms


def _fitted(study: Study) -> tuple[AtomGroup, str]:
    selection = study.options.superpose
    if selection is None:
        return fitted_atoms(study.atoms)
    return _select(study.universe, selection, "--superpose"), f"atoms '{selection}'"


def _bar_residuals(study: Study, runner: Runner) -> None:
    residuals = _bar_residuals_of(study)
    runner.run(residuals)
    study.residuals = residuals
    if residuals.precision == "float32" and residuals.tolerance < 1e-5:
        study.notes.append(
            "coordinates are stored as 32-bit floats, so residuals are known to a few 1e-6 only"
        )


def _bar_residuals_of(study: Study) -> BarResiduals:
    record = study.record
    if record is None or record.bars is None:
        raise ValueError("the trajectory holds no bars with rest lengths")
    is_held = study.held is not None
    return BarResiduals(
        study.universe,
        record.bars,
        record.rest_lengths,
        tolerance=record.tolerance,
        tolerance_length=record.tolerance_length,
        positions=study.stored.renumbered(study.frames) if is_held else study.stored,
    )


def _sweeps(study: Study, runner: Runner) -> None:
    if study.observable("sweeps") is None:
        raise ValueError("the file holds no /observables/sweeps")


def _rmsd(study: Study, runner: Runner) -> None:
    if study.kind == ENSEMBLE:
        biology.rmsd_to_reference(study)
        return
    first = runner.first
    study.rmsd = runner.run(RmsdToStart(study.fitted, reference_frame=first)).rmsd
    if set(study.atoms.ix) != set(study.fitted.ix):
        every = RmsdToStart(study.atoms, superpose_on=study.fitted, reference_frame=first)
        study.rmsd_all = runner.run(every).rmsd


def _rmsf(study: Study, runner: Runner) -> None:
    if len(study.frames) < 2:
        raise ValueError("a single frame does not fluctuate")
    rmsf = Rmsf(study.atoms, superpose_on=study.fitted)
    runner.run(rmsf)
    study.rmsf = rmsf
    if not rmsf.results.average_converged:
        study.notes.append("the average structure of the RMSF did not come to rest")


def _radius_of_gyration(study: Study, runner: Runner) -> None:
    weights = "mass" if hasattr(study.atoms, "masses") and study.atoms.masses.sum() > 0 else None
    study.radius_weights = weights or "equal"
    study.radius = runner.run(RadiusOfGyration(study.atoms, weights=weights)).radius


def _torsions(study: Study, runner: Runner) -> None:
    bonds = None
    if not hasattr(study.universe, "bonds") and study.stored.joints_of_whole:
        raise ValueError("there are no bonds among the recorded atoms")
    if not hasattr(study.universe, "bonds") and study.record and study.record.bars is not None:
        bonds = study.record.bars
        study.notes.append("the file has no bonds: torsions are those of its bars")
    torsions = TorsionDistributions(
        study.atoms, bonds=bonds, heavy_only=not study.options.hydrogens
    )
    if not torsions.torsions:
        raise ValueError("no bond is rotatable: each is in a ring or at an end of the molecule")
    runner.run(torsions)
    study.torsions = torsions
    if torsions.results.angles.size > MAX_ANGLES:
        study.notes.append(
            f"the table torsion_angles.csv is left out: {torsions.results.angles.size:,} numbers"
        )


def _principal_components(study: Study, runner: Runner) -> None:
    if len(study.frames) < 3:
        raise ValueError("it needs at least 3 frames")
    if study.rmsf is not None:
        fitted = np.isin(study.atoms.ix, study.fitted.ix)
        if np.all(study.rmsf.results.rmsf[fitted] < STILL):
            raise ValueError("nothing moves")
    size = 24 * len(study.fitted) * len(study.frames)
    study.pca_stride = -(-size // PCA_BYTES)
    if len(study.frames) < 3 * study.pca_stride:
        raise ValueError("too many atoms: choose fewer with --superpose")
    if study.pca_stride > 1:
        study.notes.append(f"PCA uses every {study.pca_stride}th frame, to fit into memory")
    found = study.rmsf if not study.options.mass_weighted and study.pca_stride == 1 else None
    pca = PrincipalComponents(
        study.fitted,
        mass_weighted=study.options.mass_weighted,
        average=found.results.fitted_average if found else None,
        in_memory=False,
    )
    if len(runner.run(pca, study.pca_stride).eigenvalues) == 0:
        raise ValueError("the atoms do not move")
    study.pca = pca


#: in the order of running: what is left out goes by these names
STAGES: dict[str, Callable[[Study, Runner], None]] = {
    "bar residuals": _bar_residuals,
    "sweeps": _sweeps,
    "RMSD": _rmsd,
    "RMSF": _rmsf,
    "radius of gyration": _radius_of_gyration,
    "torsions": _torsions,
    "PCA": _principal_components,
    "flexibility": lambda study, _: biology.flexibility_stage(study),
    "stereochemistry": lambda study, _: biology.stereochemistry_stage(study),
    "contacts": lambda study, _: biology.contacts_stage(study),
    "distances": lambda study, _: biology.distances_stage(study),
}
