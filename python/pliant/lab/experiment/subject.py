# SPDX-License-Identifier: MIT
"""One graph under all its forces and techniques: the unit of work, and the rows it gives."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

import pliant
from pliant.lab.experiment.settings import NO_WEIGHTING, Combination, Settings, reverse_techniques

JointForce = tuple[int, tuple[float, float, float]]  #: joint, force in kJ/(mol Angstrom)

#: Angstrom/ps^2 of 1 kJ/(mol Angstrom) on 1 u
ACCELERATION = 100.0

#: One resolve. `combination` counts the techniques with their weightings that the class has.
ROW = np.dtype(
    [
        ("combination", "<i4"),
        ("force", "<i8"),
        ("sweeps", "<i8"),
        ("passes", "<i8"),
        ("projections", "<i8"),
        ("converged", "?"),
        ("final_residual", "<f8"),
    ]
)


@dataclass
class Subject:
    """A graph of a class and the pushes that it gets."""

    kind: str
    number: int
    framework: pliant.Framework
    positions: np.ndarray  #: (N, 3) Angstrom: at rest, all bars whole
    pushes: list[JointForce] = field(default_factory=list)


def make_subject(settings: Settings, kind: str, number: int) -> Subject:
    """Graph `number` of a class, with the forces that ``pliant run`` would use as walker `number`.

    The joint and the force of step k are functions of (seed, walker, step) alone.
    """
    graph = pliant.generate(kind, settings.seed, number, **settings.sizes)
    forces = pliant.make_force_file(
        graph.framework, settings.forces, force=settings.force, seed=settings.seed, walker=number
    )
    return Subject(kind, number, graph.framework, graph.positions, forces.pushes)


def pushed(
    subject: Subject, push: JointForce, timestep: float, positions: np.ndarray, previous: np.ndarray
) -> np.ndarray:
    """Positions after one Verlet step of one joint: 2 x - x_old + 100 F / m dt^2 (appendix A)."""
    joint, force = push
    moved: np.ndarray = positions.copy()
    gain = ACCELERATION * subject.framework.inverse_masses[joint] * timestep * timestep
    moved[joint] = (
        positions[joint] + (positions[joint] - previous[joint]) + gain * np.asarray(force)
    )
    return moved


def measure_subject(subject: Subject, settings: Settings) -> np.ndarray:
    """All resolves of one graph: ROW for each combination and force, in this order."""
    combinations = settings.combinations(subject.kind)
    rows = np.zeros((len(combinations), len(subject.pushes)), ROW)
    for k, combination in enumerate(combinations):
        rows[k]["combination"] = k
        _resolve_all(subject, combination, settings, rows[k])
    return rows.reshape(-1)


def _resolve_all(
    subject: Subject, combination: Combination, settings: Settings, rows: np.ndarray
) -> None:
    technique, weighting = combination
    resolver = pliant.Resolver(
        subject.framework,
        technique,
        0.5 if weighting == NO_WEIGHTING else weighting,
        tolerance_length=settings.tolerance_length,
        max_sweeps=settings.max_sweeps,
        seed=settings.seed,
        walker=subject.number,
    )
    there_and_back = technique in reverse_techniques()
    positions = previous = subject.positions
    for k, push in enumerate(subject.pushes):
        moved = pushed(subject, push, settings.timestep, positions, previous)
        # Step numbers are those of a run, whose first push is step 1.
        found = resolver.resolve(moved, push[0], step=k + 1)
        passes = (found.sweeps + 1) // 2 if there_and_back else found.sweeps
        work = found.sweeps, passes, found.projections
        rows[k] = (rows[k]["combination"], k, *work, found.converged, found.max_residual)
        if settings.consecutive:
            previous = positions
            positions = moved if found.stop != pliant.Stop.not_finite else positions
