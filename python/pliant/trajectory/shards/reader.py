# SPDX-License-Identifier: MIT
"""MDAnalysis opens an ensemble: ``MDAnalysis.Universe("DIR/ensemble.pliant")``.

All shards are one trajectory, in the order of their walkers; ``ts.data`` has step, walker and the
observables of each frame. Importing this module registers the reader; `import pliant` does so too,
as soon as MDAnalysis is there.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pliant.base.extras import needed_by
from pliant.trajectory.shards.frames import EnsembleFrames, folder_of
from pliant.trajectory.shards.open_shard import open_shard

with needed_by("pliant.trajectory.shards.reader"):
    from MDAnalysis.coordinates.base import ReaderBase
    from MDAnalysis.topology.base import TopologyReaderBase

    from pliant.trajectory.h5md_parser import H5MDParser


class EnsembleParser(TopologyReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """The topology that every shard holds, from the first."""

    format = "PLIANT"

    def parse(self, **kwargs: object) -> Any:
        """Return the topology of the ensemble."""
        frames = EnsembleFrames(folder_of(Path(self.filename)))
        open_shard(frames.paths[0]).close()  # says what to do where it is gone
        with H5MDParser(str(frames.paths[0])) as parser:
            return parser.parse(**kwargs)


class EnsembleReader(ReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """The frames of all shards, as one trajectory."""

    format = "PLIANT"
    units = {"time": "ps", "length": "Angstrom"}  # noqa: RUF012  (as MDAnalysis has it)

    def __init__(self, filename: str, **kwargs: object) -> None:
        super().__init__(filename, **kwargs)
        self._frames = EnsembleFrames(folder_of(Path(filename)))
        self.n_atoms = self._frames.atom_count
        timing = {"dt": self._frames.time_between_frames() or 1.0, **self._ts_kwargs}
        self.ts = self._Timestep(self.n_atoms, positions=True, **timing)
        self._frame = -1
        self._read_next_timestep()

    @property
    def n_frames(self) -> int:
        """Frames of all shards."""
        return len(self._frames)

    def _reopen(self) -> None:
        self._frame = -1

    def close(self) -> None:
        """Closes the shards that are open."""
        self._frames.close()

    def _read_next_timestep(self, ts: object = None) -> Any:
        if self._frame + 1 >= self.n_frames:
            raise EOFError
        return self._read_frame(self._frame + 1)

    def _read_frame(self, frame: int) -> Any:
        self.ts.data.update(self._frames.read(frame, self.ts.positions))
        self._frame = self.ts.frame = frame
        return self.ts
