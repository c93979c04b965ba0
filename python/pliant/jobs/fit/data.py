# SPDX-License-Identifier: MIT
"""Measured distances, as a table has them."""

from __future__ import annotations

import contextlib
import csv
import dataclasses
import itertools
import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from pliant._core import Error, InputError, Structure, select_atoms
from pliant.jobs.fit.atom_sites import ATOM_KINDS, AtomSite
from pliant.jobs.fit.labels import DYES, LABELS, REAGENTS, Labels

KINDS = ("CA", "atom", "NOE", *REAGENTS, *LABELS, *DYES)
Found = TypeVar("Found")
NO_LABEL = np.zeros((2, 3))

ENDS = ("site1", "site2")
COLUMNS = (*ENDS, "distance", "error", "low", "high", "kind")
RESIDUE = re.compile(r"(?:([^\s:]+):)?(-?\d+)$")  #: "A:45", "45"
NANOMETRES = 8.0  #: in a table in nm no distance is above this; in one in Angstrom some are


@dataclass(frozen=True)
class Datum:
    """What is known of the distance of two residues."""

    name: str  #: "A:45 - A:112"
    pair: tuple[int, int]  #: nodes
    low: float  #: Angstrom
    high: float  #: infinite where nothing is known
    #: (2, 3) of labels, as ``places`` takes them
    local: np.ndarray = dataclasses.field(default_factory=lambda: NO_LABEL)
    kind: str = "CA"  #: one of KINDS, in capitals
    #: of the kinds atom and NOE: atoms of the structure, whose distance tells whether it holds
    atoms: tuple[np.ndarray, np.ndarray] | None = None
    slack: float = 0.0  #: by which the distance of nodes and `local` may be outside for all that
    #: nodes and places of which it may be instead, as of an ambiguous NOE
    others: tuple[tuple[tuple[int, int], np.ndarray], ...] = ()

    @property
    def loosely(self) -> tuple[float, float]:
        """The interval of nodes and `local`, Angstrom: one pair of atoms is as near as
        (sum of r^-6)^(-1/6) x (the number of pairs)^(1/6), or nearer."""
        pairs = 1 if self.atoms is None else len(self.atoms[0]) * len(self.atoms[1])
        low = max(0.0, self.low - self.slack) / (1 + len(self.others)) ** (1 / 6)
        return low, self.high * pairs ** (1 / 6) + self.slack


class Sites:
    """The residues of a molecule, each at its alpha carbon (P of nucleotides)."""

    def __init__(self, structure: Structure, atoms: np.ndarray) -> None:
        self.structure = structure
        chains = [str(structure.chains[atom]) for atom in atoms]
        self.beside = Labels(structure, atoms)
        self.labels = [
            f"{chain}:{int(structure.residue_ids[atom])}"
            if chain
            else f"{structure.residue_ids[atom]}"
            for chain, atom in zip(chains, atoms, strict=True)
        ]

    def find(self, text: str) -> int:
        """The node of the one residue that is meant. Raises InputError: why there is none."""
        match = RESIDUE.match(text)
        chain = f"chainID {match[1]} and " if match and match[1] else ""
        selection = f"{chain}resid {match[2]}" if match else text
        try:
            atoms = select_atoms(self.structure, selection)
        except Error as error:
            raise InputError(str(error)) from None
        residues = np.asarray(self.structure.residue_of)[atoms]
        of = self.beside.node_of
        nodes = sorted({of[int(r)] for r in residues if int(r) in of})
        if len(nodes) != 1:
            found = f"{len(nodes)} ({', '.join(self.labels[k] for k in nodes[:3])}, ...)"
            raise InputError(
                "expected one residue of a protein or nucleic acid, such as A:45 or 'resid 45', "
                f"found {found if nodes else 'none in the molecule'}"
            )
        return nodes[0]


