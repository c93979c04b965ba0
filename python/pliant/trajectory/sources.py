# SPDX-License-Identifier: MIT
"""What molecules may be given as: paths, and objects of other packages, none of which is imported.

An object is known by its attributes, so that it may be of a package that is not installed here.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, Protocol, TypeAlias, Union

from pliant import _core
from pliant._core import FileError, OptionError, Structure
from pliant.base.extras import late
from pliant.base.refusals import EXPLAINED, shown

adapters, difflib = late("pliant.adapters"), late("difflib")
opened = late("pliant.trajectory.opened")

H5MD = (".h5md", ".h5", ".hdf5")


class MDAnalysisAtoms(Protocol):
    """A Universe or an AtomGroup of MDAnalysis."""

    atoms: Any
    universe: Any


class RDKitMolecule(Protocol):
    """A Mol of RDKit."""

    def GetConformers(self) -> Any:  # noqa: N802
        """Its conformers."""


class OpenMMTopology(Protocol):
    """A Modeller, PDBFile or Simulation of OpenMM: a topology with positions."""

    topology: Any


class ProDyAtoms(Protocol):
    """An AtomGroup or selection of ProDy."""

    def getCoordsets(self, indices: Any = None) -> Any:  # noqa: N802
        """Its positions, (frames, n, 3)."""


class HasStructure(Protocol):
    """Results of ours: a SampledEnsemble, a Trajectory, a path, rigidity."""

    @property
    def structure(self) -> Structure:
        """The molecule."""


#: What functions take as a molecule, besides a Structure.
Molecule: TypeAlias = Union[
    str,
    "os.PathLike[str]",
    MDAnalysisAtoms,
    RDKitMolecule,
    OpenMMTopology,
    ProDyAtoms,
    HasStructure,
]


class Kind(NamedTuple):
    """One kind of molecule."""

    words: str
    is_it: Callable[[Any], bool]
    structure: Callable[[Any], Structure]  #: at its current or first frame
    #: (F, N, 3) Angstrom of what holds them in memory; of others one frame
    frames: Callable[[Any, Structure], Any]


def _has(*names: str) -> Callable[[Any], bool]:
    return lambda given: all(hasattr(given, name) for name in names)


def _adapter(name: str) -> Callable[[Any], Any]:
    """A function of pliant.adapters, imported when it is called."""
    return lambda given: getattr(adapters, name)(given)


def _frames(name: str) -> Callable[[Any, Structure], Any]:
    call = _adapter(name)
    return lambda given, structure: call(given)[:, structure.source_order]


def _first(given: Any, structure: Structure) -> Any:
    return structure.positions[None]


def _read(path: str | os.PathLike[str], **options: Any) -> Structure:
    """The structure in a file, or the first of a trajectory of ours."""
    if Path(path).suffix.lower() in H5MD:
        found: Structure = opened.one_file(path).structure
        return found
    try:
        return _core.read(path, **options)
    except FileError as error:
        if Path(path).exists():
            raise
        raise FileError(f"{error} {_near(Path(path))}") from None


def _near(path: Path) -> str:
    """What a name that there is not may have been meant for, or where it was looked for."""
    there = os.listdir(path.parent) if path.parent.is_dir() else []
    for like in difflib.get_close_matches(path.name, there, 1, 0.8):
        return f'(did you mean "{(path.parent / like).as_posix()}"?)'
    return f'in {path.parent.resolve()}: give the whole path, such as "/data/{path.name}"'


#: Every kind; the first that fits is taken.
KINDS = (
    Kind("a Structure", lambda x: isinstance(x, Structure), lambda x: x, _first),
    Kind("a path", lambda x: isinstance(x, (str, os.PathLike)), _read, _first),
    Kind(
        "a result of Pliant",
        lambda x: isinstance(getattr(x, "structure", None), Structure),
        lambda x: x.structure,
        _first,
    ),
    Kind(
        "a Universe or AtomGroup of MDAnalysis",
        _has("atoms", "universe"),
        _adapter("from_mdanalysis"),
        _first,
    ),
    Kind(
        "an rdkit.Chem.Mol",
        _has("GetConformers", "GetAtoms"),
        _adapter("from_rdkit"),
        _frames("rdkit_frames"),
    ),
    Kind(
        "an mdtraj.Trajectory",
        _has("xyz", "topology"),
        _adapter("from_mdtraj"),
        _frames("mdtraj_frames"),
    ),
    Kind(
        "a Modeller, PDBFile or Simulation of OpenMM",
        lambda x: hasattr(getattr(x, "topology", None), "residues"),
        _adapter("from_openmm"),
        _first,
    ),
    Kind(
        "an AtomGroup of ProDy",
        _has("getCoordsets", "getNames"),
        _adapter("from_prody"),
        _frames("prody_frames"),
    ),
)


def kind_of(given: object) -> Kind:
    """The row that fits. Raises TypeError, which lists what would."""
    for kind in KINDS:
        if kind.is_it(given):
            return kind
    *first, last = (kind.words for kind in KINDS)
    known = f"{', '.join(first)} or {last}"
    found = "None, which RDKit gives for what it cannot read" if given is None else shown(given)
    raise TypeError(f"molecule = {found}: must be {known}")


EXPLAINED["Molecule"] = kind_of


def structure_of(given: Any) -> Structure:
    """A molecule of any kind as a Structure. Raises TypeError, and as its adapter does."""
    return kind_of(given).structure(given)


def part_of(given: Any, select: str, **reading: Any) -> Structure:
    """The atoms that a selection names; the file at a path is read as `reading` says.

    Raises as `structure_of`, `read` and `Structure.select` do.
    """
    if not reading:
        structure = structure_of(given)
    elif isinstance(given, (str, os.PathLike)) and Path(given).suffix.lower() not in H5MD:
        structure = _read(given, **reading)
    else:
        raise OptionError(f"{next(iter(reading))}: goes with the path of a file of a molecule")
    return structure.select(select) if select else structure
