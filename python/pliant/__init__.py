# SPDX-License-Identifier: MIT
"""Molecular flexibility by geometric constraints.

Units everywhere: length Angstrom, time ps, mass u, force kJ/(mol Angstrom), energy kJ/mol.
"""

from pliant import _core
from pliant._core import (
    Error,
    FileError,
    ForceFile,
    Format,
    Frame,
    Framework,
    GraphFacts,
    H5mdReader,
    H5mdRecorder,
    InputError,
    OptionError,
    OrderingEntry,
    PerturbationEntry,
    PliantWarning,
    Repeat,
    ResidualSummary,
    Resolver,
    ResolveSummary,
    RunOptions,
    RunSummary,
    State,
    Stop,
    Structure,
    TechniqueEntry,
    __version__,
    formats,
    measure,
    order,
    orderings,
    perturbations,
    read,
    read_force_file,
    read_text,
    residuals,
    resolve,
    techniques,
)
from pliant._run import run
from pliant.adapters import (
    constraints_from_openmm,
    from_mdanalysis,
    from_openmm,
    from_rdkit,
    to_mdanalysis,
)

__all__ = [
    "Error",
    "FileError",
    "ForceFile",
    "Format",
    "Frame",
    "Framework",
    "GraphFacts",
    "H5mdReader",
    "H5mdRecorder",
    "InputError",
    "OptionError",
    "OrderingEntry",
    "PerturbationEntry",
    "PliantWarning",
    "Repeat",
    "ResidualSummary",
    "ResolveSummary",
    "Resolver",
    "RunOptions",
    "RunSummary",
    "State",
    "Stop",
    "Structure",
    "TechniqueEntry",
    "__version__",
    "constraints_from_openmm",
    "formats",
    "from_mdanalysis",
    "from_openmm",
    "from_rdkit",
    "measure",
    "order",
    "orderings",
    "perturbations",
    "read",
    "read_force_file",
    "read_text",
    "residuals",
    "resolve",
    "run",
    "techniques",
    "to_mdanalysis",
]

# Messages and help call things by the name under which users find them.
for _name in __all__:
    if isinstance(getattr(_core, _name, None), type):
        getattr(_core, _name).__module__ = "pliant"
del _name
