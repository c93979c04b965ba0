# SPDX-License-Identifier: MIT
"""Which frames are analysed, and their positions at hand: one look at the file.

MDAnalysis reads all observables anew with each frame of an H5MD file, a millisecond a time, which
a dozen analyses feel, and the text of a PDB file takes hundreds. Positions are therefore read once:
into memory where they are few, else into a temporary file.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, OptionError
from pliant.analyse.store_reader import StoreReader
from pliant.analysis.frame_index import FrameIndex
from pliant.analysis.frame_store import AT_ONCE_BYTES, FrameStore

if TYPE_CHECKING:
    from pliant.analyse.study import Study


#: positions up to this size are held in memory ...
MEMORY_BYTES = 1 << 23
#: ... and up to this one in a temporary file; more are read anew by each analysis
HELD_BYTES = 1 << 30


def choose_frames(study: Study) -> None:
    """Sets the frames, times and steps of a study; holds the positions if they fit.

    Raises OptionError when the options choose no frame, InputError when no frame is usable.
    """
    chosen = _whole_frames(study)
    size = len(chosen) * len(study.universe.atoms) * 12
    held = size <= HELD_BYTES and study.options.workers == 1
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
    """Reads positions, times and steps with h5py, and gives them to the universe."""
    atoms = len(study.universe.atoms)
    store = FrameStore(len(chosen), atoms, np.float32, MEMORY_BYTES)
    good = np.zeros(len(chosen), dtype=bool)
    step = 1 if len(chosen) < 2 else int(chosen[1] - chosen[0])
    count = 1 + 12 * atoms * len(chosen) // AT_ONCE_BYTES
    for part in np.array_split(np.arange(len(chosen)), min(count, len(chosen))):
        read = study.stored.read(slice(chosen[part[0]], chosen[part[-1]] + 1, step))
        read = read.astype(np.float32)
        finite = np.asarray(np.isfinite(read).all(axis=(1, 2)))
        store.put(int(np.count_nonzero(good)), read[finite])
        good[part] = finite
    times, steps = study.stored.times_and_steps()
    _set(study, chosen[good], times[chosen[good]], None if steps is None else steps[chosen[good]])
    _hold(study, store, None)
    return good


def _hold(study: Study, store: FrameStore, boxes: np.ndarray | None) -> None:
    """Gives the universe the frames of a store."""
    store.cut(len(study.frames))
    if store.array is None:
        study.universe.trajectory = StoreReader(store, boxes)
    else:
        study.universe.load_new(store.array, order="fac", dimensions=boxes)
    study.held = store


def _index(study: Study, chosen: np.ndarray) -> np.ndarray:
    """Looks at each frame with MDAnalysis."""
    index = FrameIndex(study.universe.atoms).run(frames=chosen)
    good: np.ndarray = index.results.finite
    steps = index.results.step[good]
    _set(study, chosen[good], index.times[good], steps if np.all(steps >= 0) else None)
    return good


def _hold_from_reader(study: Study, frames: np.ndarray) -> None:
    """Reads the frames with MDAnalysis."""
    trajectory = study.universe.trajectory
    store = FrameStore(len(frames), len(study.universe.atoms), np.float32, MEMORY_BYTES)
    boxes = np.zeros((len(frames), 6), dtype=np.float32)
    for k, frame in enumerate(frames):
        step = trajectory[int(frame)]
        store.put(k, step.positions[None])
        if step.dimensions is not None:
            boxes[k] = step.dimensions
    _hold(study, store, boxes if boxes.any() else None)


def _set(study: Study, frames: np.ndarray, times: np.ndarray, steps: np.ndarray | None) -> None:
    if len(frames) == 0:
        raise InputError(f"{study.options.path}: no frame has finite coordinates")
    study.frames, study.times, study.steps = frames, times, steps
