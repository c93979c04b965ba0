# SPDX-License-Identifier: MIT
"""``pliant.view``: a molecule or a trajectory in a notebook, to be pulled on and played."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pliant._core import (
    Error,
    Framework,
    Graph,
    OptionError,
    Structure,
    models,
    read,
    write_topology_pdb,
)
from pliant.base.checked import checked, whole
from pliant.base.extras import need
from pliant.play import page
from pliant.trajectory.sources import structure_of
from pliant.trajectory.trajectory import HasFrames

if TYPE_CHECKING:
    from pliant.play.widget import PlayView


@dataclass
class Given:
    """A file for the page, and what is known better than it says."""

    name: str
    data: bytes
    start: NDArray[np.float64] = field(default_factory=lambda: np.empty((0, 3)))
    known: dict[str, Any] = field(default_factory=dict)


@checked(height=whole(1))
def view(source: Any, *, model: str = "auto", height: int = 560) -> PlayView:
    """Show a molecule or a trajectory in a notebook, on the page of ``pliant play``.

    Drag a joint to pull it, choose a technique, let it wander, play a trajectory. The page works in
    the notebook itself; where the joints are comes back as ``positions``.

    Parameters
    ----------
    source : Structure, path, Graph, SampledEnsemble, RunResult, MolecularPath, Trajectory, ...
        A path is of any file that Pliant reads, or of an H5MD trajectory. Of a Universe of
        MDAnalysis and of molecules of other packages the current or first frame.
    model : str
        What holds the molecule: a name in ``models()``, or "auto" for what fits. The model of a
        protein takes waters out and adds polar hydrogens: ``names`` then tells which joints there
        are. "bonds" leaves atoms as they are.
    height : int
        In pixels.

    Returns
    -------
    PlayView
        A widget, which the last line of a cell shows: ``positions`` (N, 3) in Angstrom, ``names``.

    Raises
    ------
    ImportError
        anywidget is not installed; the message says how to install it.
    OptionError
        No such model.
    TypeError
        Not a source that can be shown.
    Error
        The package was built without the page.
    InputError, FileError
        The file cannot be read.
    """
    need("pliant.view", "anywidget")
    from pliant.play.widget import PlayView

    known = ["auto", *(row.name for row in models())]
    if model not in known:
        raise OptionError(f"model {model!r}: expected one of {', '.join(known)}")
    given = given_of(source)
    bare = page.page_file().read_bytes()
    full = page.with_file(
        bare, given.name, given.data, model=model, isInside=True, known=given.known
    )
    return PlayView(full, given.start, height, still_of(source, given.start))


def still_of(source: Any, start: NDArray[np.float64]) -> bytes:
    """A picture of it as it is given, b"" where that cannot be had: the page tells why."""
    from pliant.play.still import picture

    try:
        if isinstance(source, (str, os.PathLike)):
            structure = read(source)
            return picture(structure.positions, structure.elements)
        elements = getattr(source, "elements", None)
        alike = elements is not None and len(elements) == len(start)
        return picture(start, elements if alike else None)
    except (Error, TypeError, ValueError):
        return b""


def given_of(source: Any) -> Given:
    """The file that shows a source. Raises as `view` does."""
    if isinstance(source, (str, os.PathLike)):
        path = Path(source)
        return Given(path.name, page.read_given(path))
    if isinstance(source, Graph):
        return Given("graph.xml", source.text().encode(), np.array(source.positions))
    if isinstance(getattr(source, "path", None), (str, os.PathLike)):
        return given_of(source.path)
    if isinstance(source, HasFrames):
        return _of_frames(source)
    if isinstance(source, Framework):
        raise TypeError(
            "view: a Framework has no positions: pliant.view(structure), or "
            "pliant.view(pliant.Trajectory(structure, positions))"
        )
    return _of_structure(structure_of(source))


def _of_frames(source: HasFrames) -> Given:
    """A trajectory, to be played."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory() as folder:
        path = source.save(Path(folder) / "frames.h5md")
        return Given(path.name, page.read_given(path), np.array(source[0]))


def _of_structure(structure: Structure) -> Given:
    """A PDB file, with each digit of the positions and the bonds beside it."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory() as folder:
        file = Path(folder) / "structure.pdb"
        centred = structure.positions - structure.positions.mean(axis=0)  # fits the format sooner
        write_topology_pdb(file, structure, positions=centred)
        data = file.read_bytes()
    bonds = np.column_stack([structure.bonds, structure.bond_orders])
    known = {"positions": structure.positions.ravel().tolist(), "bonds": bonds.ravel().tolist()}
    return Given(
        f"{structure.title or 'structure'}.pdb", data, np.array(structure.positions), known
    )
