# SPDX-License-Identifier: MIT
"""The loop of the thesis on small molecules: every technique, with bars for bonds and for angles.

One random joint is pushed by a random force and moved by Verlet, then the bars are resolved, again
and again. Molecules are made by RDKit when the bench runs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant.base import console
from pliant.checks.openmm.child import Job, Outcome, run_jobs
from pliant.lab.bench.well_known_molecules import MOLECULES

WORKER = Path(__file__).with_name("molecules_worker.py")
BARS = ("bonds", "angles")
STEPS = 50
MAX_SWEEPS = 3000
TOLERANCE = 1e-6
LIMIT = 120.0  #: seconds for one technique on one molecule
AUTO = "auto"
COLUMNS = ("technique", "bars", "able", "doubtful", "converged", "sweeps a step", "residual",
           "worst residual", "time / auto")  # fmt: skip


@dataclass(frozen=True)
class MoleculeRow:
    """One technique on one molecule."""

    technique: str
    bars: str
    molecule: str
    joints: int
    steps: int
    fit: str = ""  #: said before the run: "fits", "doubtful" or "refused"
    unable: str = ""  #: why the technique refuses it
    failure: str = ""  #: how its process ended, such as by the time limit
    unconverged: int = 0  #: steps
    sweeps: float | None = None  #: mean of a step
    residual: float | None = None  #: largest relative one after any step
    seconds: float | None = None  #: of a step

    @property
    def converged(self) -> bool:
        """After every step."""
        return not (self.unable or self.failure or self.unconverged)


@dataclass(frozen=True)
class TechniqueRow:
    """One technique on all molecules."""

    technique: str
    bars: str
    molecules: int
    able: int
    doubtful: int  #: of which it is said before the run that they may not converge
    converged: int  #: molecules, after every step
    sweeps: float  #: a step; median of the molecules that it is able to do
    residual: float  #: median of the largest
    worst_residual: float
    time_to_auto: float  #: median of the ratio of a step's time to that of auto
    unable: str  #: why, of the first molecule


@dataclass
class Loops:
    """The whole table."""

    techniques: list[TechniqueRow] = field(default_factory=list)
    rows: list[MoleculeRow] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        """For --json."""
        return {"pliant": pliant.__version__, **asdict(self)}


def molecule_loops(
    names: Sequence[str] = (),
    techniques: Sequence[str] = (),
    *,
    steps: int = STEPS,
    limit: float = LIMIT,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Loops:
    """All techniques and all molecules, or those named."""
    structures = {name: structure_of(MOLECULES[name]) for name in names or MOLECULES}
    known = [entry.name for entry in pliant.techniques() if entry.name != "input"]
    cases = [
        (technique, bars, name)
        for bars in BARS
        for technique in techniques or known
        for name in structures
    ]
    fits = {(bars, name): _fits(one, bars) for bars in BARS for name, one in structures.items()}
    jobs = [_job(structures[name], bars, technique, steps) for technique, bars, name in cases]
    outcomes, _ = run_jobs(jobs, limit, progress, WORKER)
    found = Loops()
    for (technique, bars, name), outcome in zip(cases, outcomes, strict=True):
        fit = fits[bars, name][technique]
        row = MoleculeRow(technique, bars, name, len(structures[name]), steps, fit)
        found.rows.append(_filled(row, outcome))
    for bars in BARS:
        for technique in techniques or known:
            found.techniques.append(_together(found.rows, technique, bars))
    return found


def structure_of(smiles: str) -> pliant.Structure:
    """A conformer by RDKit."""
    from rdkit import Chem

    from pliant.lab.conformers.known import start_of

    return pliant.from_rdkit(start_of(Chem.AddHs(Chem.MolFromSmiles(smiles))))


def _job(structure: pliant.Structure, bars: str, technique: str, steps: int) -> Job:
    values: dict[str, float | str] = {"technique": technique, "bars": bars, "steps": steps}
    values |= {"tolerance": TOLERANCE, "max_sweeps": MAX_SWEEPS}
    names = ("positions", "elements", "bonds", "bond_orders")
    return Job("loop", values, {name: np.array(getattr(structure, name)) for name in names})


def _fits(structure: pliant.Structure, bars: str) -> dict[str, str]:
    return {name: fit for name, fit, _ in pliant.techniques_for(structure.framework(bars))}


def _filled(row: MoleculeRow, outcome: Outcome) -> MoleculeRow:
    if outcome.event == "raised":
        return replace(row, unable=outcome.message)
    if not outcome.done:
        return replace(row, failure=outcome.brief())
    sweeps, residual, unconverged, seconds = outcome.arrays["numbers"].tolist()
    return replace(
        row, unconverged=int(unconverged), sweeps=sweeps, residual=residual, seconds=seconds
    )


def _together(rows: Sequence[MoleculeRow], technique: str, bars: str) -> TechniqueRow:
    mine = [row for row in rows if (row.technique, row.bars) == (technique, bars)]
    able = [row for row in mine if not row.unable]
    auto = {row.molecule: row.seconds for row in rows if (row.technique, row.bars) == (AUTO, bars)}
    ratios = [row.seconds / own for row in able if row.seconds and (own := auto.get(row.molecule))]

    def median(values: Sequence[float | None]) -> float:
        known = [value for value in values if value is not None]
        return float(np.median(known)) if known else np.nan

    return TechniqueRow(
        technique,
        bars,
        len(mine),
        len(able),
        sum(row.fit == "doubtful" for row in able),
        sum(row.converged for row in able),
        median([row.sweeps for row in able]),
        median([row.residual for row in able]),
        max((row.residual or 0.0 for row in able), default=np.nan),
        median(ratios),
        next((row.unable for row in mine if row.unable), ""),
    )


def print_report(found: Loops) -> None:
    """A line a technique and kind of bars; then why some are unable."""
    count = max((row.molecules for row in found.techniques), default=0)
    print(
        f"{count} molecules; able: those that the technique takes; doubtful: those of which it is\n"
        "said before a run that they may not converge; converged: those whole after every step;\n"
        "sweeps, largest residual and time: medians of those that it is able to do"
    )
    table = console.Table("", COLUMNS, text_columns=(0, 1))
    table.rows = [_cells(row) for row in found.techniques]
    table.print()
    for row in found.techniques:
        if row.unable:
            print(f"{row.technique}, {row.bars}: {row.molecules - row.able} unable: {row.unable}")
    for one in found.rows:
        if one.failure:
            print(f"failed: {one.molecule}, {one.technique}, {one.bars}: {one.failure}")


def _cells(row: TechniqueRow) -> list[str]:
    if not row.able:
        return [row.technique, row.bars, "0", *[""] * 6]
    return [row.technique, row.bars, str(row.able), str(row.doubtful), str(row.converged),
            f"{row.sweeps:.3g}", f"{row.residual:.1g}", f"{row.worst_residual:.1g}",
            "" if np.isnan(row.time_to_auto) else f"{row.time_to_auto:.2g}"]  # fmt: skip
