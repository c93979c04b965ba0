# SPDX-License-Identifier: MIT
"""OpenMM's side of the contest: CCMA at its best, as in dynamics, and as most callers have it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pliant.openmm_check import measure
from pliant.openmm_check.child import Job, Outcome
from pliant.openmm_check.contest import (
    BUDGET_SECONDS,
    REPEATS,
    Contest,
    Method,
    Result,
    describe,
)
from pliant.openmm_check.sample import NM, constraint_job

MOST_ANGLES_PER_BAR = 20  #: with more, as of a star of bars, angles are left out

#: name, kind of job, told the angles between bars?, description
CCMA_WAYS = (
    (
        "OpenMM, as in dynamics",
        "constrain_step",
        True,
        "CCMA told the bars' directions before the break and the angles of the very frame",
    ),
    (
        "OpenMM, applyConstraints",
        "apply_constraints",
        True,
        "CCMA told the angles of the very frame, directions are the broken bars'",
    ),
    (
        "OpenMM, no angles",
        "apply_constraints",
        False,
        "CCMA told no angle, directions are the broken bars'",
    ),
)
APPLIED = 1  #: of these, the one that is tried on the CPU platform as well


def contest_jobs(contest: Contest) -> list[Job]:
    """Jobs for OpenMM: each way, and applyConstraints on the CPU platform for one structure."""
    recording = contest.sample.recording
    broken = contest.broken * NM
    angles = _angles_for(contest)
    settings = {"repeats": REPEATS, "budget_seconds": BUDGET_SECONDS}
    jobs = []
    for _, kind, told_angles, _ in CCMA_WAYS:
        more = {"broken": broken} | (angles if told_angles else {}) | settings
        more |= {"intact": contest.intact * NM} if kind == "constrain_step" else {}
        jobs.append(constraint_job(recording, kind, contest.tolerance, **more))
    more = {"broken": broken[:, :1], "platform": "CPU"} | angles | settings
    jobs.append(constraint_job(recording, "apply_constraints", contest.tolerance, **more))
    return jobs


def _angles_for(contest: Contest) -> dict[str, np.ndarray]:
    bars = contest.sample.recording.bars
    degree = np.bincount(bars.ravel())
    if np.sum(degree * (degree - 1) // 2) > MOST_ANGLES_PER_BAR * len(bars):
        contest.note = "too many bars share a joint for OpenMM to be told all angles between them"
        return {}
    triples = measure.bar_pairs(bars, contest.intact.shape[1])
    angles = [measure.angles_between(x, triples) for x in contest.intact]
    return {"triples": triples, "angles": np.array(angles)}


def their_methods(contest: Contest, outcomes: Sequence[Outcome]) -> list[Method]:
    """What OpenMM did in each of its ways."""
    return [
        Method(
            name,
            "openmm",
            description,
            [_their_result(contest, d, outcome) for d in range(len(contest.displacements))],
        )
        for (name, _, _, description), outcome in zip(CCMA_WAYS, outcomes, strict=False)
    ]


def _their_result(contest: Contest, d: int, outcome: Outcome) -> Result:
    if not outcome.done:
        result = describe(contest, d, contest.broken[d, :0], np.empty(0))
        result.structures = len(contest.intact)
        result.outcome = outcome.brief()
        return result
    after = outcome.arrays["positions"][d] / NM
    result = describe(contest, d, after, outcome.arrays["seconds"][d])
    result.ready_seconds = float(np.median(outcome.arrays["ready_seconds"]))
    return result


def cpu_note(outcomes: Sequence[Outcome]) -> str:
    """Whether the CPU platform gives what the Reference platform gives."""
    reference = outcomes[APPLIED]
    cpu = outcomes[-1]
    if not (reference.done and cpu.done):
        if reference.brief() == cpu.brief():
            return "the CPU platform does the same as the Reference platform"
        return f"the CPU platform: {cpu.brief()}; the Reference platform: {reference.brief()}"
    a, b = cpu.arrays["positions"], reference.arrays["positions"][:, :1]
    if np.array_equal(a, b, equal_nan=True):
        return "the CPU platform gives the same bits as the Reference platform"
    furthest = measure.furthest_move(a, b) / NM
    return f"the CPU platform differs from the Reference platform by {furthest:.1e} A"
