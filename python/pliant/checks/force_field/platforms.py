# SPDX-License-Identifier: MIT
"""Platforms of OpenMM, in the worker's process: those that work here, and Contexts on them."""

from __future__ import annotations

import openmm

#: of platforms that have them
PROPERTIES = {"DeterministicForces": "true", "Precision": "mixed"}

OF_DEVICE, ON_PROCESSOR = "OpenCLPlatformName", "Portable Computing Language"


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
    """Those that work here, the fastest first: one may be known whose device is not there.

    OpenCL on a processor (PoCL) comes last: OpenMM does not support it, and crashes (PoCL 3.1).
    """
    every = [openmm.Platform.getPlatform(k) for k in range(openmm.Platform.getNumPlatforms())]
    devices = {one.getName(): _device_of(one) for one in every}
    found = [one for one in every if devices[one.getName()] is not None]
    found.sort(key=lambda one: (devices[one.getName()] == ON_PROCESSOR, -one.getSpeed()))
    return [one.getName() for one in found]


def _device_of(platform: openmm.Platform) -> str | None:
    """What OpenCL calls the implementation, "" on other platforms; None if it does not work."""
    system = openmm.System()
    system.addParticle(1.0)
    try:
        context = make_context(system, openmm.VerletIntegrator(0.001), platform.getName())
    except openmm.OpenMMException:
        return None
    is_named = OF_DEVICE in platform.getPropertyNames()
    return str(platform.getPropertyValue(context, OF_DEVICE)) if is_named else ""
