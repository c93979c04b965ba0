# SPDX-License-Identifier: MIT
"""The text of an SDF record, taken apart: all of it but the positions is written as it was read.

Format: Biovia, CTfile formats (2020). The text must have passed Pliant's reader.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant._core import Structure

#: Properties of single atoms in V2000, and their names in V3000.
BY_ATOM = {"M  CHG": "CHG", "M  RAD": "RAD", "M  ISO": "MASS"}
END = "M  END"
V30 = "M  V30 "
COORDINATES = 30  #: columns of the three coordinates in V2000
OURS = "<pliant_"  #: data items that a result of ours has


@dataclass
class MolBlock:
    """One record."""

    title: str
    comment: str
    counts: str
    is_v3000: bool
    labels: list[str] = field(default_factory=list)  #: numbers of atoms in V3000, which may be any
    atoms: list[tuple[str, str]] = field(default_factory=list)  #: text before and after x, y, z
    bonds: list[tuple[int, int]] = field(default_factory=list)  #: numbers of atoms, from 0
    bond_texts: list[tuple[str, str]] = field(default_factory=list)  #: around the two numbers
    more: list[str] = field(default_factory=list)  #: lines after the bonds, before M  END
    items: str = ""  #: data items
    radicals: set[int] = field(default_factory=set)  #: atoms with unpaired electrons

    def components(self) -> list[list[int]]:
        """The atoms of each molecule, by their first atom."""
        near: list[list[int]] = [[] for _ in self.atoms]
        for a, b in self.bonds:
            near[a].append(b)
            near[b].append(a)
        found, seen = [], [False] * len(near)
        for first in range(len(near)):
            if seen[first]:
                continue
            seen[first], part = True, [first]
            for atom in part:  # grows while it is walked over
                fresh = [other for other in near[atom] if not seen[other]]
                for other in fresh:
                    seen[other] = True
                part += dict.fromkeys(fresh)
            found.append(sorted(part))
        return found

    def part(self, atoms: Sequence[int]) -> MolBlock:
        """The record of these atoms alone; properties other than those of atoms are left out."""
        new = {old: k for k, old in enumerate(atoms)}
        kept = [k for k, (a, _) in enumerate(self.bonds) if a in new]
        made = MolBlock(self.title, self.comment, self.counts, self.is_v3000)
        made.atoms = [self.atoms[k] for k in atoms]
        made.bonds = [(new[self.bonds[k][0]], new[self.bonds[k][1]]) for k in kept]
        made.bond_texts = [self.bond_texts[k] for k in kept]
        made.items = self.items
        made.radicals = {new[k] for k in self.radicals if k in new}
        if self.is_v3000:
            made.counts = f"0 0 {self.counts.split()[2]}"
            made.labels = [str(k + 1) for k in range(len(atoms))]
        else:
            made.counts = f"{len(atoms):3d}{len(kept):3d}{self.counts[6:]}"
            made.more = [line for old in self.more if (line := _renumbered(old, new))]
        return made

    def form(self) -> str:
        """The record with a place for each coordinate, for ``%``; without data items."""
        head = [one_line(self.title), "  Pliant            3D", one_line(self.comment)]
        more = self.more
        if self.is_v3000:
            counts = f"{V30}COUNTS {len(self.atoms)} {len(self.bonds)} {self.counts}"
            head += ["  0  0  0     0  0            999 V3000", f"{V30}BEGIN CTAB", counts]
            head.append(f"{V30}BEGIN ATOM")
            more = [f"{V30}END ATOM", *self._bonds_of_v3000(), *more, f"{V30}END CTAB"]
        else:
            pairs = zip(self.bonds, self.bond_texts, strict=True)
            head.append(self.counts)
            more = [*(f"{a + 1:3d}{b + 1:3d}{text}" for (a, b), (_, text) in pairs), *more]
        parts = [_literal(head), *self._atoms(), _literal([*more, END])]
        return "\n".join(parts) + "\n"

    def tags(self) -> list[tuple[str, str]]:
        """Name and value of each data item that has a name."""
        found = []
        for item in re.split("(?:^|\n)>", self.items):
            head, _, value = item.partition("\n")
            if "<" in head and ">" in head.rpartition("<")[2]:
                found.append((head.rpartition("<")[2].partition(">")[0], value.rstrip("\n")))
        return found

    def _atoms(self) -> list[str]:
        if not self.is_v3000:
            return ["%10.4f%10.4f%10.4f" + _literal([after]) for _, after in self.atoms]
        labelled = zip(self.labels, self.atoms, strict=True)
        return [
            _literal([f"{V30}{label} {before} "]) + "%.4f %.4f %.4f" + _literal([after])
            for label, (before, after) in labelled
        ]

    def _bonds_of_v3000(self) -> list[str]:
        pairs = zip(self.bonds, self.bond_texts, strict=True)
        lines = [
            f"{V30}{k} {before} {self.labels[a]} {self.labels[b]}{after}"
            for k, ((a, b), (before, after)) in enumerate(pairs, 1)
        ]
        return [f"{V30}BEGIN BOND", *lines, f"{V30}END BOND"] if lines else []


def one_line(text: str) -> str:
    """As a line of a record: control characters would end it, and "$$$$" would end the record."""
    return re.sub(r"\${3}(?=\$)", "$$$ ", re.sub(r"[\0-\x1f]", " ", text))


def _literal(lines: list[str]) -> str:
    return "\n".join(lines).replace("%", "%%")


def block_of(structure: Structure) -> MolBlock:
    """The record of a structure; unknown orders are written as 1."""
    orders = np.maximum(structure.bond_orders, 1).tolist()
    block = MolBlock(structure.title, "", "", False)
    block.counts = f"{len(structure):3d}{len(orders):3d}  0  0  0  0  0  0  0  0999 V2000"
    block.atoms = [("", f" {symbol:<3} 0" + 11 * "  0") for symbol in structure.symbols.tolist()]
    block.bonds = [(a, b) for a, b in structure.bonds.tolist()]
    block.bond_texts = [("", f"{order:3d}  0") for order in orders]
    charged = np.flatnonzero(structure.charges).tolist() if len(structure.charges) else []
    for first in range(0, len(charged), 8):
        some = charged[first : first + 8]
        pairs = "".join(f" {k + 1:3d} {int(structure.charges[k]):3d}" for k in some)
        block.more.append(f"M  CHG{len(some):3d}{pairs}")
    return block


def filled(form: str, positions: npt.NDArray[np.float64]) -> str:
    """A form with positions (N, 3), Angstrom."""
    return form % tuple(positions.ravel().tolist())


def parse(text: str) -> MolBlock:
    """Takes a record apart."""
    lines = text.split("\n")
    title, _, comment, counts = (line.rstrip() for line in lines[:4])
    is_v3000 = counts[34:39].strip() == "V3000"
    block = MolBlock(title, comment, counts, is_v3000)
    rest = _read_v3000(block, lines[4:]) if is_v3000 else _read_v2000(block, lines[4:])
    first = next((k for k, line in enumerate(rest) if line.startswith(">")), len(rest))
    block.items = _kept_items(rest[first:])
    return block


def _kept_items(lines: list[str]) -> str:
    kept, is_ours = [], False
    for line in lines:
        if line.startswith(">"):
            is_ours = OURS in line
        if not is_ours:
            kept.append(line)
    text = "\n".join(kept).rstrip("\n")
    return f"{text}\n\n" if text else ""


def _read_v2000(block: MolBlock, lines: list[str]) -> list[str]:
    atoms, bonds = int(block.counts[:3]), int(block.counts[3:6])
    for line in lines[:atoms]:
        block.atoms.append(("", line[COORDINATES:].rstrip()))
    for line in lines[atoms : atoms + bonds]:
        block.bonds.append((int(line[:3]) - 1, int(line[3:6]) - 1))
        block.bond_texts.append(("", line[6:].rstrip()))
    rest = lines[atoms + bonds :]
    for k, line in enumerate(rest):
        if line.startswith(END):
            return rest[k + 1 :]
        if line.startswith(">"):
            return rest[k:]
        if line.strip():
            block.more.append(line.rstrip())
        if line.startswith("M  RAD"):
            block.radicals.update(atom for atom, _ in pairs_of(line))
    return []


def _read_v3000(block: MolBlock, lines: list[str]) -> list[str]:
    of_label: dict[str, int] = {}
    section, k = "", 0
    while k < len(lines) and not lines[k].startswith(END):
        first = k
        line = lines[k].strip().removeprefix(V30.strip())
        while line.endswith("-") and k + 1 < len(lines):
            k += 1
            line = line[:-1] + lines[k].strip().removeprefix(V30.strip())
        k += 1
        words = line.split(maxsplit=5)
        if words[:1] == ["BEGIN"] and section in ("", "CTAB"):
            section = words[1]
        if section not in ("", "CTAB", "ATOM", "BOND"):
            block.more += [raw.rstrip() for raw in lines[first:k]]
        if words[:2] == ["END", section]:
            section = "" if section == "CTAB" else "CTAB"
        elif words[:1] == ["COUNTS"]:
            block.counts = " ".join(line.split()[3:])
        elif section == "ATOM" and words[:1] != ["BEGIN"]:
            of_label[words[0]] = len(block.atoms)
            if "RAD=" in words[-1]:
                block.radicals.add(len(block.atoms))
            block.labels.append(words[0])
            block.atoms.append((words[1], f" {words[5]}"))
        elif section == "BOND" and words[:1] != ["BEGIN"]:
            block.bonds.append((of_label[words[2]], of_label[words[3]]))
            block.bond_texts.append((words[1], "".join(f" {word}" for word in words[4:])))
    return lines[k + 1 :]


def pairs_of(line: str) -> list[tuple[int, str]]:
    """Atoms, from 0, and their values in a property of single atoms of V2000."""
    words = line[9:].split()
    return [(int(a) - 1, value) for a, value in zip(words[::2], words[1::2], strict=False)]


def _renumbered(line: str, new: dict[int, int]) -> str:
    """A property of atoms with the numbers of those that are kept; "" where none is."""
    if not line.startswith(tuple(BY_ATOM)):
        return ""
    kept = [(new[a] + 1, value) for a, value in pairs_of(line) if a in new]
    numbers = "".join(f" {a:3d} {value:>3}" for a, value in kept)
    return f"{line[:6]}{len(kept):3d}{numbers}" if kept else ""
