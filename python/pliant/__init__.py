# SPDX-License-Identifier: MIT
"""Molecular flexibility by geometric constraints.

Units everywhere: length Angstrom, time ps, mass u, force kJ/(mol Angstrom), energy kJ/mol.
"""

from pliant import _core
from pliant._core import (
    Error,
    FileError,
    Frame,
    Framework,
    GraphFacts,
    InputError,
    OptionError,
    OrderingEntry,
    PerturbationEntry,
    PliantWarning,
    Repeat,
    ResidualSummary,
    Resolver,
    ResolveSummary,
    RunSummary,
    State,
    Stop,
    TechniqueEntry,
    __version__,
    measure,
    order,
    orderings,
    perturbations,
    residuals,
    resolve,
    techniques,
)
from pliant._run import run

__all__ = [
    "Error",
    "FileError",
    "Frame",
    "Framework",
    "GraphFacts",
    "InputError",
    "OptionError",
    "OrderingEntry",
    "PerturbationEntry",
    "PliantWarning",
    "Repeat",
    "ResidualSummary",
    "ResolveSummary",
    "Resolver",
    "RunSummary",
    "State",
    "Stop",
    "TechniqueEntry",
    "__version__",
    "measure",
    "order",
    "orderings",
    "perturbations",
    "residuals",
    "resolve",
    "run",
    "techniques",
]

# Messages and help call things by the name under which users find them.
for _name in __all__:
    if isinstance(getattr(_core, _name, None), type):
        getattr(_core, _name).__module__ = "pliant"
del _name
