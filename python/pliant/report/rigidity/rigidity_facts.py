# SPDX-License-Identifier: MIT
"""What was found of a molecule's rigidity, as its page shows it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import contact_kinds
from pliant.base.console import printable_name

if TYPE_CHECKING:
    from pliant._core import Rigidity

#: of clusters, the largest first, as src/pliant/model/rigidity/dilution_picture.cpp has them
COLOURS = tuple(
    "#0072b2 #e69f00 #009e73 #cc79a7 #56b4e9 #d55e00 #f0e442 #5a4fcf #8c564b #7f9f3f "
    "#b05a8f #2f8f9f #c0a060 #6b6b9f".split()
)

#: atoms of a cluster
LEAST = 3

#: kinds of contacts that have an energy
HYDROGEN_BONDS = [kind.name for kind in contact_kinds() if kind.has_hydrogen]


@dataclass
class RigidityFacts:
    """N atoms, R residues, B bonds; clusters are numbered from 0, the largest first."""

    file: str
    counts: dict[str, int]  #: degrees_of_freedom, parts, bars, redundant, ...
    energies: np.ndarray  #: (H,) of hydrogen bonds and salt bridges that count, kcal/mol
    cluster: np.ndarray  #: (N,)
    residue_of: np.ndarray  #: (N,)
    names: list[str]  #: (N,)
    elements: list[str]  #: (N,)
    positions: np.ndarray  #: (N, 3) Angstrom
    bonds: np.ndarray  #: (B, 2)
    chains: list[str]  #: (R,)
    numbers: list[str]  #: (R,) with insertion codes
    residue_names: list[str]  #: (R,)
    flexibility: np.ndarray  #: (R,)
    dilution_svg: str = ""

    @property
    def sizes(self) -> np.ndarray:
        """(C,) atoms of each cluster and small piece."""
        return np.bincount(self.cluster)

    @property
    def clusters(self) -> int:
        """Rigid clusters; what has a higher number is a small piece of one or two atoms."""
        return self.counts["rigid_clusters"]

    @property
    def named(self) -> int:
        """So many clusters, the first ones, have a name and a colour."""
        return self.counts["coloured_clusters"]

    def centres(self) -> np.ndarray:
        """(R,) the atom that stands for each residue: CA, P, or else its first."""
        first = np.unique(self.residue_of, return_index=True)[1]
        for k, name in enumerate(self.names):
            if name in ("CA", "P"):
                first[self.residue_of[k]] = k
        return np.asarray(first)

    def residues_in(self, cluster: int) -> np.ndarray:
        """Residues with three atoms or more in a cluster."""
        owners = self.residue_of[self.cluster == cluster]
        return np.flatnonzero(np.bincount(owners, minlength=len(self.chains)) >= LEAST)

    def segments(self) -> Iterator[tuple[int, int, int]]:
        """Stretches of residues (first, last) of one chain and one named cluster, or -1."""
        of_residue = self.cluster[self.centres()]
        of_residue = np.where(of_residue < self.named, of_residue, -1)
        first = 0
        for k in range(1, len(of_residue) + 1):
            ends = k == len(of_residue) or self.chains[k] != self.chains[first]
            if ends or of_residue[k] != of_residue[first]:
                yield first, k - 1, int(of_residue[first])
                first = k

    def stretch(self, first: int, last: int) -> str:
        """ "A:1-20": the name of a stretch of residues."""
        chain = f"{self.chains[first]}:" if self.chains[first] else ""
        end = f"-{self.numbers[last]}" if last > first else ""
        return f"{chain}{self.numbers[first]}{end}"

    def ranges(self, residues: np.ndarray) -> str:
        """ "A:1-20, A:25": residues as stretches."""
        parts: list[tuple[int, int]] = []
        for k in residues.tolist():
            follows = parts and parts[-1][1] == k - 1 and self.chains[k] == self.chains[k - 1]
            if follows:
                parts[-1] = (parts[-1][0], k)
            else:
                parts.append((k, k))
        return ", ".join(self.stretch(*part) for part in parts)


def facts_of_json(found: Mapping[str, Any]) -> RigidityFacts:
    """From what ``pliant rigidity`` hands to its page."""
    residues = found["residues"]
    bonds = found["bonds"]
    return RigidityFacts(
        file=printable_name(Path(found["file"]).name),
        counts={name: value for name, value in found.items() if isinstance(value, int)},
        energies=np.array([b["energy"] for b in bonds if b["kind"] in HYDROGEN_BONDS]),
        cluster=np.array(found["cluster_of_atom"], dtype=int) - 1,
        residue_of=np.array(found["residue_of_atom"], dtype=int),
        names=found["names"],
        elements=found["elements"],
        positions=np.round(np.array(found["positions"], dtype=float).reshape(-1, 3), 3),
        bonds=np.array(found["atoms_of_bonds"], dtype=int).reshape(-1, 2),
        chains=[row["chain"] for row in residues],
        numbers=[f"{row['number']}{row['insertion']}" for row in residues],
        residue_names=[row["name"] for row in residues],
        flexibility=np.array([row["flexibility"] for row in residues]),
        dilution_svg=found["dilution_svg"],
    )


def facts_of(found: Rigidity, dilution: bool = False) -> RigidityFacts:
    """From what ``pliant.rigidity`` gives; `dilution`: with the dilution plot."""
    structure, contacts = found.structure, found.contacts
    first = np.unique(structure.residue_of, return_index=True)[1]
    counted = np.isin(contacts["kind"], HYDROGEN_BONDS)
    numbers = zip(structure.residue_ids[first], structure.insertion_codes[first], strict=True)
    return RigidityFacts(
        file=printable_name(Path(structure.source).name),
        counts={
            "contacts": int((found.edge_contact >= 0).sum()),
            "bonds_that_may_turn": found.hinges,
            "flexible_bonds": found.flexible_bonds,
            "degrees_of_freedom": found.degrees_of_freedom,
            "parts": found.parts,
            "bars": found.bars,
            "redundant": found.redundant,
            "rigid_clusters": found.rigid_clusters,
            "coloured_clusters": found.coloured_clusters,
            "small_pieces": found.small_pieces,
            "rings_of_six": found.rings_of_six,
        },
        energies=contacts["energy"][counted],
        cluster=found.cluster,
        residue_of=structure.residue_of.astype(int),
        names=structure.names.tolist(),
        elements=structure.symbols.tolist(),
        positions=np.round(structure.positions, 3),
        bonds=structure.bonds.astype(int),
        chains=structure.chains[first].tolist(),
        numbers=[f"{number}{code.strip()}" for number, code in numbers],
        residue_names=structure.residue_names[first].tolist(),
        flexibility=found.residue_flexibility,
        dilution_svg=found.dilution_picture() if dilution else "",
    )
