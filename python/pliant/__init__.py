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
    contacts,
    continue_run,
    continue_sample,
    estimate_b_factors,
    prepare,
    read,
    resolve,
    rigidity,
    run,
    sample,
)
from pliant._deprecated import PliantDeprecationWarning
from pliant._display import show_in_notebooks
from pliant._late import import_after
from pliant._refusals.signatures import give_signatures
from pliant._trajectory.results import RunResult, SampledEnsemble, SampleResult
from pliant._trajectory.trajectory import Trajectory
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
from pliant.play.view import view

if TYPE_CHECKING:
    from pliant.analyse import analyse
    from pliant.check import check
    from pliant.compare import compare
    from pliant.conformers import conformers
    from pliant.convert import convert
    from pliant.path import path
    from pliant.representatives import representatives
    from pliant.study import study
else:
    # Packages that are called; what they need beyond NumPy and h5py is imported when they are.
    # Two stand for functions of _core.
    del conformers, path
    from pliant import analyse, check, compare, conformers, convert, path, representatives, study

#: What users call, and what is promised: docs/pages/stability.md.
__all__ = [
    "Error",
    "FileError",
    "Frame",
    "Framework",
    "InputError",
    "MolecularModel",
    "Motion",
    "OptionError",
    "PliantDeprecationWarning",
    "PliantWarning",
    "Preparation",
    "ResolveSummary",
    "Resolver",
    "Rigidity",
    "RunResult",
    "SampleResult",
    "SampledEnsemble",
    "State",
    "Steering",
    "Structure",
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
    "estimate_b_factors",
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

# MDAnalysis.Universe("out.h5md") has names and bonds wherever both are imported.
import_after("MDAnalysis", "pliant.h5md_parser")
import_after("MDAnalysis", "pliant.ensemble.reader")

show_in_notebooks()
give_signatures(_core.read, _core.Steering.release, _core.Steering().release)


def __dir__() -> list[str]:
    """What users call, without the modules that it comes from."""
    return sorted(__all__)
