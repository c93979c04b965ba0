# SPDX-License-Identifier: MIT
"""OpenMM's CCMA in this very process, so that its time and ours are taken by the same clock.

CCMA: Eastman and Pande, J. Chem. Theory Comput. 6 (2010) 434. OpenMM may abort the process on
constraints that depend on each other: try them in a child process first
(``_openmm.child.run_jobs``).
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure import bars as _bars

if TYPE_CHECKING:
    import openmm


NM = 0.1  #: nanometres in an Angstrom


def openmm_version() -> str:
    """That which is installed; empty if none is."""
    try:
        import openmm
    except ModuleNotFoundError:
        return ""
    return str(openmm.version.version)


class Ccma:
    """A Context of OpenMM's Reference platform that repairs broken structures.

    Given the angles between bars in the intact structure (N, 3), Angstrom, unless `given_angles` is
    false. Corrections act along the bars of the broken structure, as ``applyConstraints`` has it.
    """

    name = "ccma"

    def __init__(
        self,
        masses: np.ndarray,
        bars: np.ndarray,
        rest_lengths: np.ndarray,
        intact: np.ndarray,
        given_angles: bool = True,
    ) -> None:
        from pliant.checks.openmm import worker

        self._worker = worker
        job = {"masses": masses, "bars": bars, "rest_lengths": rest_lengths * NM}
        angles = None
        if given_angles:
            job["triples"] = _bars.bar_pairs(bars, len(masses))
            angles = _bars.angles_between(intact, job["triples"])
        self._intact = intact * NM
        self._integrator = self._make_integrator()
        system = worker.make_system(job, angles)
        self._context, self.ready_seconds = worker.make_context(
            system, self._integrator, "Reference"
        )

    def _make_integrator(self) -> openmm.Integrator:
        import openmm

        return openmm.VerletIntegrator(0.001)

    def repair(self, broken: np.ndarray, tolerance: float) -> tuple[np.ndarray, float]:
        """The structure (N, 3) Angstrom repaired to a relative tolerance; seconds that it took."""
        self._context.setPositions(broken * NM)
        start = time.thread_time()
        self._context.applyConstraints(tolerance)
        seconds = time.thread_time() - start
        return self._worker.positions_of(self._context) / NM, seconds


class CcmaInDynamics(Ccma):
    """The same as in a step of dynamics: corrections act along the bars of the intact structure.

    Seconds are those of a step less those of the same step without constraints.
    """

    name = "ccma_dynamics"

    def __init__(self, *arguments: Any, **more: Any) -> None:
        super().__init__(*arguments, **more)
        masses = np.asarray(arguments[0])
        free = {"masses": masses, "bars": np.empty((0, 2), int), "rest_lengths": np.empty(0)}
        self._free_integrator = self._make_integrator()
        self._free, _ = self._worker.make_context(
            self._worker.make_system(free), self._free_integrator, "Reference"
        )

    def _make_integrator(self) -> openmm.Integrator:
        import openmm

        integrator = openmm.CustomIntegrator(0.001)
        integrator.addPerDofVariable("push", 0.0)
        integrator.addComputePerDof("x", "x + push")
        integrator.addConstrainPositions()
        return integrator

    def _step(
        self,
        context: openmm.Context,
        integrator: openmm.Integrator,
        push: np.ndarray,
        tolerance: float,
    ) -> float:
        integrator.setConstraintTolerance(tolerance)
        context.setPositions(self._intact)
        integrator.setPerDofVariableByName("push", push)
        start = time.thread_time()
        integrator.step(1)
        return time.thread_time() - start

    def repair(self, broken: np.ndarray, tolerance: float) -> tuple[np.ndarray, float]:
        """As of Ccma; `broken` is what the intact structure was pushed to."""
        push = broken * NM - self._intact
        idle = self._step(self._free, self._free_integrator, push, tolerance)
        seconds = self._step(self._context, self._integrator, push, tolerance)
        return self._worker.positions_of(self._context) / NM, max(seconds - idle, 0.0)
