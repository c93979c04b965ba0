# SPDX-License-Identifier: MIT
"""OpenMM's constraints leave our frames where they are, and notice the smallest break.

Context.applyConstraints(tol) is done with a system as soon as every constraint is within tol of
its distance (relative); CCMA (Eastman and Pande, J. Chem. Theory Comput. 6 (2010) 434) looks before
it moves anything. So a frame whose bars are within tol must come back with each coordinate as it
was, bit for bit: the bound is 0. Only isolated isosceles triangles, which are SETTLE's, are solved
afresh whether whole or not; their bound is measure.settle_bound.
"""

from __future__ import annotations

import numpy as np

from pliant.openmm_check import measure
from pliant.openmm_check.child import Job, Outcome
from pliant.openmm_check.findings import CANNOT, SKIPPED, Finding, verdict
from pliant.openmm_check.sample import NM, Sample, constraint_job

STRETCH = 10.0  #: tolerances by which the one bar of a broken copy is too long


def broken_copies(sample: Sample) -> np.ndarray:
    """(S, N, 3): each frame with one bar too long, a different one in each."""
    recording = sample.recording
    copies = []
    for k, positions in enumerate(sample.positions):
        bar = (k * 7919) % len(recording.bars)
        by = STRETCH * sample.openmm_tolerance(positions)
        copies.append(measure.stretched(positions, recording.bars, recording.rest_lengths, bar, by))
    return np.array(copies)


def frame_jobs(sample: Sample, broken: np.ndarray) -> list[Job]:
    """Jobs for check_frames: the frames, then their broken copies."""
    tolerance = sample.openmm_tolerance(sample.positions)
    return [
        constraint_job(
            sample.recording, "apply_constraints", tolerance, broken=structures[None] * NM
        )
        for structures in (sample.positions, broken)
    ]


def check_frames(
    sample: Sample, broken: np.ndarray, outcomes: list[Outcome]
) -> tuple[Finding, Finding]:
    """The two findings: frames stay, broken copies move."""
    if len(sample.recording.bars) == 0:
        return _without_bars()
    return (
        _check_stay(sample, _moves(sample.positions, outcomes[0]), outcomes[0]),
        _check_moved(sample, _moves(broken, outcomes[1]), outcomes[1]),
    )


def _without_bars() -> tuple[Finding, Finding]:
    return tuple(
        Finding(name, title, SKIPPED, notes=["the framework has no bar"])
        for name, title in (("frames_stay", _STAY), ("broken_copies_move", _MOVE))
    )


_STAY = "OpenMM leaves our frames where they are"
_MOVE = "OpenMM moves a copy with one bar broken"


def _moves(structures: np.ndarray, outcome: Outcome) -> np.ndarray:
    """(S,) furthest move of an atom, Angstrom; of the structures that OpenMM got to."""
    after = outcome.arrays["positions"][0] if outcome.done else []
    return np.array(
        [measure.furthest_move(a, x * NM) / NM for a, x in zip(after, structures, strict=False)]
    )


def _check_stay(sample: Sample, moves: np.ndarray, outcome: Outcome) -> Finding:
    if not outcome.done:
        return Finding("frames_stay", _STAY, CANNOT, measured=outcome.brief())
    recording, whole = sample.recording, sample.converged[: len(moves)]
    tolerance = np.full(len(recording.bars), sample.openmm_tolerance(sample.positions))
    allowed = [
        measure.settle_bound(x, recording.bars, recording.rest_lengths, recording.masses, tolerance)
        for x in sample.positions[: len(moves)]
    ]
    good = moves[whole] <= np.array(allowed)[whole]
    finding = Finding(
        "frames_stay",
        _STAY,
        verdict(bool(good.all())) if whole.any() else SKIPPED,
        measured=f"{np.max(moves[whole], initial=0.0):.2e} A",
        allowed=f"{np.max(allowed):.2e} A",
        figures={
            "frames": int(whole.sum()),
            "moved_too_far": int((~good).sum()),
            "furthest_move": np.max(moves[whole], initial=0.0),
            "allowed_move": np.max(allowed),
            "tolerance": tolerance[0],
            "moves": moves,
        },
    )
    finding.notes += _notes_on_stay(sample, moves, whole, good)
    return finding


def _notes_on_stay(
    sample: Sample, moves: np.ndarray, whole: np.ndarray, good: np.ndarray
) -> list[str]:
    notes = []
    if not good.all():
        bad = sample.frames[: len(moves)][whole][~good]
        notes.append(f"OpenMM moves {len(bad)} frames, the first is step {_step(sample, bad[0])}")
    if not whole.any():
        notes.append("no frame that was looked at says that it converged")
    elif not whole.all():
        moved = int(np.sum(~(moves[~whole] == 0)))
        notes.append(
            f"of {int((~whole).sum())} frames that say they did not converge OpenMM moves {moved}"
        )
    triangles = len(measure.isolated_triangles(sample.recording.bars, sample.recording.joint_count))
    if triangles:
        notes.append(
            f"{triangles} isolated triangles are SETTLE's, which keeps their distances as 32-bit "
            "floats: OpenMM moves them by some 1e-8 of a length, whole or not"
        )
    return notes


def _check_moved(sample: Sample, moves: np.ndarray, outcome: Outcome) -> Finding:
    if not outcome.done:
        return Finding("broken_copies_move", _MOVE, CANNOT, measured=outcome.brief())
    noticed = ~(moves == 0)  # not a number is a move too
    after = outcome.arrays["positions"][0] / NM
    tolerance = sample.openmm_tolerance(sample.positions)
    repaired = int(np.sum(sample.residuals(after) <= tolerance + 2 * measure.FLOAT_ROUNDING))
    finding = Finding(
        "broken_copies_move",
        _MOVE,
        verdict(bool(noticed.all())),
        measured=f"{int(noticed.sum())} of {len(moves)} moved",
        allowed="all",
        figures={
            "copies": len(moves),
            "moved": int(noticed.sum()),
            "repaired": repaired,
            "stretch": STRETCH * tolerance,
            "moves": moves,
        },
    )
    if repaired < len(moves):
        finding.notes.append(
            f"of {len(moves)} copies with one bar too long by {STRETCH * tolerance:.0e} of its "
            f"length OpenMM repairs {repaired}"
        )
    return finding


def _step(sample: Sample, frame: int) -> int:
    return int(sample.recording.steps[frame])
