# SPDX-License-Identifier: MIT
"""An analysis of one trajectory: its atoms and frames, and the parts that stages returned."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from pliant.measure.frames import HAS_BACKENDS
from pliant.measure.stages.names import residue_labels
from pliant.measure.stages.parts import Part
from pliant.trajectory.drawn_by import around_start, is_near
from pliant.trajectory.frame_store import AT_ONCE_BYTES, FrameStore
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.opened import FramesOfUniverse

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe
    from MDAnalysis.analysis.base import Results

    from pliant.measure.frames import FrameAnalysis
    from pliant.trajectory.frames import Frames

AnyPart = TypeVar("AnyPart", bound=Part)


@dataclass(frozen=True)
class AnalysisOptions:
    """What to analyse and how."""

    path: str
    topology: str | None = None
    select: str = "all"  #: atoms that are analysed, in MDAnalysis' selection language
    superpose: str | None = None  #: atoms that are fitted and enter the PCA; None: chosen
    mass_weighted: bool = False  #: PCA
    start: int | None = None
    stop: int | None = None
    step: int | None = None
    workers: int = 1
    reference: str | None = None  #: file of the structure that frames are compared with
    distances: tuple[tuple[str, str], ...] = ()  #: pairs of selections, in MDAnalysis' language


@dataclass(frozen=True)
class Analysis:
    """A trajectory with F frames that are analysed, and the parts that stages have returned."""

    options: AnalysisOptions
    universe: Universe
    source: Frames  #: positions with all their digits, and what the file says of the run
    atoms: AtomGroup  #: atoms that are analysed
    fitted: AtomGroup  #: atoms that are superposed and enter the PCA
    fitted_name: str
    frames: np.ndarray  #: (F,) numbers in the file
    times: np.ndarray  #: (F,) ps
    steps: np.ndarray | None  #: (F,) steps of the run, if the file has them
    #: positions of the F frames, if the universe has these and no others; else None
    held: FrameStore | None
    remarks: tuple[str, ...]  #: what a reader should know of the file and the frames
    parts: Mapping[type[Part], Part] = field(default_factory=dict)  #: by their types
    skipped: Mapping[str, str] = field(default_factory=dict)  #: stage -> why it gave nothing

    def having(self, part: Part) -> Analysis:
        """The same with one part more."""
        return replace(self, parts={**self.parts, type(part): part})

    def __contains__(self, kind: type[Part]) -> bool:
        return kind in self.parts

    def __getitem__(self, kind: type[AnyPart]) -> AnyPart:
        """The part of that type; KeyError where no stage returned one."""
        part = self.parts[kind]
        assert isinstance(part, kind)
        return part

    def get(self, kind: type[AnyPart]) -> AnyPart | None:
        """The part of that type; None where no stage returned one."""
        return self[kind] if kind in self.parts else None

    @cached_property
    def residue_labels(self) -> list[str]:
        """Of all residues of the universe."""
        return residue_labels(self.universe.residues)

    @property
    def notes(self) -> list[str]:
        """What a reader of the results should know."""
        return [*self.remarks, *(note for part in self.parts.values() for note in part.notes)]

    @property
    def cautions(self) -> list[str]:
        """What changes what is analysed: what was left out, or not found."""
        return [*self.remarks, *(note for part in self.parts.values() for note in part.cautions)]

    @property
    def kind(self) -> str:
        """ENSEMBLE, PATH, TRANSITION or TRAJECTORY."""
        return self.source.kind

    @property
    def first(self) -> int:
        """Number of the first frame, as the universe counts now."""
        return 0 if self.held is not None else int(self.frames[0])

    def run(
        self, measured: FrameAnalysis, stride: int = 1, *, around_start: bool = False
    ) -> Results:
        """Runs an analysis of MDAnalysis over all frames, every `stride`-th, or those around the
        start alone, in as many processes as were asked for; returns its results."""
        frames = np.arange(len(self.frames)) if self.held is not None else self.frames
        near, workers = self.around_start, min(self.options.workers, len(frames))
        several = {"backend": "multiprocessing", "n_workers": workers}
        chosen = frames[near] if around_start and near is not None else frames[::stride]
        measured.run(frames=chosen, **(several if workers > 1 and HAS_BACKENDS else {}))
        return measured.results

    def positions(self, k: int) -> np.ndarray:
        """Positions (N, 3) of all atoms in the k-th frame analysed, Angstrom, float64."""
        if self.held is not None and isinstance(self.source, FramesOfUniverse):
            held: np.ndarray = self.held.take(np.array([k]))[0]
            return held.astype(np.float64)  # as exact, and sooner
        return self.source.positions(int(self.frames[k]))

    def some_positions(self, atoms: np.ndarray) -> Iterator[np.ndarray]:
        """Positions (f, m, 3) of some atoms, Angstrom: some frames of those analysed at a time."""
        if self.held is not None:
            yield from self.held.of_atoms(atoms).blocks()
            return
        size = max(1, AT_ONCE_BYTES // (24 * len(atoms)))
        for first in range(0, len(self.frames), size):
            part = range(first, min(first + size, len(self.frames)))
            yield np.array([self.positions(k)[atoms] for k in part])

    def stored_positions(self, atoms: np.ndarray, chosen: np.ndarray | None = None) -> FrameStore:
        """Positions (F, m, 3) of some atoms, Angstrom, float64.

        chosen: (F,) bool, of which of the frames analysed; None: of all.
        """
        kept = np.ones(len(self.frames), dtype=bool) if chosen is None else chosen
        store, first, place = FrameStore(int(kept.sum()), len(atoms)), 0, 0
        for block in self.some_positions(atoms):
            some = kept[first : first + len(block)]
            store.put(place, block if some.all() else block[some])
            first += len(block)
            place += int(some.sum())
        return store

    def observable(self, name: str) -> np.ndarray | None:
        """(F,) an observable of the run at the frames analysed; None if there is none."""
        values = self.source.observables.get(name)
        return None if values is None else values[self.frames]

    @property
    def around_start(self) -> np.ndarray | None:
        """(F,) bool: frames by which flexibility is computed; None: all.

        An ensemble of sampler ``reach`` has others besides, which show where else it could be.
        """
        return around_start(self.observable("sampler"))

    @property
    def reaches(self) -> np.ndarray | None:
        """(F,) bool: frames that were drawn to reach further; None: none was."""
        drawn_by = self.observable("sampler")
        if drawn_by is None:
            return None
        far: np.ndarray = ~is_near(drawn_by)
        return far if far.any() else None

    @property
    def converged(self) -> np.ndarray | None:
        """(F,) bool: what the run says of each frame; None if it says nothing."""
        flags = self.observable("converged")
        return None if flags is None else flags.astype(bool)

    @property
    def axis(self) -> tuple[np.ndarray, str]:
        """(F,) values and label of the axis along which things happen: steps, or time."""
        if self.kind == ENSEMBLE:
            return self.frames, "frame"
        if self.steps is not None:
            return self.steps, "step"
        if np.all(np.diff(self.times) > 0):
            return self.times, "time (ps)"
        return self.frames, "frame"
