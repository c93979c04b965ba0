# SPDX-License-Identifier: MIT
"""Where each claim holds: the experiment again over tolerance, force, size of graph and box."""

from __future__ import annotations

import csv
import dataclasses
import functools
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant import InputError, OptionError
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.claims import CLAIMS, evidence_by_yardstick
from pliant.lab.experiment.laboratory import Show
from pliant.lab.experiment.settings import Settings, families
from pliant.lab.experiment.statistics import Evidence
from pliant.lab.experiment.subject import Subject, make_subject, measure_subject
from pliant.lab.pool import each_done
from pliant.lab.results import write_csv

SWEEP_CSV = "sweep.csv"
TOLERANCES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  #: Angstrom
FORCES = (5.0, 20.0, 50.0, 200.0, 500.0)  #: kJ/(mol Angstrom)
#: depth of trees, most children, longest closed chain: from mostly cycle to mostly tree
SIZES = ((2, 2, 4), (3, 2, 6), (4, 3, 8), (5, 3, 16), (6, 3, 32))
#: what the figures of the thesis look like, pushed as its force files are
SMALL_IN_TURN: dict[str, Any] = {"depth": 2, "children": 2, "ring": 4, "consecutive": True}
BOXES = (5.0, 10.0, 20.0, 40.0)  #: Angstrom
GRAPHS, PUSHES = 20, 25  #: of each family, on each graph
QUICK_GRAPHS, QUICK_PUSHES = 4, 5
THESIS_FAMILIES = ("tree", "1-cycle", "2-cycle")


AXES = ("tolerance_length", "force", "depth", "children", "ring", "box", "consecutive")


@dataclass(frozen=True)
class Point:
    """One cell of the sweep: how a claim fares with one choice of settings."""

    tolerance_length: float
    force: float
    depth: int
    children: int
    ring: int
    box: float
    consecutive: bool  #: forces act one after another, not each on the graph at rest
    joints: float  #: mean number of joints of its graphs
    claim: str
    yardstick: str
    statements: int  #: 0 where no push broke a bar
    holding: int  #: of them, in the sample
    graphs: int = 0  #: of each family, at least; 0: the file does not say
    pushes: int = 0  #: on each graph; 0: the file does not say

    @property
    def size(self) -> tuple[int, int, int]:
        """As SIZES has it."""
        return self.depth, self.children, self.ring

    @property
    def is_full(self) -> bool:
        """Of as many graphs and pushes as a verdict needs; a quick sweep's are not."""
        return self.graphs >= GRAPHS and self.pushes >= PUSHES


def grid(start: Settings) -> list[Settings]:
    """Tolerance with each axis of the sweep; what is not varied is as in `start`."""
    cells = []
    for tolerance in TOLERANCES:
        base = dataclasses.replace(start, tolerance_length=tolerance)
        cells += [dataclasses.replace(base, force=force) for force in FORCES]
        cells += [
            dataclasses.replace(base, depth=depth, children=children, ring=ring)
            for depth, children, ring in SIZES
        ]
        cells += [dataclasses.replace(base, box=box) for box in BOXES]
        cells += [dataclasses.replace(base, consecutive=value) for value in (False, True)]
        small = dataclasses.replace(base, **SMALL_IN_TURN)
        cells += [dataclasses.replace(small, force=force) for force in FORCES]
    return list(dict.fromkeys(cells))


def run_sweep(
    start: Settings,
    out: Path,
    workers: int = 1,
    quick: bool = False,
    show: Show = lambda done, total: None,
) -> list[Point]:
    """Runs every cell and writes ``sweep.csv`` into the folder; the same settings, the same file.

    Each cell has GRAPHS graphs of each family of the thesis and PUSHES forces on each (fewer if
    `quick`) and the thesis' techniques and weightings. Every point says how many it had.
    """
    cells = grid(_thesis(start))
    points: list[Point] = []
    for done, found in enumerate(each_done(functools.partial(_cell, quick), cells, workers), 1):
        points += found
        show(done, len(cells))
    points.sort(key=_place)
    write_csv(points, out / SWEEP_CSV)
    return points


