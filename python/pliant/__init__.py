# SPDX-License-Identifier: MIT
"""Molecular flexibility by geometric constraints.

Units of measure: length Angstrom, time ps, mass u, force kJ/(mol Angstrom), energy kJ/mol, but of
contacts kcal/mol.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pliant import _core

# What the package, its laboratory and its tests call: not promised, and not in dir().
from pliant._core import *  # noqa: F403
from pliant._core import (
    DensityMap,
    Error,
    FileError,
    Frame,
    Framework,
    InputError,
    MolecularModel,
    Motion,
    OptionError,
    PliantWarning,
    Preparation,
    Resolver,
    ResolveSummary,
    Rigidity,
    State,
    Steering,
    Structure,
    build_model,
    conformers,
    contacts,
    continue_run,
    continue_sample,
    estimate_b_factors,
    path,
    prepare,
    read,
    resolve,
    rigidity,
    run,
    sample,
)
from pliant.adapters import constraints_from_openmm as constraints_from_openmm
from pliant.adapters import (
    from_mdanalysis,
    from_mdtraj,
    from_openmm,
    from_prody,
    from_rdkit,
    from_smiles,
    to_mdanalysis,
    to_mdtraj,
    to_openmm,
    to_prody,
    to_rdkit,
)
from pliant.base.deprecated import PliantDeprecationWarning
from pliant.base.display import show_in_notebooks
from pliant.base.late_names import late_names
from pliant.base.signatures import give_signatures
from pliant.play.view import view
from pliant.trajectory.results import RunResult, SampledEnsemble, SampleResult
from pliant.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    from pliant.adapters.convert.write import convert
    from pliant.jobs.conformers.results import Conformers
    from pliant.jobs.fit.design import Design, design
    from pliant.jobs.fit.fit import FittedStructure, fit
    from pliant.jobs.path.found import MolecularPath
    from pliant.measure.shapes.representatives import Representatives
    from pliant.report.check.check_report import CheckReport
    from pliant.report.check.suite import check
    from pliant.report.compare.comparison_report import ComparisonReport
    from pliant.report.compare.suite import compare
    from pliant.report.representatives import representatives
    from pliant.report.study.studied import Study
    from pliant.report.study.suite import study
    from pliant.report.suite import AnalysisReport, analyse

#: What users call, and what is promised: docs/pages/stability.md.
__all__ = [
    "AnalysisReport",
    "CheckReport",
    "ComparisonReport",
    "Conformers",
    "DensityMap",
    "Design",
    "Error",
    "FileError",
    "FittedStructure",
    "Frame",
    "Framework",
    "InputError",
    "MolecularModel",
    "MolecularPath",
    "Motion",
    "OptionError",
    "PliantDeprecationWarning",
    "PliantWarning",
    "Preparation",
    "Representatives",
    "ResolveSummary",
    "Resolver",
    "Rigidity",
    "RunResult",
    "SampleResult",
    "SampledEnsemble",
    "State",
    "Steering",
    "Structure",
    "Study",
    "Trajectory",
    "__version__",
    "analyse",
    "build_model",
    "check",
    "compare",
    "conformers",
    "contacts",
    "continue_run",
    "continue_sample",
    "convert",
    "design",
    "estimate_b_factors",
    "fit",
    "from_mdanalysis",
    "from_mdtraj",
    "from_openmm",
    "from_prody",
    "from_rdkit",
    "from_smiles",
    "path",
    "prepare",
    "read",
    "representatives",
    "resolve",
    "rigidity",
    "run",
    "sample",
    "study",
    "to_mdanalysis",
    "to_mdtraj",
    "to_openmm",
    "to_prody",
    "to_rdkit",
    "view",
]

__version__ = _core.version()

# Messages and help call things by the name under which users find them.
for _type in (RunResult, SampledEnsemble, SampleResult, Trajectory):
    _type.__module__ = "pliant"
for _name, _type in vars(_core).items():
    if isinstance(_type, type) and not _name.startswith("_"):
        _type.__module__ = "pliant"
        if _name.startswith("Test"):
            _type.__test__ = False  # type: ignore[attr-defined]  # pytest takes it for tests
del _name, _type

#: What these need beyond NumPy and h5py is imported when they are used.
__getattr__ = late_names(
    __name__,
    {
        "AnalysisReport": "pliant.report.suite",
        "CheckReport": "pliant.report.check.check_report",
        "ComparisonReport": "pliant.report.compare.comparison_report",
        "Conformers": "pliant.jobs.conformers.results",
        "Design": "pliant.jobs.fit.design",
        "FittedStructure": "pliant.jobs.fit.fitted",
        "MolecularPath": "pliant.jobs.path.found",
        "Representatives": "pliant.measure.shapes.representatives",
        "Study": "pliant.report.study.studied",
        "analyse": "pliant.report.suite",
        "check": "pliant.report.check.suite",
        "compare": "pliant.report.compare.suite",
        "convert": "pliant.adapters.convert.write",
        "design": "pliant.jobs.fit.design",
        "fit": "pliant.jobs.fit.fit",
        "representatives": "pliant.report.representatives",
        "study": "pliant.report.study.suite",
    },
)

show_in_notebooks()
give_signatures(_core.read, _core.Steering.release, _core.Steering().release)


def __dir__() -> list[str]:
    """What users call, without the modules that it comes from."""
    return sorted(__all__)
