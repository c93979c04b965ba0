# SPDX-License-Identifier: MIT
"""Frames of one molecule as one object, which other packages' objects become and are made of."""

from __future__ import annotations

import copy
import os
from collections.abc import Iterator, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from pliant._core import OptionError, Structure
from pliant.base.display import Displayed, Facts
from pliant.base.extras import late
from pliant.trajectory.frames import Frames, FramesInMemory, Positions
from pliant.trajectory.opened import frames_of
from pliant.trajectory.sources import Molecule, structure_of

if TYPE_CHECKING:
    import MDAnalysis
    import mdtraj
    import openmm.app
    import prody
    from rdkit.Chem import Mol

    from pliant.play.widget import PlayView

adapters, writing = late("pliant.adapters"), late("pliant.adapters.convert.write")
play, report = late("pliant.play.view"), late("pliant.report.suite")

#: What chooses frames: a slice, numbers of frames, or a truth value for each.
Chosen = slice | Sequence[int] | npt.NDArray[np.generic]


class HasFrames:
    """What every result with frames can do: that of `sample`, `run`, `path`; a `Trajectory`."""

    @property
    def trajectory(self) -> Trajectory:
        """The frames with their atoms and bonds; those of a file are read when asked for."""
        raise NotImplementedError

    @property
    def structure(self) -> Structure:
        """The atoms and bonds."""
        return self.trajectory.structure

    def __len__(self) -> int:
        return len(self.trajectory)

    def __iter__(self) -> Iterator[Positions]:
        frames = self.trajectory
        return (frames[k] for k in range(len(frames)))

    @overload
    def __getitem__(self, frame: int) -> Positions: ...

    @overload
    def __getitem__(self, frame: Chosen) -> Trajectory: ...

    def __getitem__(self, frame: int | Chosen) -> Positions | Trajectory:
        """One frame, (N, 3) Angstrom; of a slice or an array of numbers a `Trajectory`."""
        return self.trajectory[frame]

    def save(
        self,
        output: str | os.PathLike[str],
        *,
        select: str = "",
        every: int = 1,
        superpose: bool = False,
        overwrite: bool = False,
    ) -> Path:
        """Writes the frames in the format that the name asks for, as `convert` does.

        Parameters
        ----------
        output : str or path
            Ends in .h5md, .pdb, .ent, .cif, .mmcif, .sdf, .dcd, .xtc, .trr, .xyz or .zarr.
        select, every, superpose, overwrite
            As for `convert`.

        Returns
        -------
        Path
            The file.

        Raises
        ------
        OptionError, InputError, FileError, ImportError
            As `convert`.
        """
        how = {"select": select, "every": every, "superpose": superpose, "overwrite": overwrite}
        writing.convert(self, output, **how)
        return Path(output)

    def to_mdanalysis(self) -> MDAnalysis.Universe:
        """A Universe with names, residues and bonds, and all frames in memory."""
        return adapters.to_mdanalysis(self)

    def to_rdkit(self) -> Mol:
        """An rdkit.Chem.Mol with a conformer for each frame."""
        made: Mol = adapters.to_rdkit(self)
        return made

    def to_openmm(self, frame: int = 0) -> openmm.app.Modeller:
        """An openmm.app.Modeller: the topology, with the positions of one frame."""
        return adapters.to_openmm(self, frame)

    def to_prody(self) -> prody.AtomGroup:
        """A prody.AtomGroup with a coordinate set for each frame."""
        return adapters.to_prody(self)

    def to_mdtraj(self) -> mdtraj.Trajectory:
        """An mdtraj.Trajectory of all frames."""
        return adapters.to_mdtraj(self)

    def view(self, *, model: str = "auto", height: int = 560) -> PlayView:
        """Shows the frames in a notebook, as `pliant.view` does."""
        shown: PlayView = play.view(self, model=model, height=height)
        return shown

    def analyse(self, output: str | os.PathLike[str] | None = None, **options: Any) -> Any:
        """Analyses the frames as `pliant.analyse` does, with its options: an AnalysisReport."""
        return report.analyse(self, output, **options)


