# SPDX-License-Identifier: MIT
"""Frames as MDAnalysis has them: universes of files and of frames, and the formats that it learns.

Importing this module registers the formats of Pliant, H5MD and ensembles, with MDAnalysis.
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import MDAnalysis
import numpy as np
from MDAnalysis.coordinates.core import get_reader_for
from MDAnalysis.coordinates.H5MD import H5MDReader
from MDAnalysis.core import topologyattrs as attributes
from MDAnalysis.core._get_readers import get_parser_for
from MDAnalysis.core.topology import Topology
from MDAnalysis.topology.base import TopologyReaderBase
from MDAnalysis.topology.MinimalParser import MinimalParser

from pliant._core import Error, InputError, PliantWarning, Structure
from pliant.trajectory.chains import NO_CHAIN
from pliant.trajectory.frames import Frames, check_atoms
from pliant.trajectory.frames_reader import FramesReader, expect_sound, is_ours
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.opened import (
    FramesOfUniverse,
    expect_trajectory,
    frames_of,
    is_recorded,
    recorded,
)
from pliant.trajectory.shards.plan import PLAN, folder_of, is_ensemble
from pliant.trajectory.sources import H5MD, structure_of

if TYPE_CHECKING:
    import numpy.typing as npt
    from MDAnalysis import Universe

MOST_OF_A_REASON = 300  #: letters of what MDAnalysis says


class FramesParser(TopologyReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """The topology of an H5MD file of ours, or of an ensemble: every shard has it."""

    format = "PLIANT"
    _format_hint = staticmethod(is_ours)

    def parse(self, **kwargs: object) -> Topology:
        """Return the topology."""
        return topology_of(frames_of(self.filename))


class H5MDParser(TopologyReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """Read the topology of an H5MD file.

    A file with our atom table gives names, elements (as types, too), masses, serials (`ids`),
    residues, chains (as segments, too) and bonds with order, whose `is_guessed` tells the bonds
    that were found by distance. A file that we recorded without names gives masses and bonds.
    Any other H5MD file gives atoms without names.
    """

    format = "H5MD"

    def parse(self, **kwargs: object) -> Topology:
        """Return the topology of the file.

        Raises
        ------
        InputError
            The atom table does not fit the positions: the file is damaged.
        """
        expect_sound(self.filename)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", PliantWarning)  # of units that are not there
                frames = FramesOfH5md(Path(self.filename))
        except InputError:  # without positions, say: MDAnalysis says what it thinks of it
            return MinimalParser(self.filename).parse(**kwargs)
        return topology_of(frames)


def topology_of(frames: Frames) -> Topology:
    """Names, residues, chains and bonds of frames."""
    structure = frames.structure
    masses = attributes.Masses(frames.masses)
    if not frames.has_names:
        known = [masses] if frames.masses.any() else []
        return Topology(len(structure), 1, 1, attrs=[*known, *_bonds(structure)])
    first = np.searchsorted(structure.residue_of, np.arange(structure.residue_count))
    segments, segment_of = _segments(structure.chains[first])
    return Topology(
        len(structure),
        len(first),
        len(segments),
        atom_resindex=structure.residue_of.astype(np.intp),
        residue_segindex=segment_of,
        attrs=[
            masses,
            *_atom_attributes(structure),
            *_residue_attributes(structure, first),
            attributes.Segids(segments),
            *_bonds(structure),
        ],
    )


def _atom_attributes(structure: Structure) -> list[Any]:
    elements = np.where(structure.elements == 0, "", structure.symbols).astype(object)
    return [
        attributes.Atomnames(structure.names.astype(object)),
        attributes.Elements(elements),
        attributes.Atomtypes(elements.copy()),
        attributes.Atomids(structure.serials),
        attributes.ChainIDs(structure.chains.astype(object)),
    ]


def _residue_attributes(structure: Structure, first: npt.NDArray[np.intp]) -> list[Any]:
    numbers = structure.residue_ids[first]
    return [
        attributes.Resids(numbers),
        attributes.Resnums(numbers.copy()),
        attributes.Resnames(structure.residue_names[first].astype(object)),
        attributes.ICodes(structure.insertion_codes[first].astype(object)),
    ]


def _segments(chains: npt.NDArray[np.str_]) -> tuple[npt.NDArray[np.object_], npt.NDArray[np.intp]]:
    """Names of the segments, one a chain in order of appearance, and each residue's segment."""
    order = {chain: index for index, chain in enumerate(dict.fromkeys(chains.tolist()))}
    segment_of = np.array([order[chain] for chain in chains.tolist()], dtype=np.intp)
    names = [NO_CHAIN] if list(order) == [""] else list(order)
    return np.array(names, dtype=object), segment_of


