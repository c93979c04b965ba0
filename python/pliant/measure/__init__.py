# SPDX-License-Identifier: MIT
"""Analyses of trajectories, built on MDAnalysis' AnalysisBase.

Each class takes atoms of an ``MDAnalysis.Universe``, runs in this process or, with
``run(backend="multiprocessing", n_workers=4)``, in several, and leaves arrays in ``results``:

    import MDAnalysis, pliant.mdanalysis, pliant.measure
    universe = MDAnalysis.Universe("out.h5md")
    rmsf = pliant.measure.Rmsf(universe.atoms).run().results.rmsf  # (n,) Angstrom

Units are MDAnalysis': Angstrom, ps, u, degrees. A frame means a recorded frame, from 0.
"""

from typing import TYPE_CHECKING

from pliant.base.late_names import late_names

if TYPE_CHECKING:
    from pliant.measure.gyration import RadiusOfGyration
    from pliant.measure.pca import PrincipalComponents
    from pliant.measure.residuals import BarResiduals, bar_residuals
    from pliant.measure.rmsd import RmsdToStart
    from pliant.measure.rmsf import Rmsf
    from pliant.measure.rotatable import Torsion, rotatable_torsions
    from pliant.measure.torsions import TorsionDistributions
    from pliant.trajectory.superposition import Superposition

__all__ = [
    "BarResiduals",
    "PrincipalComponents",
    "RadiusOfGyration",
    "RmsdToStart",
    "Rmsf",
    "Superposition",
    "Torsion",
    "TorsionDistributions",
    "bar_residuals",
    "rotatable_torsions",
]

__getattr__ = late_names(
    __name__,
    {
        "BarResiduals": "pliant.measure.residuals",
        "PrincipalComponents": "pliant.measure.pca",
        "RadiusOfGyration": "pliant.measure.gyration",
        "RmsdToStart": "pliant.measure.rmsd",
        "Rmsf": "pliant.measure.rmsf",
        "Superposition": "pliant.trajectory.superposition",
        "Torsion": "pliant.measure.rotatable",
        "TorsionDistributions": "pliant.measure.torsions",
        "bar_residuals": "pliant.measure.residuals",
        "rotatable_torsions": "pliant.measure.rotatable",
    },
)
