# SPDX-License-Identifier: MIT
"""The table, group by group; a group whose source is missing is a row that says so."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from pliant._core import OptionError
from pliant.lab.pairs.directions import directions_of
from pliant.lab.sources import Files, MissingSourceError
from pliant.lab.structures import read_quietly
from pliant.lab.validity import measure
from pliant.lab.validity.cases import (
    CHANGES,
    CROWDED,
    CRYSTALS,
    FLUCTUATIONS,
    OPEN,
    PATHS,
    POCKETS,
    STATES,
    TUNED_PAIRS,
    Change,
    Fluctuation,
)
from pliant.lab.validity.pockets import Host, Site, pocket_rows
from pliant.lab.validity.references import b_factors_of, models_of, trajectory_of
from pliant.lab.validity.rows import HELD_OUT, NO, TUNED, Row, Validity
from pliant.lab.validity.stereochemistry import Stereochemistry
from pliant.lab.validity.subject import Subject
from pliant.lab.validity.turned import goal_trace, state_rows
from pliant.measure import agreement as alike

FRAMES, SEEDS = 200, 3
DRAWS = 1000
GROUPS = (*FLUCTUATIONS, *CHANGES, "pairs", "crystals", "turns", "pockets", "clashes")
GOAL_OF = 30  #: directions held out, over which the goal of domain motions was set
GOAL_ANM = "0.841 and 0.887"


class Ladder:
    """Measures groups of rows; subjects are made once."""

    def __init__(self, files: Files, frames: int, seeds: int, pairs: Path | None) -> None:
        self._files, self._frames, self._seeds, self._pairs = files, frames, seeds, pairs
        self._subjects: dict[str, Subject] = {}
        self._looks: list[Stereochemistry] = []
        self.found = Validity(frames)

    def groups(self) -> dict[str, Callable[[], list[Row]]]:
        """Names of groups and what measures each, in the order of the table."""
        found: dict[str, Callable[[], list[Row]]] = {}
        for name, case in FLUCTUATIONS.items():
            found[name] = partial(self._fluctuation, case)
        for name, change in CHANGES.items():
            found[name] = partial(self._change, name, change)
        if self._pairs is not None:
            found["pairs"] = self._domain_motions
        found["crystals"] = self._crystals
        found["turns"] = self._turns
        found["pockets"] = self._pockets
        found["clashes"] = self._clashes
        return found

    def measure(self, name: str) -> None:
        """Adds the rows of a group."""
        try:
            self.found.rows += self.groups()[name]()
        except MissingSourceError as error:
            self.found.rows.append(Row(name, "all", note=str(error)))

    def finish(self) -> Validity:
        """Adds what all frames together must show, and gives the table."""
        for subject in self._subjects.values():
            self._looks += subject.looks
        self.found.sampled = sum(look.frames for look in self._looks)
        if self._looks:
            self.found.rows += self._exact()
        return self.found

    def _subject(self, path: Path) -> Subject:
        key = os.fspath(path)
        if key not in self._subjects:
            self._subjects[key] = Subject(path, self._frames)
        return self._subjects[key]

    def _fluctuation(self, case: Fluctuation) -> list[Row]:
        paths = [self._files.find(source) for source in case.reference]
        subject = self._subject(self._files.find(case.start))
        reference = case.read(*paths)
        both = measure.compared(subject, reference)
        rows = measure.fluctuation_rows(subject, both, case)
        self.found.profiles[case.name] = measure.profiles(subject, both)
        if case.residues:
            alone = measure.compared(subject, reference, case.residues)
            rows.insert(1, measure.alone_row(subject, alone, case))
            self.found.profiles[case.name] = measure.profiles_alone(subject, alone)
        if case.start != OPEN:
            rows += self._of_ensemble(subject, case.name, case.data)
        return rows

    def _change(self, name: str, case: Change) -> list[Row]:
        target = models_of(self._files.find(case.target))
        subject = self._subject(self._files.find(case.start))
        rows = [measure.change_row(subject, target, case.name, case.data)]
        if name in PATHS:
            path = trajectory_of(*(self._files.find(source) for source in PATHS[name]))
            rows.append(measure.path_row(subject, path, case.name, case.data))
        return rows + self._of_ensemble(subject, case.name, case.data)

    def _of_ensemble(self, subject: Subject, name: str, data: str) -> list[Row]:
        rows = measure.seed_rows(subject, name, self._seeds, data)
        return rows + measure.frame_rows(subject, name)

    def _domain_motions(self) -> list[Row]:
        """Both directions of each two files of a folder; a subject is let go after its row."""
        rows = []
        for pair in directions_of(self._pairs or Path()):
            subject = Subject(pair.start, self._frames)
            data = TUNED if pair.protein in TUNED_PAIRS else HELD_OUT
            name = f"{pair.protein}, {pair.name}"
            rows.append(measure.change_row(subject, models_of(pair.goal), name, data))
            self._looks += subject.looks
        return rows + means(rows)

    def _crystals(self) -> list[Row]:
        """r of root of B, estimated and measured: mean over files."""
        found, missing = [], []
        for source in CRYSTALS:
            try:
                found.append(measure.crystal_figures(b_factors_of(self._files.find(source))))
            except MissingSourceError as error:
                missing.append(str(error))
        if not found:
            raise MissingSourceError("; ".join(missing))
        table = np.array(found)
        ours, anm, gnm = table.mean(axis=0)
        errors = alike.bootstrap(len(table), lambda i: list(table[i].mean(axis=0)), DRAWS)
        note = "; ".join([f"estimate_b_factors; {len(table)} X-ray files", *missing])
        figure = "r of estimated and measured root of B, mean"
        others = {"anm": anm, "anm_error": errors[1], "gnm": gnm, "must": gnm, "aim": gnm + 0.04}
        return [Row("crystals", figure, ours, errors[0], **others, data=HELD_OUT, note=note)]

    def _clashes(self) -> list[Row]:
        """A row a structure; one whose file is missing says so."""
        rows = []
        for name, source in CROWDED.items():
            try:
                rows.append(measure.clash_row(self._subject(self._files.find(source)), name))
            except MissingSourceError as error:
                rows.append(Row(name, measure.CLASHES, note=str(error)))
        return rows

    def _turns(self) -> list[Row]:
        """Both directions of each two states; a subject is let go after its rows."""
        rows, looks = [], []
        for name, states in STATES.items():
            for start, goal in (states, states[::-1]):
                title = f"{name}, {start.label} to {goal.label}"
                try:
                    path, target = self._files.find(start), goal_trace(self._files, goal)
                except MissingSourceError as error:
                    rows.append(Row(title, "turns", note=str(error)))
                    continue
                subject = Subject(path, 2 * self._frames, chain=start.chain)
                rows += state_rows(subject, target, title)
                looks.append(subject.ensemble(sampler="turns").look)
                self._looks += subject.looks
        frames = sum(look.frames for look in looks)
        return rows + (measure.exact_rows(f"{frames} frames of turns", looks) if looks else [])

    def _pockets(self) -> list[Row]:
        """Of each ligand, in its protein alone; a subject is let go after its rows."""
        rows = []
        for name, case in POCKETS.items():
            end = f"to {case.holo.label}" if case.holo != case.start else "emptied"
            title = f"{name}, {case.start.label} {end}"
            try:
                path, holo = self._files.find(case.start), self._files.find(case.holo)
            except MissingSourceError as error:
                rows.append(Row(title, "pockets", note=str(error)))
                continue
            subject = Subject(path, 2 * self._frames, chain=case.start.chain)
            host = Host(subject, Site(read_quietly(holo), case.ligand, case.holo.chain))
            for sampler in ("reach", "pocket"):
                rows += pocket_rows(host, sampler, self._seeds, title, case.data)
            self._looks += subject.looks
        return rows

    def _exact(self) -> list[Row]:
        rows = measure.exact_rows(f"all {self.found.sampled} frames", self._looks)
        looks = [subject.anm_look() for subject in self._subjects.values() if subject.looks]
        if looks:
            rows[0].anm = max(look.worst_bar for look in looks)
            self._count_anm(rows[1:], looks)
        return rows

    def _count_anm(self, rows: Sequence[Row], looks: Sequence[Stereochemistry]) -> None:
        """In ANM's frames, as many as there would be in as many frames as ours."""
        share = self.found.sampled / sum(look.frames for look in looks)
        for row, name in zip(rows, ("overlaps", "flipped", "turned"), strict=True):
            row.anm = share * sum(getattr(look, name) for look in looks)


