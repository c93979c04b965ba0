# SPDX-License-Identifier: MIT
"""OpenMM's constraints leave our frames where they are, and notice the smallest break.

Context.applyConstraints(tol) is done with a system as soon as every constraint is within tol of
its distance (relative); CCMA (Eastman and Pande, J. Chem. Theory Comput. 6 (2010) 434) looks before
it moves anything. So a frame whose bars are within tol must come back with each coordinate as it
was, bit for bit: the bound is 0. Only isolated isosceles triangles, which are SETTLE's, are solved
afresh whether whole or not; their bound is _bars.settle_bound.
"""

from __future__ import annotations

import numpy as np

from pliant.checks.findings import CANNOT, SKIPPED, Finding, verdict
from pliant.checks.openmm.child import Job, Outcome
from pliant.checks.sample import NM, Sample, constraint_job
from pliant.measure import bars as _bars

STRETCH = 10.0  #: tolerances by which the one bar of a broken copy is too long


def broken_copies(sample: Sample) -> np.ndarray:
    """(S, N, 3): each frame with one bar too long, a different one in each."""
    recording = sample.recording
    copies = []
    for k, positions in enumerate(sample.positions):
        bar = (k * 7919) % len(recording.bars)
        by = STRETCH * sample.openmm_tolerance(positions)
        copies.append(_bars.stretched(positions, recording.bars, recording.rest_lengths, bar, by))
    return np.array(copies)


def frame_job(sample: Sample, broken: np.ndarray) -> Job:
    """The job for check_frames: a frame, its broken copy, the next frame, and so on."""
    tolerance = sample.openmm_tolerance(sample.positions)
    pairs = np.stack([sample.positions, broken], axis=1)
    structures = pairs.reshape(1, -1, *pairs.shape[2:]) * NM
    return constraint_job(sample.recording, "apply_constraints", tolerance, broken=structures)


def check_frames(
    sample: Sample, broken: np.ndarray, outcome: Outcome | None
) -> tuple[Finding, Finding]:
    """The two findings: frames stay, broken copies move. There is no outcome without bars."""
    if outcome is None:
        return _without_bars()
    if not outcome.done:
        return (
            Finding("frames_stay", _STAY, CANNOT, measured=outcome.brief()),
            Finding("broken_copies_move", _MOVE, CANNOT, measured=outcome.brief()),
        )
    after = outcome.arrays["positions"][0]
    return (
        _check_stay(sample, _moves(after[0::2], sample.positions)),
        _check_moved(sample, after[1::2], _moves(after[1::2], broken)),
    )


def _without_bars() -> tuple[Finding, Finding]:
    why = ["the framework has no bar"]
    return (
        Finding("frames_stay", _STAY, SKIPPED, notes=why),
        Finding("broken_copies_move", _MOVE, SKIPPED, notes=[*why]),
    )


_STAY = "OpenMM leaves our frames where they are"
_MOVE = "OpenMM moves a copy with one bar broken"


def _moves(after: np.ndarray, before: np.ndarray) -> np.ndarray:
    """(S,) furthest move of an atom, Angstrom; `after` in nm, of the structures OpenMM got to.

    Compared in nm, as OpenMM was given them: 0 means that each bit is as it was.
    """
    pairs = zip(after, before, strict=False)
    return np.array([_bars.furthest_move(a, b * NM) / NM for a, b in pairs])


def _check_stay(sample: Sample, moves: np.ndarray) -> Finding:
    recording, whole = sample.recording, sample.converged[: len(moves)]
    tolerance = np.full(len(recording.bars), sample.openmm_tolerance(sample.positions))
    allowed = [
        _bars.settle_bound(x, recording.bars, recording.rest_lengths, recording.masses, tolerance)
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
    triangles = len(_bars.isolated_triangles(sample.recording.bars, sample.recording.atom_count))
    if triangles:
        notes.append(
            f"{triangles} isolated triangles are SETTLE's, which keeps their distances as 32-bit "
            "floats: OpenMM moves them by some 1e-8 of a length, whole or not"
        )
    return notes


def _check_moved(sample: Sample, after: np.ndarray, moves: np.ndarray) -> Finding:
    if len(moves) == 0:
        return Finding("broken_copies_move", _MOVE, SKIPPED, notes=["OpenMM did not get to one"])
    noticed = ~(moves == 0)  # not a number is a move too
    tolerance = sample.openmm_tolerance(sample.positions)
    floor = tolerance + 2 * _bars.FLOAT_ROUNDING
    repaired = int(np.sum(sample.residuals(after / NM) <= floor))
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