class Trajectory(HasFrames, Displayed):
    """Frames of one molecule: positions in memory, or in a file and read when they are asked for.

    ``len``, an index, iteration and slices work as for a list: a frame is an (N, 3) array in
    Angstrom; a slice is a Trajectory.

    Parameters
    ----------
    source : path, Structure, Universe, AtomGroup, rdkit.Chem.Mol, mdtraj.Trajectory, ...
        A file of Pliant, or of models (PDB, mmCIF, SDF, XYZ); all frames of a Universe or of
        mdtraj, all conformers of an RDKit molecule, all coordinate sets of ProDy; a molecule as
        `sample` takes it, for `positions`.
    positions : (F, N, 3) or (N, 3) Angstrom, optional
        Frames in memory, of the atoms of `source`.
    topology : path, optional
        File of atoms, for a trajectory of another program that has none (DCD, XTC).

    Raises
    ------
    TypeError
        Nothing that has frames; the message lists what has.
    InputError, FileError
        The file cannot be read, or has other atoms than `source` or `topology`.
    """

    def __init__(
        self,
        source: Molecule | Structure,
        positions: npt.ArrayLike | None = None,
        *,
        topology: str | os.PathLike[str] | None = None,
    ) -> None:
        if positions is not None and topology is not None:
            raise OptionError("topology: goes with a file, not with positions")
        chosen = None
        if positions is not None:
            frames: Frames = FramesInMemory(structure_of(source), positions)
        elif isinstance(source, HasFrames):
            frames, chosen = source.trajectory._frames, source.trajectory._chosen
        else:
            frames = frames_of(source, topology)
        self._take(frames, chosen)

    def _take(self, frames: Frames, chosen: npt.NDArray[np.int64] | None) -> None:
        self._frames = frames
        self._chosen = np.arange(len(frames)) if chosen is None else chosen

    @classmethod
    def _of(cls, frames: Frames, chosen: npt.NDArray[np.int64] | None = None) -> Trajectory:
        made = cls.__new__(cls)
        made._take(frames, chosen)
        return made

    @property
    def trajectory(self) -> Trajectory:
        """Itself."""
        return self

    @cached_property
    def structure(self) -> Structure:
        """The atoms and bonds, at the first frame."""
        known = self._frames.structure
        if len(self) == 0 or np.array_equal(self[0], known.positions):
            return known
        moved = copy.copy(known)
        moved.positions = self[0]
        return moved

    @property
    def positions(self) -> Positions:
        """(F, N, 3) float64, Angstrom: all frames, read at once where they are in a file."""
        whole = len(self._chosen) == len(self._frames)
        if isinstance(self._frames, FramesInMemory):
            return self._frames.values if whole else self._frames.values[self._chosen]
        shape = (len(self), len(self.structure), 3)
        return np.array([self[k] for k in range(len(self))], dtype=np.float64).reshape(shape)

    @property
    def path(self) -> Path | None:
        """The file that the frames are in, if they are all of it."""
        return self._frames.path if len(self._chosen) == len(self._frames) else None

    def __len__(self) -> int:
        return len(self._chosen)

    @overload
    def __getitem__(self, frame: int) -> Positions: ...

    @overload
    def __getitem__(self, frame: Chosen) -> Trajectory: ...

    def __getitem__(self, frame: int | Chosen) -> Positions | Trajectory:
        """One frame, (N, 3) Angstrom; of a slice or an array of numbers a `Trajectory`."""
        if isinstance(frame, (int, np.integer)):
            return self._frames.positions(self._number(int(frame)))
        if isinstance(frame, slice):
            return self._of(self._frames, self._chosen[frame])
        return self._of(self._frames, self._chosen[np.asarray(frame)])

    def _number(self, frame: int) -> int:
        """Of a frame in the file."""
        if not -len(self) <= frame < len(self):
            raise IndexError(f"frame {frame}: there are {len(self)}, numbered from 0")
        return int(self._chosen[frame])

    def step(self, frame: int) -> int:
        """The step or number of a frame where it was made."""
        return self._frames.step(self._number(frame))

    def time(self, frame: int) -> float:
        """Of a frame, in ps; its number where no time is known."""
        return self._frames.time(self._number(frame))

    def _walker(self, frame: int) -> int | None:
        return self._frames.walker(self._number(frame))

    def facts(self) -> Facts:
        """How many frames, of what."""
        atoms = f"{len(self.structure)} atoms"
        found = [("frames", f"{len(self)}, of {atoms}"), ("molecule", self.structure.source)]
        return [*found, ("file", str(self.path or ""))] if self.path else found

    def __repr__(self) -> str:
        return f"<pliant.Trajectory: {len(self)} frames of {len(self.structure)} atoms>"
