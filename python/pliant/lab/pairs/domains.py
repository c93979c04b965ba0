# SPDX-License-Identifier: MIT
"""Measures domains: reported by several seeds of one structure alone, against those of the pair."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np

import pliant
from pliant._core import Error, MolecularModel
from pliant.lab.pairs.agreement import agreement, contradicted, found
from pliant.lab.pairs.directions import DOMAIN, Direction, Judge, directions_of
from pliant.lab.pairs.pair_domains import pair_domains
from pliant.lab.pool import each_done
from pliant.lab.results import Cell, Results, print_table
from pliant.lab.structures import protein_model, quiet, trace_of
from pliant.measure.domains import Domains, find_domains
from pliant.report.sections.domains import MOST_DOMAIN_SITES
from pliant.trajectory.superposition import superpose_all


@dataclass(frozen=True)
class Row:
    """One structure, its ensembles of some seeds, and the other structure where it is known."""

    protein: str
    structure: str
    residues: int
    numbers: list[int]  #: of domains reported, of each seed; 0: they do not repeat
    contradicted: int  #: pairs of residues, over all pairs of seeds
    pair: int | None = None  #: domains of the known pair
    agreement: float = math.nan  #: with these, mean of the seeds that report two or more
    worst: float = math.nan  #: of these seeds
    found: list[int] = field(default_factory=list)  #: seeds that report each domain of the pair


COLUMNS: dict[str, Cell] = {
    "protein": "protein",
    "structure": "structure",
    "residues": "residues",
    "domains by seed": lambda row: " ".join(map(str, row.numbers)),
    "contradicted": "contradicted",
    "of the pair": "pair",
    "found by seeds": lambda row: " ".join(map(str, row.found)),
    "agreement": "agreement:.2f",
    "worst": "worst:.2f",
}


@dataclass
class Table(Results):
    """All structures."""

    rows: list[Row] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: structures that could not be measured, why

    def print_report(self) -> None:
        """A line a structure, and what they say together."""
        print(
            "domains by seed: how many are reported, 1 for one piece, 0 for none that repeat;\n"
            "contradicted: pairs of residues, in one domain by one seed and in two by another;\n"
            "agreement: share of the pairs of residues that are together, or apart, as in the pair"
        )
        print_table(self.rows, COLUMNS)
        if self.rows:
            print(_together(self.rows))
        for line in self.skipped:
            print(f"not measured: {line}")


def _together(rows: list[Row]) -> str:
    paired = [row for row in rows if row.pair]
    answers = [number > 1 for row in paired for number in row.numbers]
    agreed = [row.agreement for row in paired if math.isfinite(row.agreement)]
    mean = f", mean agreement {np.mean(agreed):.3f}" if agreed else ""
    shown = f"several domains in {sum(answers)} of {len(answers)} ensembles"
    proteins = len({row.protein for row in paired})
    pairs = sum(row.contradicted for row in rows)
    return f"{shown} of {proteins} proteins{mean}; {pairs} pairs contradicted"


def domains(
    folder: str | Path,
    seeds: int = 10,
    frames: int = 400,
    also: Sequence[str] = (),
    *,
    processes: int = 1,
    progress: Callable[[int, int], object] = lambda *_: None,
) -> Table:
    """Both structures of each pair of domain motions in a folder, and some structures alone.

    Raises InputError where the folder holds no pair.
    """
    pairs = [one for one in directions_of(Path(folder)) if one.kind == DOMAIN]
    alone = [Direction(Path(path).stem, Path(path), Path(path)) for path in also]
    every, table = [*pairs, *alone], Table()
    work = partial(_of_one, seeds, frames)
    for done, part in enumerate(each_done(work, every, processes), start=1):
        table.rows += part.rows
        table.skipped += part.skipped
        progress(done, len(every))
    return table


def _of_one(seeds: int, frames: int, direction: Direction) -> Table:
    """One structure, or the reason why it could not be measured."""
    try:
        return Table([_row(direction, seeds, frames)])
    except Error as error:
        return Table(skipped=[f"{direction.protein}, {direction.start.stem}: {error}"])


def _row(direction: Direction, seeds: int, frames: int) -> Row:
    model = protein_model(direction.start)
    trace = trace_of(model.structure).atoms
    reported = [_domains(model, trace, frames, seed) for seed in range(seeds)]
    row = Row(
        direction.protein,
        direction.start.stem,
        len(trace),
        [int(one.max()) + 1 for one in reported],
        contradicted(reported),
    )
    return row if direction.start == direction.goal else _compared(row, direction, model, reported)


def _domains(model: MolecularModel, trace: np.ndarray, frames: int, seed: int) -> np.ndarray:
    """(n,) domain of each residue, as pliant analyse reports it."""
    with quiet():
        made = pliant.sample(model, frames, sampler="reach", near_frames=frames // 2, seed=seed)
    stride = -(-len(trace) // MOST_DOMAIN_SITES)
    positions = np.asarray(made.positions)[:, trace[::stride]]
    near, far = (superpose_all(some) for some in np.split(positions, [frames // 2]))
    chains = np.unique(np.asarray(model.structure.chains)[trace], return_inverse=True)[1]
    found: Domains = find_domains(near, chains[::stride], far=far)
    return np.repeat(found.domain, stride)[: len(trace)]


def _compared(
    row: Row, direction: Direction, model: MolecularModel, reported: list[np.ndarray]
) -> Row:
    """The row with what the known pair says of residues that both structures have."""
    judge = Judge(direction, model.structure)
    start = np.asarray(model.structure.positions)[judge.atoms]
    numbers = np.asarray(model.structure.residue_ids)[judge.atoms[:, 1]]
    known = pair_domains(start[:, :3], judge.goal[:, :3], numbers)
    places = {int(atom): k for k, atom in enumerate(trace_of(model.structure).atoms)}
    shared = [places[int(atom)] for atom in judge.atoms[:, 1]]
    parts = [one[shared] for one in reported]
    agreed = [agreement(one, known) for one in parts if one.max() > 0] or [math.nan]
    return replace(
        row,
        pair=int(known.max()) + 1,
        agreement=float(np.mean(agreed)),
        worst=min(agreed),
        found=np.sum([found(one, known) for one in parts], axis=0).tolist(),
    )