def _thesis(start: Settings) -> Settings:
    classes = [name for name, family in families().items() if family in THESIS_FAMILIES]
    techniques = dict.fromkeys(name for claim in CLAIMS for name in claim.techniques)
    return dataclasses.replace(
        start,
        classes=tuple(classes),
        techniques=tuple(techniques),
        weightings=Settings().weightings,
        joints=0,
    )


def _place(point: Point) -> tuple[float | str, ...]:
    sizes = point.force, point.joints, *point.size, point.box
    return (-point.tolerance_length, *sizes, point.consecutive, point.claim, point.yardstick)


def _numbers(settings: Settings, quick: bool) -> dict[str, int]:
    """As many graphs of each family, however many ways of making them there are."""
    graphs = QUICK_GRAPHS if quick else GRAPHS
    members = [families()[kind] for kind in settings.classes]
    return {kind: max(1, graphs // members.count(families()[kind])) for kind in settings.classes}


def _cell(quick: bool, settings: Settings) -> list[Point]:
    settings = dataclasses.replace(settings, forces=QUICK_PUSHES if quick else PUSHES)
    subjects = [
        subject
        for kind, count in _numbers(settings, quick).items()
        for subject in _subjects(settings, kind, count)
    ]
    joints = sum(len(subject.positions) for subject in subjects) / len(subjects)
    parts = ((s.kind, s.number, measure_subject(s, settings)) for s in subjects)
    return points_of(tables.join(settings, parts), joints)


def _subjects(settings: Settings, kind: str, count: int) -> list[Subject]:
    """The first graphs of a class; trees too small for two more bars are passed over."""
    subjects: list[Subject] = []
    refused = 0
    while len(subjects) < count:
        try:
            subjects.append(make_subject(settings, kind, len(subjects) + refused))
        except OptionError:
            refused += 1
            if refused > 100 * count:
                raise
    return subjects


def points_of(table: tables.Table, joints: float) -> list[Point]:
    """How every claim fares in one table, by each yardstick."""
    settings = table.settings
    all_evidence = evidence_by_yardstick(Evidence(table, replicates=0))
    axes = {name: getattr(settings, name) for name in AXES}
    graphs = _graphs_of_each_family(table)
    points = []
    for claim in CLAIMS:
        for yardstick in claim.yardsticks:
            statements = claim.judged(all_evidence[yardstick]).statements
            holding = sum(bool(statement.holds[0]) for statement in statements)
            point = Point(
                **axes,
                joints=joints,
                claim=claim.id,
                yardstick=yardstick,
                statements=len(statements),
                holding=holding,
                graphs=graphs,
                pushes=settings.forces,
            )
            points.append(point)
    return points


def _graphs_of_each_family(table: tables.Table) -> int:
    """Of the family that has fewest."""
    members = zip(table.columns["class"].tolist(), table.columns["graph"].tolist(), strict=True)
    counts = Counter(families()[kind.decode()] for kind, _ in set(members))
    return min(counts.values())


def read_sweep(out: Path) -> list[Point]:
    """Reads ``sweep.csv``; an empty list if there is none. Raises InputError for another file."""
    path = out / SWEEP_CSV
    if not path.is_file():
        return []
    types: dict[str, Callable[[str], Any]] = dict.fromkeys(
        ("depth", "children", "ring", "statements", "holding", "graphs", "pushes"), int
    )
    types |= {"claim": str, "yardstick": str, "consecutive": "True".__eq__}
    try:
        with open(path, encoding="ascii", newline="") as file:
            return [
                Point(**{name: types.get(name, float)(text) for name, text in row.items()})
                for row in csv.DictReader(file)
            ]
    except (TypeError, ValueError) as error:
        raise InputError(f"{path}: no table of pliant lab experiment sweep: {error}") from error
