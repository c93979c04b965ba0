# SPDX-License-Identifier: MIT
"""OpenMM's side of the contest: CCMA at its best, as in dynamics, and as most callers have it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant.checks.contest import BUDGET_SECONDS, REPEATS, Contest, Method, Result, describe
from pliant.checks.openmm.angles import MOST_BARS_WITH_ANGLES, why_no_angles
from pliant.checks.openmm.child import Job, Outcome
from pliant.checks.sample import NM, constraint_job
from pliant.measure import bars as _bars


@dataclass(frozen=True)
class Way:
    """A way of having OpenMM repair broken bars."""

    name: str
    kind: str  #: of job
    given_angles: bool
    description: str


ALL_WAYS = (
    Way(
        "OpenMM, as in dynamics",
        "constrain_step",
        True,
        "CCMA is given the bars' directions before the break, and the angles of this frame",
    ),
    Way(
        "OpenMM, applyConstraints",
        "apply_constraints",
        True,
        "CCMA is given the angles of this frame; directions are those of the broken bars",
    ),
    Way(
        "OpenMM, no angles",
        "apply_constraints",
        False,
        "CCMA is given no angles; directions are those of the broken bars",
    ),
)


def ways_for(contest: Contest) -> tuple[Way, ...]:
    """The ways that are worth trying on this framework; says in contest.note why one is not."""
    contest.note = why_no_angles(contest.sample.recording.bars)
    if not contest.note:
        return ALL_WAYS
    return tuple(way for way in ALL_WAYS if not way.given_angles)


def contest_jobs(contest: Contest, ways: Sequence[Way]) -> list[Job]:
    """Jobs for OpenMM: each way, and the last of them on the CPU platform for one structure.

    Of frameworks so large that each Context takes a minute the last is left out.
    """
    broken = contest.broken * NM
    shared = {"repeats": REPEATS, "budget_seconds": BUDGET_SECONDS}
    angles = _angles_of(contest) if any(way.given_angles for way in ways) else {}
    jobs = []
    for way in ways:
        more = shared | {"broken": broken} | (angles if way.given_angles else {})
        more |= {"intact": contest.intact * NM} if way.kind == "constrain_step" else {}
        jobs.append(constraint_job(contest.sample.recording, way.kind, contest.tolerance, **more))
    if len(contest.sample.recording.bars) > MOST_BARS_WITH_ANGLES:
        return jobs
    values = {**jobs[-1].values, "platform": "CPU"}
    jobs.append(Job(jobs[-1].kind, values, {**jobs[-1].arrays, "broken": broken[:, :1]}))
    return jobs


def _angles_of(contest: Contest) -> dict[str, np.ndarray]:
    triples = _bars.bar_pairs(contest.sample.recording.bars, contest.intact.shape[1])
    angles = [_bars.angles_between(x, triples) for x in contest.intact]
    return {"triples": triples, "angles": np.array(angles)}


def their_methods(
    contest: Contest, ways: Sequence[Way], outcomes: Sequence[Outcome]
) -> list[Method]:
    """What OpenMM did in each way; the outcomes are those of contest_jobs."""
    displacements = range(len(contest.displacements))
    return [
        Method(
            way.name,
            "openmm",
            way.description,
            [_their_result(contest, d, outcome) for d in displacements],
        )
        for way, outcome in zip(ways, outcomes, strict=False)
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


def cpu_note(ways: int, outcomes: Sequence[Outcome]) -> str:
    """Whether the CPU platform, in a job after those of the ways, gives what Reference gives."""
    if len(outcomes) <= ways:
        return ""
    reference, cpu = outcomes[-2:]
    if not (reference.done and cpu.done):
        if reference.brief() == cpu.brief():
            return "the CPU platform does the same as the Reference platform"
        return f"the CPU platform: {cpu.brief()}; the Reference platform: {reference.brief()}"
    a, b = cpu.arrays["positions"], reference.arrays["positions"][:, :1]
    if np.array_equal(a, b, equal_nan=True):
        return "the CPU platform gives the same bits as the Reference platform"
    furthest = _bars.furthest_move(a, b) / NM
    return f"the CPU platform differs from the Reference platform by {furthest:.1e} A"
