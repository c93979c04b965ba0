# SPDX-License-Identifier: MIT
"""A universe whose frames are in a FrameStore: what MDAnalysis' MemoryReader is for an array."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from MDAnalysis.coordinates.base import ReaderBase

from pliant.trajectory.frame_store import AT_ONCE_BYTES

if TYPE_CHECKING:
    from pliant.trajectory.frame_store import FrameStore


class StoreReader(ReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """The frames of a store, read in blocks.

    dimensions: (F, 6) of the boxes as MDAnalysis has them, or None.
    """

    format = "PLIANT_STORE"
    units = {"time": "ps", "length": "Angstrom"}  # noqa: RUF012  (as MDAnalysis has it)

    def __init__(
        self, store: FrameStore, dimensions: np.ndarray | None = None, **kwargs: object
    ) -> None:
        super().__init__("", **kwargs)
        self.filename = None
        self._store = store
        self._dimensions = dimensions
        self.n_frames, self.n_atoms = store.shape[:2]
        self.ts = self._Timestep(self.n_atoms, positions=True, **{"dt": 1.0, **self._ts_kwargs})
        self._block = np.empty((0, self.n_atoms, 3), dtype=np.float32)
        self._first = 0
        self._read_frame(0)

    def copy(self) -> StoreReader:
        """Another reader of the same store, at the same frame."""
        other = StoreReader(self._store, self._dimensions)
        other[self.ts.frame]
        return other

    def _reopen(self) -> None:
        self.ts.frame = -1

    def _read_next_timestep(self, ts: object = None) -> Any:
        if self.ts.frame + 1 >= self.n_frames:
            raise EOFError
        return self._read_frame(self.ts.frame + 1)

    def _read_frame(self, frame: int) -> Any:
        if not self._first <= frame < self._first + len(self._block):
            count = max(1, AT_ONCE_BYTES // max(1, 12 * self.n_atoms))
            self._first = frame
            self._block = self._store.take(np.arange(frame, min(frame + count, self.n_frames)))
        self.ts.positions = self._block[frame - self._first]
        self.ts.dimensions = None if self._dimensions is None else self._dimensions[frame]
        self.ts.frame = frame
        return self.ts