@dataclass(frozen=True)
class _Row:
    """A line of a table, or a mapping of Python."""

    where: str  #: "D.csv:3"
    values: Mapping[str, Any]

    def wrong(self, field: str, expected: str) -> InputError:
        found = self.text(field)
        return InputError(f"{self.where}: {field}: expected {expected}, found '{found}'")

    def text(self, field: str) -> str:
        value = self.values.get(field)
        return "" if value is None else str(value).strip()

    def number(self, field: str) -> float:
        try:
            value = float(self.text(field))
        except ValueError:
            value = math.nan
        if not 0 < value < math.inf:
            raise self.wrong(field, "a number of Angstrom above 0")
        return value

    def kind(self) -> str:
        kind = self.text("kind").upper() or "CA"
        if kind not in map(str.upper, KINDS):
            raise self.wrong("kind", f"one of {', '.join(KINDS)}")
        return kind

    def interval(self) -> tuple[float, float]:
        """From distance and error, else from low and high, else from the reagent."""
        kind = self.kind()
        if self.text("distance"):
            middle, error = self.number("distance"), self.number("error")
            return max(0.0, middle - error), middle + error
        if self.text("low") or self.text("high"):
            return self._limits()
        if kind in REAGENTS:
            return 0.0, REAGENTS[kind]
        raise self.wrong("distance", "distance and error, or low and high")

    def _limits(self) -> tuple[float, float]:
        low = self.number("low") if self.text("low") else 0.0
        high = self.number("high") if self.text("high") else math.inf
        if low > high:
            raise self.wrong("low", f"at most high, {high:g}")
        return low, high

    def datum(self, sites: Sites) -> Datum:
        """Raises InputError, which names the field."""
        if self.kind() in ATOM_KINDS:
            return self._of_atoms(sites)
        ends = [self._site(field, sites.find) for field in ENDS]
        name, interval = self._name(sites, *ends), self.interval()
        return Datum(name, (ends[0], ends[1]), *interval, self._places(sites, ends), self.kind())

    def _of_atoms(self, sites: Sites) -> Datum:
        kind, beside = self.kind(), sites.beside
        one, other = (
            self._site(field, lambda text: AtomSite.of(text, kind, beside)) for field in ENDS
        )
        pairs = list(itertools.product(one.places, other.places))
        names = [self._name(sites, a.node, b.node) for a, b in pairs]
        first, *others = (((a.node, b.node), np.array([a.local, b.local])) for a, b in pairs)
        return Datum(
            " or ".join(names),
            first[0],
            *self.interval(),
            first[1],
            kind,
            (one.atoms, other.atoms),
            max(a.slack + b.slack for a, b in pairs),
            tuple(others),
        )

    def _site(self, field: str, find: Callable[[str], Found]) -> Found:
        try:
            return find(self.text(field))
        except InputError as error:
            raise InputError(f"{self.where}: {field} '{self.text(field)}': {error}") from None

    def _name(self, sites: Sites, one: int, other: int) -> str:
        if one == other:
            raise self.wrong("site2", f"another residue than site1, {sites.labels[one]}")
        return f"{sites.labels[one]} - {sites.labels[other]}"

    def _places(self, sites: Sites, ends: Sequence[int]) -> np.ndarray:
        local = NO_LABEL.copy()
        for k, field in enumerate(ENDS):
            try:
                local[k] = sites.beside.place(self.kind(), ends[k])
            except InputError as error:
                raise self.wrong(field, str(error)) from None
        return np.asarray(local)


def read_distances(given: Any, sites: Sites) -> list[Datum]:
    """The data of a CSV file, or of a sequence of mappings with the same fields.

    Raises InputError, which names the line, the field, what was expected and what was found.
    """
    rows = _of_file(given) if isinstance(given, (str, os.PathLike)) else _of_python(given)
    if not rows:
        raise InputError(f"{_name(given)}: expected at least one distance, found none")
    return [row.datum(sites) for row in rows]


def _name(given: Any) -> str:
    return os.fspath(given) if isinstance(given, (str, os.PathLike)) else "distances"


def _of_python(given: Sequence[Mapping[str, Any]]) -> list[_Row]:
    return [_checked(_Row(f"distances[{k}]", row), row) for k, row in enumerate(given)]


def _of_file(path: str | os.PathLike[str]) -> list[_Row]:
    name = os.fspath(path)
    try:
        with open(path, encoding="utf-8-sig", newline="") as stream:
            lines = csv.DictReader(stream, skipinitialspace=True)
            rows = [(lines.line_num, row) for row in lines]
            fields = [field.strip().lower() for field in lines.fieldnames or ()]
    except (UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{name}: expected a table of text (CSV): {error}") from None
    if not {"site1", "site2"} <= set(fields):
        raise InputError(
            f"{name}:1: expected a header with site1, site2 and distance, error or low, high; "
            f"found '{','.join(fields)}'"
        )
    return [
        _checked(_Row(f"{name}:{line}", dict(zip(fields, row.values(), strict=False))), fields)
        for line, row in rows
    ]


def _checked(row: _Row, fields: Any) -> _Row:
    for field in fields:
        if field not in COLUMNS:
            raise InputError(f"{row.where}: unknown field '{field}'; known: {', '.join(COLUMNS)}")
    return row


def with_dyes_in(data: Sequence[Datum], beside: Labels) -> list[Datum]:
    """Dyes where they are in another structure; as they are where that leaves no room."""
    found = []
    for one in data:
        with contextlib.suppress(InputError):
            if one.kind in DYES:
                local = np.array([beside.place(one.kind, node) for node in one.pair])
                one = dataclasses.replace(one, local=local)
        found.append(one)
    return found


def in_nanometres(data: Sequence[Datum], nodes: np.ndarray) -> bool:
    """Whether distances look as if they were in nm: none is above 8, those here are 10 times as
    long."""
    pairs = np.array([datum.pair for datum in data])
    here = np.linalg.norm(nodes[pairs[:, 0]] - nodes[pairs[:, 1]], axis=1)
    asked = np.array([datum.high if math.isfinite(datum.high) else datum.low for datum in data])
    ratio = float(np.median(here / np.maximum(asked, 1e-3)))
    return bool((asked < NANOMETRES).all() and 5.0 < ratio < 20.0)
