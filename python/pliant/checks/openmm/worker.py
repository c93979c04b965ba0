# SPDX-License-Identifier: MIT
"""What runs OpenMM, in a process of its own, because OpenMM may abort it.

Run as ``python worker.py FOLDER FIRST``: does the jobs of FOLDER/jobs.json from number FIRST on,
and appends one line to FOLDER/journal.jsonl when a job begins and one when it ends, so that the
parent knows which job ended this process. Knows OpenMM, numpy and nothing of Pliant; units are
OpenMM's: nm, u, kJ/mol.
"""

from __future__ import annotations

import json
import pathlib
import sys
import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import openmm

Values = Mapping[str, Any]  #: numbers, words and arrays of a job
Arrays = dict[str, np.ndarray]
Repair = Callable[[openmm.Context, openmm.Integrator, int, int], float]  #: returns seconds
Kinds = Mapping[str, Callable[[Values], Arrays]]


def make_system(job: Values, angles: np.ndarray | None = None) -> openmm.System:
    """A System of the job's masses with its bars as constraints.

    `angles` (A,) are those of the job's triples, as harmonic terms of force constant 0: CCMA looks
    at them to know how bars that share an atom are coupled.
    """
    system = openmm.System()
    for mass in job["masses"].tolist():
        system.addParticle(mass)
    bars = zip(job["bars"].tolist(), job["rest_lengths"].tolist(), strict=True)
    for (a, b), length in bars:
        system.addConstraint(a, b, length)
    if angles is not None:
        force = openmm.HarmonicAngleForce()
        for (i, j, k), angle in zip(job["triples"].tolist(), angles.tolist(), strict=True):
            force.addAngle(i, j, k, angle, 0.0)
        system.addForce(force)
    return system


def make_context(
    system: openmm.System, integrator: openmm.Integrator, platform: str
) -> tuple[openmm.Context, float]:
    """A Context and the seconds that its making took."""
    start = time.perf_counter()
    chosen = openmm.Platform.getPlatformByName(platform)
    context = openmm.Context(system, integrator, chosen)
    return context, time.perf_counter() - start


def positions_of(context: openmm.Context) -> np.ndarray:
    """(N, 3) nm."""
    state = context.getState(getPositions=True)
    return np.asarray(state.getPositions(asNumpy=True)._value, dtype=np.float64)


def repair_all(
    job: Values, make_integrator: Callable[[], openmm.Integrator], repair: Repair
) -> Arrays:
    """Repairs the broken structures (D, S, N, 3), each as often as the job says.

    Returns positions (D, S, N, 3), seconds (D, S), each a median, and ready_seconds (S) of the
    Contexts. One Context serves all structures, unless the job has angles for each of the S: these
    are built into the Context. S is less than was asked for if the time is up, that of making
    Contexts not counted.
    """
    spent, context, results, ready_seconds = 0.0, None, [], []
    for s in range(job["broken"].shape[1]):
        if context is None or "angles" in job:
            angles = job["angles"][s] if "angles" in job else None
            integrator = make_integrator()
            made = make_context(make_system(job, angles), integrator, job["platform"])
            context, ready = made
            ready_seconds.append(ready)
        begun, column = time.perf_counter(), []
        for d in range(len(job["broken"])):
            seconds = [repair(context, integrator, d, s) for _ in range(int(job["repeats"]))]
            column.append((positions_of(context), np.median(seconds)))
        results.append(column)
        spent += time.perf_counter() - begun
        if spent > job["budget_seconds"]:
            break
    return {
        "positions": np.array([[x for x, _ in column] for column in results]).swapaxes(0, 1),
        "seconds": np.array([[t for _, t in column] for column in results]).T,
        "ready_seconds": np.array(ready_seconds),
    }


def apply_constraints(job: Values) -> Arrays:
    """Context.applyConstraints on broken structures: directions are those of the broken bars."""
    tolerance = float(job["tolerance"])

    def repair(context: openmm.Context, _: openmm.Integrator, d: int, s: int) -> float:
        context.setPositions(job["broken"][d, s])
        start = time.perf_counter()
        context.applyConstraints(tolerance)
        return time.perf_counter() - start

    return repair_all(job, lambda: openmm.VerletIntegrator(0.001), repair)


def constrain_step(job: Values) -> Arrays:
    """One step as in dynamics: directions of the bars are those before the step, unbroken."""

    def make_integrator() -> openmm.Integrator:
        integrator = openmm.CustomIntegrator(0.001)
        integrator.addPerDofVariable("push", 0.0)
        integrator.addComputePerDof("x", "x + push")
        integrator.addConstrainPositions()
        integrator.setConstraintTolerance(float(job["tolerance"]))
        return integrator

    def repair(context: openmm.Context, integrator: openmm.Integrator, d: int, s: int) -> float:
        context.setPositions(job["intact"][s])
        integrator.setPerDofVariableByName("push", job["broken"][d, s] - job["intact"][s])
        start = time.perf_counter()
        integrator.step(1)
        return time.perf_counter() - start

    return repair_all(job, make_integrator, repair)


def bond_energies(job: Values) -> Arrays:
    """Energies of structures under a HarmonicBondForce with a bond for each bar."""
    system = openmm.System()
    for mass in job["masses"].tolist():
        system.addParticle(mass)
    force = openmm.HarmonicBondForce()
    columns = (job["bars"].tolist(), job["rest_lengths"].tolist(), job["constants"].tolist())
    for (a, b), length, constant in zip(*columns, strict=True):
        force.addBond(a, b, length, constant)
    system.addForce(force)
    context, _ = make_context(system, openmm.VerletIntegrator(0.001), job["platform"])
    energies = []
    for positions in job["structures"]:
        context.setPositions(positions)
        energies.append(context.getState(getEnergy=True).getPotentialEnergy()._value)
    return {"energies": np.array(energies)}


KINDS = {
    "apply_constraints": apply_constraints,
    "constrain_step": constrain_step,
    "bond_energies": bond_energies,
}


def load_job(folder: pathlib.Path, job: Values) -> dict[str, Any]:
    """The job's arrays; those of files that several jobs share are read from there."""
    arrays = {name: np.load(folder / file) for name, file in job["arrays"].items()}
    return {**job["values"], **arrays}


def do_job(folder: pathlib.Path, number: int, job: Values, kinds: Kinds) -> dict[str, Any]:
    """Does one job, saves its arrays, and returns what the journal says of it."""
    try:
        result = kinds[job["kind"]](load_job(folder, job))
    except Exception as error:
        return {"event": "raised", "message": str(error)}
    files = {}
    for name, values in result.items():
        files[name] = f"result-{number}-{name}.npy"
        np.save(folder / files[name], values)
    return {"event": "done", "files": files}


def main(folder: pathlib.Path, first: int, kinds: Kinds = KINDS) -> None:
    """Does the jobs from number `first` on; `kinds` are functions by the name of a job's kind."""
    jobs = json.loads((folder / "jobs.json").read_text())
    with open(folder / "journal.jsonl", "a", encoding="utf-8") as journal:

        def say(**line: object) -> None:
            print(json.dumps(line), file=journal, flush=True)

        say(event="ready", version=openmm.version.version)
        for number in range(first, len(jobs)):
            say(event="started", job=number)
            say(job=number, **do_job(folder, number, jobs[number], kinds))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