def _bonds(structure: Structure) -> list[Any]:
    if len(structure.bonds) == 0:
        return []
    return [
        attributes.Bonds(
            [tuple(pair) for pair in structure.bonds.tolist()],
            guessed=[origin == "distance" for origin in structure.bond_origins.tolist()],
            # 4 is aromatic, 0 not known.
            order=[{0: None, 4: 1.5}.get(one, one) for one in structure.bond_orders.tolist()],
        )
    ]


def universe_of(frames: Frames) -> Universe:
    """A universe that reads these frames."""
    universe = MDAnalysis.Universe(topology_of(frames))
    universe.trajectory = FramesReader(frames)
    return universe


def open_frames(
    path: str | os.PathLike[str], topology: str | os.PathLike[str] | None = None
) -> tuple[Frames, Universe]:
    """The frames of a trajectory file, and the universe that has them.

    Files that are not ours are read by MDAnalysis. Raises as `frames_of` and `open_universe`.
    """
    if is_recorded(path):
        frames = recorded(path)
        return frames, universe_of(frames) if topology is None else open_universe(path, topology)
    universe = open_universe(path, topology)
    return FramesOfUniverse(universe), universe


def open_universe(
    path: str | os.PathLike[str], topology: str | os.PathLike[str] | None = None
) -> Universe:
    """The MDAnalysis.Universe of a trajectory file, with a topology file or its own.

    Raises InputError with one line: no such file, no frames, no or a wrong topology.
    """
    path = folder_of(Path(path)) / PLAN if is_ensemble(path) else Path(path)
    for file in (path, topology):
        if file is not None:
            expect_trajectory(Path(file))
    files = [str(path)] if topology is None else [os.fspath(topology), str(path)]
    options = {}
    if path.suffix.lower() in H5MD and not is_ours(path):
        expect_sound(path)
        options = {"format": "H5MD"}
        options |= {} if topology is not None else {"topology_format": "H5MD"}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of missing masses and the like
            universe = MDAnalysis.Universe(*files, **options)
            count = len(universe.trajectory)
    except Exception as error:  # MDAnalysis raises whatever its readers meet
        raise _unreadable(path, topology, error) from error
    if count == 0:
        raise InputError(f"{path}: holds no frame")
    return universe


def nameless_count(path: str | os.PathLike[str]) -> int | None:
    """Atoms of a trajectory whose format has no names; None if it has, or is unknown."""
    expect_trajectory(Path(path))
    try:
        if get_parser_for(os.fspath(path)) is not MinimalParser:
            return None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with get_reader_for(os.fspath(path))(os.fspath(path)) as reader:
                return int(reader.n_atoms)
    except Exception as error:  # each of MDAnalysis' readers has its own kinds
        raise _unreadable(Path(path), None, error) from error


def _unreadable(
    path: Path, topology: str | os.PathLike[str] | None, error: Exception
) -> InputError:
    reason = " ".join(str(error).split())[:MOST_OF_A_REASON] or type(error).__name__
    if topology is None:
        advice = "; --topology FILE names one with the atoms"
        return InputError(f"{path}: MDAnalysis cannot read it: {reason}{advice}")
    what = f"{path} with topology {os.fspath(topology)}"
    if path.suffix.lower() in H5MD:
        _expect_prepared(what, topology, recorded(path).atom_count)
    return InputError(f"{what}: MDAnalysis cannot read it: {reason}")


def _expect_prepared(what: str, topology: str | os.PathLike[str], count: int) -> None:
    """Raises InputError where a topology is that of what was sampled, not of what was prepared."""
    try:
        structure = structure_of(topology)
    except Error:  # MDAnalysis says what is wrong with it
        return
    check_atoms(structure, count, what)


def source_of(trajectory: Any) -> Frames | None:
    """The frames, in double precision, that a trajectory of MDAnalysis shows; None: it has them."""
    if isinstance(trajectory, FramesReader):
        shown: Frames = trajectory.source
        return shown
    is_named = isinstance(trajectory.filename, (str, os.PathLike))
    if isinstance(trajectory, H5MDReader) and is_named:
        return FramesOfH5md(Path(trajectory.filename))
    return None
