# SPDX-License-Identifier: MIT
"""OpenMM's HarmonicBondForce with our rest lengths has the energy that we compute ourselves."""

from __future__ import annotations

import numpy as np

from pliant.checks.findings import CANNOT, SKIPPED, Finding, verdict
from pliant.checks.openmm.child import Job, Outcome
from pliant.checks.sample import NM, Sample
from pliant.measure import bars as _bars
from pliant.trajectory.h5md import FramesOfH5md

AGREEMENT = 1e-10  #: relative difference accepted of two energies
_TITLE = "HarmonicBondForce has our energy"
_ZERO = "and next to none on whole frames"


def constants_of(recording: FramesOfH5md) -> np.ndarray:
    """(B,) kJ/(mol nm^2): as stiff as bonds are, and unlike each other, so that no two mix."""
    return 250_000.0 * (1 + 0.1 * (np.arange(len(recording.bars)) % 7))


def energy_job(recording: FramesOfH5md, structures: np.ndarray) -> Job:
    """The job for check_energy; structures (S, N, 3) Angstrom."""
    arrays = {
        "masses": recording.masses,
        "bars": recording.bars,
        "rest_lengths": recording.rest_lengths * NM,
        "constants": constants_of(recording),
        "structures": structures * NM,
    }
    return Job("bond_energies", {"platform": "Reference"}, arrays)


def our_energies(recording: FramesOfH5md, structures: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(S,) energies, kJ/mol, and what rounding may change of each."""
    rest, constants = recording.rest_lengths * NM, constants_of(recording)
    pairs = [_bars.harmonic_energy(x * NM, recording.bars, rest, constants) for x in structures]
    return np.array([e for e, _ in pairs]), np.array([r for _, r in pairs])


def energy_allowed(sample: Sample) -> float:
    """The energy of a frame each of whose bars is off by all that its tolerance allows, kJ/mol."""
    recording = sample.recording
    rounding = recording.rounding(sample.positions) / recording.rest_lengths
    accepted = recording.tolerance.of(recording.rest_lengths) + rounding
    stretch = accepted * recording.rest_lengths * NM
    return float(np.sum(0.5 * constants_of(recording) * stretch**2)) * (1 + 1e-9)


def check_energy(
    sample: Sample, broken: np.ndarray, resolved: np.ndarray, outcome: Outcome | None
) -> tuple[Finding, Finding]:
    """Agreement on frames, broken and resolved copies; and next to nothing on whole frames.

    The job's structures are those three after each other. There is no outcome without bars.
    """
    if outcome is None:
        note = ["the framework has no bar"]
        return (
            Finding("energies_agree", _TITLE, SKIPPED, notes=note),
            Finding("energies_vanish", _ZERO, SKIPPED, notes=note),
        )
    if not outcome.done:
        return (
            Finding("energies_agree", _TITLE, CANNOT, measured=outcome.brief()),
            Finding("energies_vanish", _ZERO, CANNOT),
        )
    structures = np.concatenate([sample.positions, broken, resolved])
    theirs = outcome.arrays["energies"]
    agree = _check_agreement(sample, structures, theirs)
    return agree, _check_zero(sample, theirs, len(broken), len(resolved))


def _check_agreement(sample: Sample, structures: np.ndarray, theirs: np.ndarray) -> Finding:
    ours, rounding = our_energies(sample.recording, structures)
    difference = np.abs(theirs - ours)
    good = difference <= AGREEMENT * ours + rounding
    telling = AGREEMENT * ours > 10 * rounding  # elsewhere r - d is mostly rounding
    relative = np.max(difference[telling] / ours[telling], initial=0.0)
    return Finding(
        "energies_agree",
        _TITLE,
        verdict(bool(good.all())),
        measured=f"{relative:.1e}",
        allowed=f"{AGREEMENT:.0e}",
        figures={
            "structures": len(structures),
            "differing": int((~good).sum()),
            "relative_difference": relative,
            "absolute_difference": difference.max(initial=0.0),
            "largest_energy": ours.max(initial=0.0),
        },
    )


def _check_zero(sample: Sample, theirs: np.ndarray, broken: int, resolved: int) -> Finding:
    frames = len(sample.positions)
    whole = theirs[:frames][sample.converged]
    allowed = energy_allowed(sample)
    finding = Finding(
        "energies_vanish",
        _ZERO,
        verdict(bool((whole <= allowed).all())) if len(whole) else SKIPPED,
        measured=f"{whole.max(initial=0.0):.1e} kJ/mol",
        allowed=f"{allowed:.1e} kJ/mol",
        figures={
            "whole_frames": whole.max(initial=0.0),
            "allowed": allowed,
            "broken_copies": _median(theirs[frames : frames + broken]),
            "resolved_copies": _median(theirs[frames + broken :]),
        },
    )
    if broken and resolved:
        figures = finding.figures
        finding.notes.append(
            f"copies broken by 0.1 A have {figures['broken_copies']:.3g} kJ/mol, "
            f"after resolving {figures['resolved_copies']:.1e}"
        )
    return finding


def _median(values: np.ndarray) -> float | None:
    return float(np.median(values)) if len(values) else None
