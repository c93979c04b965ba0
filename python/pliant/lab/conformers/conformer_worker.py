# SPDX-License-Identifier: MIT
"""What makes conformers, in a process of its own: its CPU time is measured, and it may be killed.

Run as ``_openmm/worker.py`` is. It is given a molecule in its start, never the known conformer.
"""

from __future__ import annotations

import pathlib
import resource
import signal
import sys
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any

import numpy as np
from rdkit import Chem, rdBase

from pliant.checks.openmm import worker
from pliant.lab.conformers.contenders import CONTENDERS, Contender
from pliant.lab.conformers.known import start_of

rdBase.DisableLog("rdApp.*")


def user_seconds() -> float:
    """CPU time of this process and of what it started."""
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(resource.getrusage(kind).ru_utime for kind in kinds)


@cache
def _warm_up(name: str) -> None:
    """Imports and reads libraries of rules, which a program does once, are not counted."""
    butanol = Chem.AddHs(Chem.MolFromSmiles("CCCCO"))
    next(one for one in CONTENDERS if one.name == name).make(start_of(butanol), 2)


def make(contender: Contender, job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Conformers (F, N, 3), the user seconds that they took, and those of their start in them."""
    molecule = Chem.MolFromMolBlock(str(job["block"]), removeHs=False)
    Chem.AssignStereochemistryFrom3D(molecule)
    _warm_up(contender.name)
    before = user_seconds()
    signal.setitimer(signal.ITIMER_VIRTUAL, float(job["limit"]))  # which ends the process
    given = start_of(molecule) if contender.needs_start else molecule
    start_seconds = user_seconds() - before
    frames = contender.make(given, int(job["count"]))
    signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    seconds = user_seconds() - before
    return {
        "frames": frames,
        "seconds": np.array(seconds),
        "start_seconds": np.array(start_seconds if contender.needs_start else 0.0),
    }


KINDS: dict[str, Callable[[Mapping[str, Any]], dict[str, np.ndarray]]] = {
    one.name: partial(make, one) for one in CONTENDERS
}

if __name__ == "__main__":
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), KINDS)
