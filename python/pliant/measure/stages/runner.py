# SPDX-License-Identifier: MIT
"""Runs analyses of MDAnalysis over the frames that are analysed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.frames import HAS_BACKENDS

if TYPE_CHECKING:
    from MDAnalysis.analysis.base import Results

    from pliant.measure.frames import FrameAnalysis
    from pliant.measure.stages.analysis import Analysis


class Runner:
    """Runs over the frames that are analysed, in as many processes as were asked for."""

    def __init__(self, analysis: Analysis) -> None:
        held = analysis.held is not None
        self._frames = np.arange(len(analysis.frames)) if held else analysis.frames
        self._near = analysis.around_start
        workers = min(analysis.options.workers, len(self._frames))
        several = {"backend": "multiprocessing", "n_workers": workers}
        self._backend = several if workers > 1 and HAS_BACKENDS else {}

    def run(self, measured: FrameAnalysis, stride: int = 1) -> Results:
        """The results of a run over all frames, or every `stride`-th."""
        measured.run(frames=self._frames[::stride], **self._backend)
        return measured.results

    def run_around_start(self, measured: FrameAnalysis) -> Results:
        """Over those frames alone by which flexibility is computed."""
        frames = self._frames if self._near is None else self._frames[self._near]
        measured.run(frames=frames, **self._backend)
        return measured.results

    @property
    def first(self) -> int:
        """Number of the first frame, as the universe counts now."""
        return int(self._frames[0])