def means(rows: Sequence[Row]) -> list[Row]:
    """Mean and median of the rows held out, and the mean of those that were tuned on."""
    found = []
    for data, title in ((HELD_OUT, "held out"), (TUNED, "tuned on")):
        chosen = [row for row in rows if row.data == data]
        name = f"domain motions, {title}"
        for word, middle in (("mean", np.mean), ("median", np.median)):
            if chosen:
                found.append(_middle(name, f"{chosen[0].figure}, {word}", middle, chosen, data))
    return found


def _middle(
    name: str, figure: str, middle: Callable[[np.ndarray], float], rows: Sequence[Row], data: str
) -> Row:
    table = np.array([[row.ours, row.network, row.anm] for row in rows])
    values = [float(middle(table[:, k])) for k in range(3)]
    error = alike.bootstrap(len(table), lambda i: [middle(table[i, k]) for k in (0, 2)], DRAWS)
    note, errors = f"{len(rows)} directions", [float(x) for x in error]
    ours, peers = (values[0], errors[0]), (values[1], values[2], errors[1])
    row = Row(name, figure, *ours, *peers, data=data, note=note)
    if math.isfinite(row.must) and len(rows) < GOAL_OF:
        row.note += f"; the goal, {row.must}, is of {GOAL_OF}, of which ANM has {GOAL_ANM}"
        row.must = row.aim = NO
    return row


def validity(
    names: Sequence[str] = (),
    *,
    data: str | os.PathLike[str] | None = None,
    pairs: str | os.PathLike[str] | None = None,
    frames: int = FRAMES,
    seeds: int = SEEDS,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Validity:
    """Measures the groups of these names, or all. Raises OptionError for a name of none."""
    ladder = Ladder(Files(data), frames, seeds, None if pairs is None else Path(pairs))
    known = ladder.groups()
    for name in names:
        if name not in known:
            raise OptionError(f"--only: no group is named '{name}'; known: {', '.join(known)}")
    chosen = [name for name in known if name in names or not names]
    for k, name in enumerate(chosen):
        progress(k, len(chosen))
        ladder.measure(name)
    return ladder.finish()
