# SPDX-License-Identifier: MIT
"""Large frameworks with bars across angles are shown to OpenMM's constraints by their bonds alone.

To make a Context ready CCMA inverts a matrix of all constraints that share atoms. Of some 10 000
bars across angles that takes it more than five minutes, of as many bonds less than a second.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pliant.checks.sample import Sample

MOST_BARS = 2000  #: bars across angles among them, that OpenMM gets ready for in seconds


def for_constraints(sample: Sample) -> Sample:
    """The sample itself, or one whose recording has only those bars that are bonds."""
    recording = sample.recording
    if not recording.angle_bars or len(recording.bars) <= MOST_BARS:
        return sample
    count = recording.atom_count
    bonds = recording.structure.bonds.astype(np.int64)
    chosen = np.isin(_keys(recording.bars, count), _keys(bonds, count))
    if not chosen.any():
        return sample
    return replace(sample, recording=recording.with_bars(chosen))


def _keys(pairs: np.ndarray, count: int) -> np.ndarray:
    keys: np.ndarray = pairs.min(axis=1) * count + pairs.max(axis=1)
    return keys


def note_on(whole: Sample, shown: Sample) -> list[str]:
    """Says what was left out, if anything was."""
    if shown is whole:
        return []
    return [
        f"OpenMM's constraints were asked of the {len(shown.recording.bars)} bars that are bonds: "
        f"CCMA would take minutes to set up all {len(whole.recording.bars)}"
    ]
