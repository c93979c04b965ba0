# SPDX-License-Identifier: MIT
"""What an experiment is made of: graphs, forces, techniques, and when a bar counts as whole."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass
from typing import Any

import pliant
from pliant import OptionError
from pliant.checks.weightings import WEIGHTINGS

SIZES = ("depth", "children", "ring", "cycles", "joints", "box")
NO_WEIGHTING = -1.0  #: stands in the weighting column of techniques that have none

Combination = tuple[str, float]  #: a technique with its weighting


def _every_class() -> tuple[str, ...]:
    return tuple(row.name for row in pliant.graph_classes())


def _every_technique() -> tuple[str, ...]:
    # auto is one of the others.
    return tuple(row.name for row in pliant.techniques() if row.name != "auto")


@dataclass(frozen=True)
class Settings:
    """All that the table depends on; equal settings give equal tables.

    Thesis, chapter 5: 20 graphs a class, 50 forces a graph, three weightings. It gives no sizes,
    force, tolerance or limit: those are Pliant's own, and ``pliant lab experiment sweep`` varies
    them.
    """

    seed: int = 0
    graphs: int = 20  #: of each class
    forces: int = 50  #: on each graph, each on one joint
    consecutive: bool = False  #: each push where the last one led, not on the graph at rest
    classes: tuple[str, ...] = dataclasses.field(default_factory=_every_class)
    techniques: tuple[str, ...] = dataclasses.field(default_factory=_every_technique)
    weightings: tuple[float, ...] = WEIGHTINGS
    depth: int = 4  #: levels of a tree below its root
    children: int = 3  #: most children of a joint
    ring: int = 8  #: most joints of a closed chain
    cycles: int = 3  #: non-tree bars of an n-cycle
    joints: int = 0  #: joints of a tree; 0: as depth and children have it
    box: float = 10.0  #: edge of the box of positions, Angstrom
    force: float = 50.0  #: kJ/(mol Angstrom)
    timestep: float = 0.01  #: ps
    tolerance_length: float = 0.01  #: Angstrom
    max_sweeps: int = 10000
    test_set_digest: str = ""  #: of its graphs and forces, if a test set is what was run

    def check(self) -> None:
        """Raises OptionError naming the option, its value and its range."""
        for name in ("graphs", "forces"):
            if getattr(self, name) < 1:
                raise OptionError(f"{name} = {getattr(self, name)}: must be from 1")
        _choose("class", self.classes, _every_class())
        for name in self.techniques:  # of a removed name this says what replaces it
            pliant.Resolver(pliant.Framework([[0, 1]], [1.0]), name)
        _choose("technique", self.techniques, _every_technique())
        for weighting in self.weightings:
            if not 0.0 <= weighting <= 1.0:
                raise OptionError(f"weighting = {weighting}: must be from 0 to 1")
        _distinct("weighting", self.weightings)
        for kind in self.classes:  # sizes that cannot be made are refused here, by name
            pliant.generate(kind, seed=self.seed, number=0, **self.sizes)

    @property
    def sizes(self) -> dict[str, Any]:
        """The options of pliant.generate."""
        return {name: getattr(self, name) for name in SIZES}

    @property
    def push_length(self) -> float:
        """How far a force moves its joint of mass 1 u in one step from rest, Angstrom."""
        return 100.0 * self.force * self.timestep**2

    def combinations(self, kind: str) -> list[Combination]:
        """The techniques that apply to a class, each with its weightings, in a fixed order."""
        rows = {row.name: row for row in pliant.techniques()}
        pairs: list[Combination] = []
        for name in self.techniques:
            if rows[name].forests_only and families()[kind] != "tree":
                continue
            weighted = rows[name].has_weighting
            pairs += [(name, w) for w in (self.weightings if weighted else (NO_WEIGHTING,))]
        return pairs

    def text(self) -> str:
        """As JSON, which from_text() reads back."""
        return json.dumps(dataclasses.asdict(self), indent=2) + "\n"

    @classmethod
    def from_text(cls, text: str) -> Settings:
        """Reads what text() wrote; raises ValueError or TypeError if it is something else."""
        values = json.loads(text)
        for name in ("classes", "techniques", "weightings"):
            values[name] = tuple(values[name])
        return cls(**values)

    def differences(self, other: Settings) -> list[str]:
        """One phrase for each option that differs: "force 50.0 there, 60.0 asked"."""
        pairs = [(f.name, getattr(self, f.name), getattr(other, f.name)) for f in _fields()]
        return [
            f"{name} {ours} there, {asked} asked" for name, ours, asked in pairs if ours != asked
        ]


def _fields() -> tuple[dataclasses.Field[Any], ...]:
    return dataclasses.fields(Settings)


def _choose(what: str, names: tuple[str, ...], known: tuple[str, ...]) -> None:
    for name in names:
        if name not in known:
            raise OptionError(f"no {what} '{name}'; there is {', '.join(known)}")
    _distinct(what, names)


def _distinct(what: str, values: tuple[object, ...]) -> None:
    if not values:
        raise OptionError(f"{what}: at least one is needed")
    for value in values:
        if values.count(value) > 1:
            raise OptionError(f"{what} {value} is named twice")


def families() -> dict[str, str]:
    """Class to family: "2-cycle-path" is a "2-cycle"."""
    return {row.name: row.family for row in pliant.graph_classes()}


def label(combination: Combination) -> str:
    """As a reader writes it: "bfs_cycle 0.5", or the bare name of a technique without weighting."""
    name, weighting = combination
    weighted = any(row.name == name and row.has_weighting for row in pliant.techniques())
    return f"{name} {weighting:g}" if weighted else name


def reverse_techniques() -> frozenset[str]:
    """Techniques that sweep there and back: a pass of theirs is two sweeps."""
    return frozenset(row.name for row in pliant.orderings() if row.repeat == pliant.Repeat.reverse)
