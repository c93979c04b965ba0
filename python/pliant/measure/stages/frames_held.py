# SPDX-License-Identifier: MIT
"""Which frames are analysed, and their positions at hand: one look at the file.

A dozen analyses go over all frames, and the text of a PDB file takes hundreds of milliseconds for
each. Positions are therefore read once: into memory where they are few, else into a temporary
file.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, OptionError
from pliant.trajectory.frame_store import FramesHeld, FrameStore
from pliant.trajectory.frames_reader import FramesReader

if TYPE_CHECKING:
    from MDAnalysis import Universe

    from pliant.measure.stages.analysis import AnalysisOptions
    from pliant.trajectory.frames import Frames


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
    options: AnalysisOptions, universe: Universe, source: Frames
) -> tuple[ChosenFrames, list[str]]:
    """The frames that are analysed, and notes on those left out; holds the positions if they fit.

    Raises OptionError when the options choose no frame, InputError when no frame is usable.
    """
    wanted, notes = _wanted(options, source)
    is_held = len(wanted) * source.atom_count * 12 <= HELD_BYTES and options.workers == 1
    chosen = _looked_at(universe, source, wanted, is_held)
    if len(chosen.frames) == 0:
        raise InputError(f"{options.path}: no frame has finite coordinates")
    left_out = len(wanted) - len(chosen.frames)
    if left_out:
        notes.append(f"{left_out} frames hold coordinates that are not finite: left out")
    return chosen, notes


def _wanted(options: AnalysisOptions, source: Frames) -> tuple[np.ndarray, list[str]]:
    """Numbers of the frames that were asked for, and a note on those that are not complete."""
    count, notes = len(source), []
    if source.frames_left_out:
        notes.append(f"the last {source.frames_left_out} frames are not complete: left out")
    wanted = np.arange(count)[slice(options.start, options.stop, options.step)]
    if len(wanted) == 0:
        raise OptionError(f"frames: choose none of the {count} frames")
    return np.sort(wanted), notes


def _looked_at(
    universe: Universe, source: Frames, wanted: np.ndarray, is_held: bool
) -> ChosenFrames:
    """Those that are finite; the universe gets them, if they are held."""
    shape = (len(wanted) if is_held else 0, source.atom_count)
    store = FrameStore(*shape, np.float32, MEMORY_BYTES)
    good: list[int] = []
    times, steps, boxes = [], [], []
    for frame in wanted.tolist():
        moment = source.moment(frame)
        if not np.isfinite(moment.positions).all():
            continue
        if is_held:
            store.put(len(good), moment.positions[None])
        good.append(frame)
        times.append(moment.time)
        steps.append(moment.step)
        boxes.append(np.zeros(6) if moment.box is None else moment.box)
    if is_held and good:
        store.cut(len(good))
        held = FramesHeld(store, np.array(boxes, dtype=np.float32) if np.any(boxes) else None)
        universe.trajectory = FramesReader(held)
    known = np.array(steps) if source.has_steps else None
    numbers, at = np.array(good, dtype=int), np.array(times)
    return ChosenFrames(numbers, at, known, store if is_held else None)
