# SPDX-License-Identifier: MIT
"""Platforms of OpenMM, in the worker's process: those that work here, and Contexts on them."""

from __future__ import annotations

import openmm

#: of platforms that have them
PROPERTIES = {"DeterministicForces": "true", "Precision": "mixed"}


def make_context(system: openmm.System, integrator: openmm.Integrator, name: str) -> openmm.Context:
    """A Context of its own for each job: none sees what another left."""
    platform = openmm.Platform.getPlatform(name)
    properties = {
        key: value for key, value in PROPERTIES.items() if key in platform.getPropertyNames()
    }
    if name == "CPU":
        properties["Threads"] = "1"
    return openmm.Context(system, integrator, platform, properties)


def platforms() -> list[str]:
    """Those that work here, the fastest first: one may be known whose device is not there."""
    every = [openmm.Platform.getPlatform(k) for k in range(openmm.Platform.getNumPlatforms())]
    every.sort(key=lambda one: one.getSpeed(), reverse=True)
    return [one.getName() for one in every if _works(one.getName())]


def _works(name: str) -> bool:
    system = openmm.System()
    system.addParticle(1.0)
    try:
        make_context(system, openmm.VerletIntegrator(0.001), name)
    except openmm.OpenMMException:
        return False
    return True
