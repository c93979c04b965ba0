# SPDX-License-Identifier: MIT
"""Jobs of the force field, in as many processes as there are cores; results depend on none."""

from __future__ import annotations

import os
import pathlib
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np

from pliant._core import OptionError
from pliant.base.refusals import shown
from pliant.checks.force_field.molecule import Molecule
from pliant.checks.openmm.child import Job, Outcome, run_jobs
from pliant.checks.sample import NM

WORKER = pathlib.Path(__file__).with_name("worker.py")
MOST_PROCESSES = 8
CPU = "CPU"
Progress = Callable[[int, int], None]


def cores() -> int:
    """That this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@dataclass
class Bench:
    """Where jobs on one molecule are done."""

    molecule: Molecule
    time_limit: float  #: seconds of one job
    deadline: float  #: no job begins after this time.time()
    show: Progress = lambda *_: None
    platform: str = CPU  #: of OpenMM
    planned: int = 0  #: jobs in all, for the progress
    done: int = 0
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _stopped: bool = False

    def __post_init__(self) -> None:
        molecule = self.molecule
        self._arrays = {
            "elements": molecule.elements,
            "names": molecule.names.astype(str),
            "residue_of": molecule.residue_of,
            "labels": np.array(molecule.labels, str),
            "bonds": molecule.bonds,
        }
        for one in molecule.ligands:
            number, parameters = molecule.labels.index(one.label), one.parameters
            text = np.frombuffer(parameters.prmtop.encode(), np.uint8)
            where = molecule.where(one)[parameters.order]
            own = np.isin(parameters.order, one.own)
            arrays = {"prmtop": text, "where": where, "own": own}
            self._arrays |= {f"{name}-{number}": array for name, array in arrays.items()}

    def match(self) -> Outcome:
        """Whether every residue has a template."""
        return run_jobs([self.match_job()], self.time_limit, worker=WORKER)[0][0]

    def match_job(self) -> Job:
        """Finds templates, and has all that a System is made of."""
        return Job("match", {}, self._arrays)

    @property
    def _values(self) -> dict[str, float | int | str]:
        return {"deadline": self.deadline, "platform": self.platform}

    def choose(self, asked: str, there: Sequence[str]) -> None:
        """Takes the platform that is asked for, or of "auto" the fastest: the first of `there`.

        Raises OptionError, which names those that are there.
        """
        known = {name.lower(): name for name in there} | {"auto": there[0]}
        if asked.lower() not in known:
            listed = ", ".join(["auto", *there])
            raise OptionError(f"--platform: expected one of {listed}, found {shown(asked)}")
        self.platform = known[asked.lower()]

    @property
    def _is_device(self) -> bool:
        """Whether the platform is of a device that several processes would share."""
        return self.platform not in (CPU, "Reference")

    def minimising(self, positions: np.ndarray, stages: Sequence[int]) -> Job:
        """Minimises a completed structure (M, 3), Angstrom."""
        more = {"structure": positions * NM, "stages": np.array(stages, int)}
        return Job("minimise", self._values, self._arrays | more)

    def moving(self, positions: np.ndarray, settle: int, steps: int, frames: int) -> Job:
        """Dynamics from a completed structure (M, 3), Angstrom."""
        values = self._values | {"settle": settle, "steps": steps, "frames": frames}
        return Job("dynamics", values, self._arrays | {"structure": positions * NM})

    def run(self, jobs: Sequence[Job]) -> list[Outcome]:
        """Outcomes in the sequence of the jobs."""
        most = 1 if self._is_device else MOST_PROCESSES
        processes = max(1, min(cores(), most, len(jobs)))
        outcomes: list[Outcome] = [Outcome("died")] * len(jobs)

        def work(first: int) -> None:
            outcomes[first::processes] = self._run_some(jobs[first::processes])

        with ThreadPoolExecutor(processes) as pool:
            try:
                list(pool.map(work, range(processes)))
            except BaseException:
                self._stopped = True
                raise
        return outcomes

    def _run_some(self, jobs: Sequence[Job]) -> list[Outcome]:
        begun = 0

        def show(now: int, _: int) -> None:
            nonlocal begun
            if self._stopped:
                raise KeyboardInterrupt
            with self._lock:
                self.done += now - begun
                begun = now
                self.show(min(self.done, self.planned), self.planned)

        return run_jobs(jobs, self.time_limit, show, WORKER)[0]


def deadline_in(seconds: float) -> float:
    """The time.time() so many seconds from now."""
    return time.time() + seconds
