# SPDX-License-Identifier: MIT
"""Molecular flexibility by geometric constraints.

Units of measure: length Angstrom, time ps, mass u, force kJ/(mol Angstrom), energy kJ/mol, but of
contacts kcal/mol.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pliant import _core
from pliant._core import (
    ContactKindEntry,
    Error,
    Example,
    ExampleFacts,
    FileError,
    ForceFile,
    Format,
    Frame,
    Framework,
    FrameworkRigidity,
    Graph,
    GraphClass,
    GraphFacts,
    Guide,
    H5mdReader,
    H5mdRecorder,
    InputError,
    ModelEntry,
    MolecularModel,
    Motion,
    NetworkEntry,
    OptionError,
    OrderingEntry,
    PdbRecorder,
    PerturbationEntry,
    PliantWarning,
    Preparation,
    Repeat,
    ResidualSummary,
    Resolver,
    ResolveSummary,
    Rigidity,
    RunOptions,
    RunSummary,
    SamplerEntry,
    SampleSummary,
    State,
    Steering,
    Sterics,
    Stop,
    Structure,
    TechniqueEntry,
    TestClass,
    TestGraph,
    TestHeuristic,
    TestResults,
    TestSet,
    TorsionPreferences,
    WalkerResolver,
    build_model,
    choose_technique,
    contact_kinds,
    contacts,
    continue_sample,
    estimate_b_factors,
    examples,
    formats,
    generate,
    graph_classes,
    lane_levels,
    make_force_file,
    measure,
    mode_field,
    models,
    network_modes,
    networks,
    node_b_factors,
    order,
    ordering_text,
    orderings,
    perturbations,
    prepare,
    pushers,
    read,
    read_contacts,
    read_force_file,
    read_graph_xml,
    read_ordering_file,
    read_test_set,
    read_text,
    residuals,
    resolve,
    rigidity,
    sample,
    samplers,
    techniques,
    techniques_for,
    write_test_set,
    write_topology_pdb,
)
from pliant._deprecated import PliantDeprecationWarning
from pliant._display import show_in_notebooks
from pliant._ensemble import run_ensemble
from pliant._late import import_after
from pliant._refusals.signatures import give_signatures
from pliant._run import continue_run, run
from pliant._trajectory.results import RunResult, SampledEnsemble, SampleResult
from pliant._trajectory.trajectory import Trajectory
from pliant.adapters import (
    constraints_from_openmm,
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
    from pliant import analyse, check, compare, conformers, convert, path, representatives, study

__all__ = [
    "ContactKindEntry",
    "Error",
    "Example",
    "ExampleFacts",
    "FileError",
    "ForceFile",
    "Format",
    "Frame",
    "Framework",
    "FrameworkRigidity",
    "Graph",
    "GraphClass",
    "GraphFacts",
    "Guide",
    "H5mdReader",
    "H5mdRecorder",
    "InputError",
    "ModelEntry",
    "MolecularModel",
    "Motion",
    "NetworkEntry",
    "OptionError",
    "OrderingEntry",
    "PdbRecorder",
    "PerturbationEntry",
    "PliantDeprecationWarning",
    "PliantWarning",
    "Preparation",
    "Repeat",
    "ResidualSummary",
    "ResolveSummary",
    "Resolver",
    "Rigidity",
    "RunOptions",
    "RunResult",
    "RunSummary",
    "SampleResult",
    "SampleSummary",
    "SampledEnsemble",
    "SamplerEntry",
    "State",
    "Steering",
    "Sterics",
    "Stop",
    "Structure",
    "TechniqueEntry",
    "TestClass",
    "TestGraph",
    "TestHeuristic",
    "TestResults",
    "TestSet",
    "TorsionPreferences",
    "Trajectory",
    "WalkerResolver",
    "__version__",
    "analyse",
    "build_model",
    "check",
    "choose_technique",
    "compare",
    "conformers",
    "constraints_from_openmm",
    "contact_kinds",
    "contacts",
    "continue_run",
    "continue_sample",
    "convert",
    "estimate_b_factors",
    "examples",
    "formats",
    "from_mdanalysis",
    "from_mdtraj",
    "from_openmm",
    "from_prody",
    "from_rdkit",
    "from_smiles",
    "generate",
    "graph_classes",
    "lane_levels",
    "make_force_file",
    "measure",
    "mode_field",
    "models",
    "network_modes",
    "networks",
    "node_b_factors",
    "order",
    "ordering_text",
    "orderings",
    "path",
    "perturbations",
    "prepare",
    "pushers",
    "read",
    "read_contacts",
    "read_force_file",
    "read_graph_xml",
    "read_ordering_file",
    "read_test_set",
    "read_text",
    "representatives",
    "residuals",
    "resolve",
    "rigidity",
    "run",
    "run_ensemble",
    "sample",
    "samplers",
    "study",
    "techniques",
    "techniques_for",
    "to_mdanalysis",
    "to_mdtraj",
    "to_openmm",
    "to_prody",
    "to_rdkit",
    "view",
    "write_test_set",
    "write_topology_pdb",
]

__version__ = _core.version()

# Messages and help call things by the name under which users find them.
for _type in (RunResult, SampledEnsemble, SampleResult, Trajectory):
    _type.__module__ = "pliant"
del _type
for _name in __all__:
    if isinstance(getattr(_core, _name, None), type):
        getattr(_core, _name).__module__ = "pliant"
        if _name.startswith("Test"):
            getattr(_core, _name).__test__ = False  # pytest takes it for a class of tests
del _name

# MDAnalysis.Universe("out.h5md") has names and bonds wherever both are imported.
import_after("MDAnalysis", "pliant.h5md_parser")
import_after("MDAnalysis", "pliant.ensemble.reader")

show_in_notebooks()
give_signatures(_core.read, _core.RunOptions.check, _core.RunOptions().check)


def __dir__() -> list[str]:
    """What users call, without the modules that it comes from."""
    return sorted(__all__)
