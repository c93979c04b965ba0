# SPDX-License-Identifier: MIT
"""Which frames are analysed, and their positions at hand: one look at the file.

MDAnalysis reads all observables anew with each frame of an H5MD file, a millisecond a time, which
a dozen analyses feel, and the text of a PDB file takes hundreds. Positions are therefore read once:
into memory where they are few, else into a temporary file.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, OptionError
from pliant.measure.frame_index import FrameIndex
from pliant.trajectory.frame_store import AT_ONCE_BYTES, FrameStore
from pliant.trajectory.store_reader import StoreReader

if TYPE_CHECKING:
    from MDAnalysis import Universe

    from pliant.measure.stages.analysis import AnalysisOptions
    from pliant.trajectory.record import RunRecord
    from pliant.trajectory.stored import StoredPositions


#: positions up to this size are held in memory ...
MEMORY_BYTES = 1 << 23
#: ... and up to this one in a temporary file; more are read anew by each analysis
HELD_BYTES = 1 << 30


@dataclass(frozen=True)
class ChosenFrames:
    """F frames that are analysed."""

    frames: np.ndarray  #: (F,) numbers in the file
    times: np.ndarray  #: (F,) ps
    steps: np.ndarray | None  #: (F,) steps of the run, if the file has them
    held: FrameStore | None = None  #: their positions, if the universe has these and no others


def choose_frames(
    options: AnalysisOptions, universe: Universe, record: RunRecord | None, stored: StoredPositions
) -> tuple[ChosenFrames, list[str]]:
    """The frames that are analysed, and notes on those left out; holds the positions if they fit.

    Raises OptionError when the options choose no frame, InputError when no frame is usable.
    """
    wanted, notes = _whole_frames(options, len(universe.trajectory), record)
    is_held = len(wanted) * len(universe.atoms) * 12 <= HELD_BYTES and options.workers == 1
    if is_held and stored.in_file:
        chosen = _from_file(universe, stored, wanted)
    else:
        chosen = _by_reader(universe, wanted, is_held)
    if len(chosen.frames) == 0:
        raise InputError(f"{options.path}: no frame has finite coordinates")
    left_out = len(wanted) - len(chosen.frames)
    if left_out:
        notes.append(f"{left_out} frames hold coordinates that are not finite: left out")
    return chosen, notes


def _whole_frames(
    options: AnalysisOptions, count: int, record: RunRecord | None
) -> tuple[np.ndarray, list[str]]:
    """Numbers of the frames that were asked for, as far as they are whole."""
    whole, notes = count, []
    if record is not None and record.complete_frames:
        whole = min(whole, record.complete_frames)
    if whole < count:
        notes.append(f"the last {count - whole} frames are not complete: left out")
    wanted = range(*slice(options.start, options.stop, options.step).indices(count))
    wanted = wanted if wanted.step > 0 else wanted[::-1]
    chosen = np.array(range(wanted.start, min(wanted.stop, whole), wanted.step), dtype=int)
    if len(chosen) == 0:
        raise OptionError(f"frames: choose none of the {count} frames")
    return chosen, notes


def _from_file(universe: Universe, stored: StoredPositions, wanted: np.ndarray) -> ChosenFrames:
    """Reads positions, times and steps with h5py, and gives them to the universe."""
    atoms = len(universe.atoms)
    store = FrameStore(len(wanted), atoms, np.float32, MEMORY_BYTES)
    good = np.zeros(len(wanted), dtype=bool)
    step = 1 if len(wanted) < 2 else int(wanted[1] - wanted[0])
    count = 1 + 12 * atoms * len(wanted) // AT_ONCE_BYTES
    for part in np.array_split(np.arange(len(wanted)), min(count, len(wanted))):
        read = stored.read(slice(wanted[part[0]], wanted[part[-1]] + 1, step))
        read = read.astype(np.float32)
        finite = np.asarray(np.isfinite(read).all(axis=(1, 2)))
        store.put(int(np.count_nonzero(good)), read[finite])
        good[part] = finite
    frames = wanted[good]
    times, steps = stored.times_and_steps()
    if len(frames):
        _give(universe, store, len(frames), None)
    return ChosenFrames(frames, times[frames], None if steps is None else steps[frames], store)


def _by_reader(universe: Universe, wanted: np.ndarray, is_held: bool) -> ChosenFrames:
    """Looks at each frame with MDAnalysis; reads those that are finite, if they are held."""
    index = FrameIndex(universe.atoms).run(frames=wanted)
    good: np.ndarray = index.results.finite
    frames, steps = wanted[good], index.results.step[good]
    store = _read(universe, frames) if is_held and len(frames) else None
    return ChosenFrames(frames, index.times[good], steps if np.all(steps >= 0) else None, store)


def _read(universe: Universe, frames: np.ndarray) -> FrameStore:
    """Reads the frames with MDAnalysis, and gives them to the universe."""
    store = FrameStore(len(frames), len(universe.atoms), np.float32, MEMORY_BYTES)
    boxes = np.zeros((len(frames), 6), dtype=np.float32)
    for k, frame in enumerate(frames):
        step = universe.trajectory[int(frame)]
        store.put(k, step.positions[None])
        if step.dimensions is not None:
            boxes[k] = step.dimensions
    _give(universe, store, len(frames), boxes if boxes.any() else None)
    return store


def _give(universe: Universe, store: FrameStore, count: int, boxes: np.ndarray | None) -> None:
    """Gives the universe the first frames of a store."""
    store.cut(count)
    if store.array is None:
        universe.trajectory = StoreReader(store, boxes)
    else:
        universe.load_new(store.array, order="fac", dimensions=boxes)
