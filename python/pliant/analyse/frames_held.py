# SPDX-License-Identifier: MIT
"""Which frames are analysed, and their positions in memory where they fit: one look at the file.

MDAnalysis reads all observables anew with each frame of an H5MD file, a millisecond a time, which
a dozen analyses feel. Whole blocks of positions read with h5py take a hundredth of that.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, OptionError
from pliant.analysis.frame_index import FrameIndex

if TYPE_CHECKING:
    from pliant.analyse.study import Study


#: positions up to this size are held in memory
MEMORY_BYTES = 1 << 30


def choose_frames(study: Study) -> None:
    """Sets the frames, times and steps of a study; holds the positions in memory if they fit.

    Raises OptionError when the options choose no frame, InputError when no frame is usable.
    """
    chosen = _whole_frames(study)
    size = len(chosen) * len(study.universe.atoms) * 12
    held = size <= MEMORY_BYTES and study.options.workers == 1
    if held and study.stored.in_file:
        good = _hold_from_file(study, chosen)
    else:
        good = _index(study, chosen)
        if held:
            _hold_from_reader(study, chosen[good])
    if not good.all():
        count = np.count_nonzero(~good)
        study.notes.append(f"{count} frames hold coordinates that are not finite: left out")


def _whole_frames(study: Study) -> np.ndarray:
    """Numbers of the frames that were asked for, as far as they are whole."""
    options = study.options
    count = whole = len(study.universe.trajectory)
    if study.record is not None and study.record.complete_frames:
        whole = min(whole, study.record.complete_frames)
    if whole < count:
        study.notes.append(f"the last {count - whole} frames are not complete: left out")
    wanted = range(*slice(options.start, options.stop, options.step).indices(count))
    wanted = wanted if wanted.step > 0 else wanted[::-1]
    chosen = np.array(range(wanted.start, min(wanted.stop, whole), wanted.step), dtype=int)
    if len(chosen) == 0:
        raise OptionError(f"--start, --stop, --step: choose none of the {count} frames")
    return chosen


def _hold_from_file(study: Study, chosen: np.ndarray) -> np.ndarray:
    """Reads positions, times and steps with h5py into a universe in memory."""
    positions = np.empty((len(chosen), len(study.universe.atoms), 3), dtype=np.float32)
    for part in np.array_split(np.arange(len(chosen)), max(1, positions.nbytes >> 24)):
        step = 1 if len(chosen) < 2 else int(chosen[1] - chosen[0])
        positions[part] = study.stored.read(slice(chosen[part[0]], chosen[part[-1]] + 1, step))
    good = np.asarray(np.isfinite(positions).all(axis=(1, 2)))
    times, steps = study.stored.times_and_steps()
    _set(study, chosen[good], times[chosen[good]], None if steps is None else steps[chosen[good]])
    study.universe.load_new(positions[good], order="fac")
    study.held = True
    return good


def _index(study: Study, chosen: np.ndarray) -> np.ndarray:
    """Looks at each frame with MDAnalysis."""
    index = FrameIndex(study.universe.atoms).run(frames=chosen)
    good: np.ndarray = index.results.finite
    steps = index.results.step[good]
    _set(study, chosen[good], index.times[good], steps if np.all(steps >= 0) else None)
    return good


def _hold_from_reader(study: Study, frames: np.ndarray) -> None:
    """Lets MDAnalysis read the frames into memory, if they are evenly spaced."""
    spacing = np.unique(np.diff(frames))
    if len(spacing) > 1:
        return
    step = int(spacing[0]) if len(spacing) else 1
    study.universe.transfer_to_memory(int(frames[0]), int(frames[-1]) + 1, step)
    study.held = True


def _set(study: Study, frames: np.ndarray, times: np.ndarray, steps: np.ndarray | None) -> None:
    if len(frames) == 0:
        raise InputError(f"{study.options.path}: no frame has finite coordinates")
    study.frames, study.times, study.steps = frames, times, steps
