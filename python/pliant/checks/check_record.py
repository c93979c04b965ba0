# SPDX-License-Identifier: MIT
"""First of all: every bar of every frame is measured anew and held against what the file says."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pliant.checks.findings import Finding, verdict
from pliant.measure import bars as _bars
from pliant.trajectory.h5md import FramesOfH5md

MOST_NAMED = 3  #: frames that a message names
BLOCK_BYTES = 32 << 20  #: frames are read in pieces of about this size


@dataclass
class Remeasured:
    """All frames, measured from the stored coordinates."""

    residual: np.ndarray  #: (F,) largest |length - rest| / rest
    worst_bar: np.ndarray  #: (F,)
    excess: np.ndarray  #: (F,) largest residual over what is accepted of its bar
    finite: np.ndarray  #: (F,) every coordinate is a finite number
    rounding: np.ndarray  #: (F,) how much storing may have changed a residual
    pinned_move: float = 0.0  #: furthest that a pinned joint is from where it began, Angstrom

    def worst_frame(self, among: np.ndarray) -> int | None:
        """The frame that exceeds its tolerance most, or comes closest; `among` (F,) bool."""
        candidates = np.flatnonzero(among & self.finite)
        if len(candidates) == 0:
            return None
        return int(candidates[np.argmax(self.excess[candidates])])


def remeasure(
    recording: FramesOfH5md, progress: Callable[[int, int], None] = lambda *_: None
) -> Remeasured:
    """Measures every bar of every frame."""
    count = len(recording)
    found = Remeasured(
        np.zeros(count),
        np.zeros(count, int),
        np.zeros(count),
        np.ones(count, bool),
        np.zeros(count),
    )
    start, is_pinned = None, recording.pinned
    size = max(1, BLOCK_BYTES // max(24 * recording.atom_count, 1))
    for first in range(0, count, size):
        block = recording.read(np.arange(first, min(first + size, count)))
        pinned = block[:, is_pinned]
        start = pinned[0] if start is None else start
        found.pinned_move = max(found.pinned_move, _bars.furthest_move(pinned, start))
        for k, positions in enumerate(block, start=first):
            _measure_frame(recording, positions, k, found)
        progress(first + len(block), count)
    return found


def _measure_frame(
    recording: FramesOfH5md, positions: np.ndarray, k: int, found: Remeasured
) -> None:
    found.finite[k] = bool(np.isfinite(positions).all())
    if len(recording.bars) == 0:
        return
    rest = recording.rest_lengths
    residual = _bars.relative_residuals(positions, recording.bars, rest)
    worst = int(np.argmax(residual))  # the first that is not a number, if there is one
    rounding = recording.rounding(positions) / rest
    found.residual[k], found.worst_bar[k] = residual[worst], worst
    found.excess[k] = np.max(residual / (recording.tolerance.of(rest) + rounding))
    found.rounding[k] = rounding.max()


def check_record(recording: FramesOfH5md, found: Remeasured) -> Finding:
    """Frames that the file calls converged are; the residuals that it records are theirs."""
    whole = found.finite & (found.excess <= 1.0)
    broken = np.flatnonzero(recording.converged & ~whole)
    differing = _differing(recording, found)
    said = np.flatnonzero(~recording.converged)
    finding = Finding(
        "record",
        "bars of all frames, measured anew",
        verdict(len(broken) == 0 and len(differing) == 0 and found.pinned_move == 0),
        measured=f"{np.max(found.residual[recording.converged], initial=0.0):.2e}",
        allowed=_allowed(recording),
        figures={
            "frames": len(recording),
            "not_converged": len(said),
            "broken": len(broken),
            "recorded_differently": len(differing),
            "max_residual": found.residual.max(initial=0.0),
            "pinned_joints": int(recording.pinned.sum()),
            "pinned_move": found.pinned_move,
        },
    )
    if len(broken):
        finding.notes.append(_name_broken(recording, found, broken))
    if len(differing):
        finding.notes.append(_name_differing(recording, found, differing))
    if found.pinned_move != 0:
        finding.notes.append(f"a pinned joint moved by {found.pinned_move:.1e} A")
    if len(said):
        finding.notes.append(
            f"{len(said)} of {len(recording)} frames say that they did not converge "
            f"(the first is step {recording.steps[said[0]]}, the worst residual "
            f"{found.residual[said].max():.1e}); they are not judged"
        )
    return finding


def _allowed(recording: FramesOfH5md) -> str:
    tolerance = recording.tolerance
    return f"{tolerance.length:g} A" if tolerance.length > 0 else f"{tolerance.relative:.2e}"


def _differing(recording: FramesOfH5md, found: Remeasured) -> np.ndarray:
    recorded = recording.observables.get("max_residual")
    if recorded is None:
        return np.empty(0, int)
    # Two ways of adding up a length differ in its last places; a stored coordinate may too.
    allowed = 1e-14 + found.rounding
    return np.flatnonzero(~(np.abs(recorded - found.residual) <= allowed))


def _name_broken(recording: FramesOfH5md, found: Remeasured, broken: np.ndarray) -> str:
    named = [
        f"step {recording.steps[k]} (bar {recording.bar_label(found.worst_bar[k])} off by "
        f"{found.residual[k]:.1e} of its length)"
        for k in broken[:MOST_NAMED]
    ]
    more = ", ..." if len(broken) > MOST_NAMED else ""
    return f"{len(broken)} frames are called converged and are not: {', '.join(named)}{more}"


def _name_differing(recording: FramesOfH5md, found: Remeasured, differing: np.ndarray) -> str:
    recorded = recording.observables["max_residual"]
    named = [
        f"step {recording.steps[k]} ({recorded[k]:.3e} recorded, {found.residual[k]:.3e} measured)"
        for k in differing[:MOST_NAMED]
    ]
    more = ", ..." if len(differing) > MOST_NAMED else ""
    return (
        f"{len(differing)} frames do not have the residual that is recorded: "
        f"{', '.join(named)}{more}"
    )
