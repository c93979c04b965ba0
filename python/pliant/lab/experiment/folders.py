# SPDX-License-Identifier: MIT
"""Test sets, the folders of the thesis' figure 4.6: graphs and forces from, results to them."""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import itertools
import shutil
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import pliant
from pliant import OptionError
from pliant.lab.experiment.settings import NO_WEIGHTING, SIZES, Settings
from pliant.lab.experiment.subject import Subject
from pliant.lab.experiment.table import Table

RESULTS = ("sweeps", "passes", "projections", "converged", "final_residual")
OF_THE_SET = ("seed", "force", "timestep", "tolerance_length", "max_sweeps", *SIZES)
UNWEIGHTED = 0.5  #: what names the folder of a technique that has no weighting

#: Class, number of the graph, technique, weighting.
Key = tuple[str, int, str, float]


@dataclass
class Filled:
    """What became of the results in the folders."""

    written: int = 0
    same: int = 0  #: were there already, with these very numbers
    different: list[str] = field(default_factory=list)  #: folders that hold other numbers


def make_set(settings: Settings, folder: Path) -> None:
    """Writes a test set of the graphs, forces and techniques of an experiment.

    The folder must not be there; it appears when it is complete.
    """
    beside = folder.with_name(folder.name + ".part")  # of a call that was killed
    shutil.rmtree(beside, ignore_errors=True)
    values = {name: getattr(settings, name) for name in OF_THE_SET}
    values |= {"classes": list(settings.classes), "techniques": list(settings.techniques)}
    values |= {"graphs": settings.graphs, "forces": settings.forces}
    pliant.write_test_set(beside, weightings=list(settings.weightings), **values)
    beside.rename(folder)


def check_set(settings: Settings, folder: Path) -> None:
    """Raises OptionError if a test set was made with other settings than these."""
    theirs = settings_of_set(folder)
    names = (*OF_THE_SET, "classes", "graphs", "forces")
    asked = {name: getattr(settings, name) for name in names}
    differences = theirs.differences(dataclasses.replace(theirs, **asked))
    if differences:
        raise OptionError(f"--test-set {folder}: holds another test set: {'; '.join(differences)}")


def settings_of_set(folder: Path) -> Settings:
    """The experiment that a test set asks for. Raises InputError for a bad set."""
    made = pliant.read_test_set(folder)
    rows = {row.name: row for row in pliant.techniques()}
    named = [
        heuristic
        for kind in made.classes
        for graph in kind.graphs
        for heuristic in graph.heuristics
    ]
    asked = dict.fromkeys(heuristic.technique for heuristic in named)
    weightings = dict.fromkeys(h.weighting for h in named if rows[h.technique].has_weighting)
    return dataclasses.replace(
        Settings(),
        **{name: getattr(made, name) for name in OF_THE_SET},
        forces=made.forces,
        graphs=max(len(kind.graphs) for kind in made.classes),
        classes=tuple(kind.name for kind in made.classes),
        techniques=tuple(asked) or Settings().techniques,
        weightings=tuple(weightings) or Settings().weightings,
        test_set_digest=_digest(made),
    )


def graphs_of_set(folder: Path) -> list[tuple[str, int]]:
    """(class, number) of every graph of a test set, in its order."""
    made = pliant.read_test_set(folder)
    return [(kind.name, graph.number) for kind in made.classes for graph in kind.graphs]


def subject_of_set(folder: Path, settings: Settings, kind: str, number: int) -> Subject:
    """A graph of a test set with its forces."""
    for graph in _opened(folder).class_named(kind).graphs:
        if graph.number == number:
            held = graph.graph
            return Subject(kind, number, held.framework, held.positions, list(graph.pushes))
    raise pliant.InputError(f"{folder}: {kind} has no graph {number} any more")


@functools.lru_cache(maxsize=1)
def _opened(folder: Path) -> pliant.TestSet:
    return pliant.read_test_set(folder)


def _digest(made: pliant.TestSet) -> str:
    """What graphs and forces a set holds, so that another one is not taken for it."""
    digest = hashlib.sha256()
    for kind in made.classes:
        for graph in kind.graphs:
            held = graph.graph
            digest.update(f"{kind.name} {graph.number} {graph.pushes!r}".encode())
            for array in (held.framework.bars, held.framework.rest_lengths, held.positions):
                digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def fill(folder: Path, table: Table) -> Filled:
    """Puts the results of an experiment into the folders of its test set, and into results.xml.

    Results that are there are compared, not replaced.
    """
    made = pliant.read_test_set(folder)
    found = Filled()
    graphs = {(kind.name, graph.number): graph for kind in made.classes for graph in kind.graphs}
    for key, rows in _heuristics(table):
        _fill_one(made, graphs[key[:2]], key, rows, table, found)
    made.save()
    return found


def _heuristics(table: Table) -> Iterator[tuple[Key, slice]]:
    """((class, graph, technique, weighting), its rows): runs of equal keys of the table."""
    columns = table.columns
    keys = [columns[name] for name in ("class", "graph", "technique", "weighting")]
    new = np.ones(len(table), bool)
    new[1:] = np.any([key[1:] != key[:-1] for key in keys], axis=0)
    starts = np.append(np.flatnonzero(new), len(table))
    for begin, end in itertools.pairwise(starts):
        kind, number, technique, weighting = (key[begin] for key in keys)
        weighting = UNWEIGHTED if weighting == NO_WEIGHTING else float(weighting)
        yield (kind.decode(), int(number), technique.decode(), weighting), slice(begin, end)


def _fill_one(
    made: pliant.TestSet,
    graph: pliant.TestGraph,
    key: Key,
    rows: slice,
    table: Table,
    found: Filled,
) -> None:
    columns = {name: table.columns[name][rows] for name in RESULTS}
    technique, weighting = key[2:]
    held = [h for h in graph.heuristics if (h.technique, h.weighting) == (technique, weighting)]
    if not held or held[0].results is None:
        made.write_results(*key, *columns.values())
        found.written += 1
        return
    there = made.read_results(*key)
    if all(np.array_equal(there[name], columns[name]) for name in RESULTS):
        found.same += 1
    else:
        found.different.append(held[0].directory)
