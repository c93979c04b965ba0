# SPDX-License-Identifier: MIT
"""Analyses of trajectories, built on MDAnalysis' AnalysisBase.

Each class takes atoms of an ``MDAnalysis.Universe``, runs in this process or, with
``run(backend="multiprocessing", n_workers=4)``, in several, and leaves arrays in ``results``:

    import MDAnalysis, pliant.analysis
    universe = MDAnalysis.Universe("out.h5md")
    rmsf = pliant.analysis.Rmsf(universe.atoms).run().results.rmsf  # (n,) Angstrom

Units are MDAnalysis': Angstrom, ps, u, degrees. A frame means a recorded frame, from 0.
"""

from pliant._extras import needed_by

with needed_by("pliant.analysis"):
    from pliant.analysis.gyration import RadiusOfGyration
    from pliant.analysis.pca import PrincipalComponents
    from pliant.analysis.record import RunRecord, read_record
    from pliant.analysis.recorded_contacts import RecordedContacts
    from pliant.analysis.residuals import BarResiduals, bar_residuals
    from pliant.analysis.rmsd import RmsdToStart
    from pliant.analysis.rmsf import Rmsf
    from pliant.analysis.rotatable import Torsion, rotatable_torsions
    from pliant.analysis.superposition import Superposition
    from pliant.analysis.torsions import TorsionDistributions

__all__ = [
    "BarResiduals",
    "PrincipalComponents",
    "RadiusOfGyration",
    "RecordedContacts",
    "RmsdToStart",
    "Rmsf",
    "RunRecord",
    "Superposition",
    "Torsion",
    "TorsionDistributions",
    "bar_residuals",
    "read_record",
    "rotatable_torsions",
]
