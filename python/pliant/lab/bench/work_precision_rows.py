# SPDX-License-Identifier: MIT
"""The diagram of work against precision: a row for each contender at each tolerance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.lab.bench.target import Target
from pliant.lab.peers.ccma import openmm_version
from pliant.lab.peers.gromacs import Program

TOLERANCES = tuple(10.0**-k for k in range(2, 13))
WHOLE, STOPPED, SHORT, LOST = "whole", "stopped", "not converged", "not finite"
FAILED = "failed"  #: GROMACS gave up; the note says why


#: The note of a row whose time comes out as nothing or less.
TOO_SHORT = "too short to tell"


@dataclass
class Row:
    """One contender at one tolerance."""

    method: str
    weighting: float | None
    tolerance: float  #: relative, as asked for
    outcome: str = STOPPED  #: "whole", "not converged", "not finite", "failed"; or not asked for
    ns_per_bar: float = math.nan  #: median over the repeats
    sweeps: int | None = None
    projections: int | None = None
    max_residual: float = math.nan  #: largest |length - rest| / rest, measured anew
    displacement: float = math.nan  #: rms distance moved from the broken structure, Angstrom
    displacement_ratio: float = math.nan  #: the same over that of the nearest whole structure
    mass_displacement_ratio: float = math.nan  #: the same, distances weighted by mass
    distance_to_ccma: float = math.nan  #: furthest that a joint is from where CCMA has it, Angstrom
    walkers: int = 1  #: structures that were repaired together; times are of one
    repeats: int = 0
    ratio_to_openmm: float = math.nan  #: CCMA's time to reach this tolerance, over this time
    ratio_to_openmm_in_dynamics: float = math.nan  #: the same, CCMA given the intact directions
    note: str = ""


@dataclass
class WorkPrecision:
    """The whole diagram."""

    target: Target
    bars: str
    displacement: float  #: Angstrom, standard deviation of each coordinate
    nearest_displacement: float  #: rms, Angstrom; not a number if not known
    nearest_mass_displacement: float  #: the same, distances weighted by mass
    initial_residual: float
    tolerances: Sequence[float] = TOLERANCES
    rows: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    #: OpenMM's answers by method and tolerance
    openmm_answers: dict[tuple[str, float], np.ndarray] = field(default_factory=dict)
    gromacs: list[Program] = field(default_factory=list)  #: the builds that took part

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {
            "input": self.target.name,
            "pliant": pliant.__version__,
            "openmm": openmm_version(),
            "gromacs": [asdict(program) for program in self.gromacs],
            "joints": len(self.target.positions),
            "bars": len(self.target.bars),
            "bars_of": self.bars,
            "displaced_by": self.displacement,
            "initial_residual": self.initial_residual,
            "nearest_displacement": self.nearest_displacement,
            "nearest_mass_displacement": self.nearest_mass_displacement,
            "rows": [asdict(row) for row in self.rows],
            "notes": self.notes,
        }
