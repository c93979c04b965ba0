# SPDX-License-Identifier: MIT
"""What must be true of a structure that was read, counted without Pliant: valence, length of bonds,
residues and hydrogens against the lines of the file. Each check yields what is wrong, in words."""

import bz2
import gzip
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

import gemmi
import numpy as np

#: the most atoms that one is bonded to; metals and what is not listed may have any number
MOST_NEIGHBOURS = {"H": 1, "D": 1, "F": 1, "C": 4, "N": 4, "O": 2}
#: times the sum of two covalent radii: no bond is longer
LONGEST_BOND = 1.3

#: hydrogens of a residue inside a chain: of its usual protonation, and of what else it may be
HYDROGENS = {
    "ALA": {5}, "ARG": {12, 13}, "ASN": {6}, "ASP": {4, 5}, "CYS": {4, 5}, "GLN": {8},
    "GLU": {6, 7}, "GLY": {3}, "HIS": {7, 8}, "ILE": {11}, "LEU": {11}, "LYS": {12, 13},
    "MET": {9}, "PHE": {9}, "PRO": {7}, "SER": {5}, "THR": {7}, "TRP": {10}, "TYR": {8, 9},
    "VAL": {9},
}  # fmt: skip
#: atoms other than hydrogen of a residue inside a chain
HEAVY = {
    "ALA": 5, "ARG": 11, "ASN": 8, "ASP": 8, "CYS": 6, "GLN": 9, "GLU": 9, "GLY": 4, "HIS": 10,
    "ILE": 8, "LEU": 8, "LYS": 9, "MET": 8, "PHE": 11, "PRO": 7, "SER": 6, "THR": 7, "TRP": 14,
    "TYR": 12, "VAL": 7,
}  # fmt: skip


def neighbours(structure) -> list[list[int]]:
    """The atoms that each is bonded to, metals left out."""
    metal = [gemmi.Element(str(symbol)).is_metal for symbol in structure.symbols]
    bonded: list[list[int]] = [[] for _ in range(len(structure))]
    for one, two in structure.bonds:
        if not metal[one] and not metal[two]:
            bonded[one].append(int(two))
            bonded[two].append(int(one))
    return bonded


def valence(structure) -> Iterator[str]:
    """Atoms with more neighbours than their element has."""
    symbols, charges = structure.symbols, structure.charges
    for atom, bonded in enumerate(neighbours(structure)):
        most = MOST_NEIGHBOURS.get(str(symbols[atom]).upper(), 12)
        if len(charges):
            most += charges[atom] > 0  # hydronium, and ylides of oxygen
        if len(bonded) > most:
            yield f"{structure.label(atom)} has {len(bonded)} neighbours"


def bond_lengths(structure) -> Iterator[str]:
    """Bonds that are stated or guessed and longer than such atoms have."""
    radius = [gemmi.Element(str(symbol)).covalent_r for symbol in structure.symbols]
    positions = structure.positions
    if not positions[:, 2].any():
        return  # a drawing
    is_known = np.isin(structure.bond_origins, ["residue", "link"])  # of molecules that are bent
    for one, two in structure.bonds[~is_known]:
        length = float(np.linalg.norm(positions[one] - positions[two]))
        if length > LONGEST_BOND * (radius[one] + radius[two]):
            yield f"{structure.label(one)} - {structure.label(two)} is {length:.2f} A long"


def text_of(path: Path) -> str:
    """What a file holds, expanded."""
    opener = {".gz": gzip.open, ".bz2": bz2.open}.get(path.suffix.lower(), open)
    with opener(path, "rt", encoding="latin-1") as file:
        return file.read()


def lines_of_atoms(path: Path) -> Iterator[tuple[str, str, bool]]:
    """Of each atom of the first model of a PDB file: its residue, the name of that, and whether it
    is hydrogen. A name that comes again in a residue is another location, and is not told; a TER
    begins other residues where there are no chains."""
    seen, piece = set(), 0
    for line in text_of(path).splitlines():
        if line.startswith("ENDMDL"):
            return
        piece += line.startswith("TER") and not line[21:22].strip()
        if line.startswith(("ATOM", "HETATM")) and len(line) > 53:
            segment = line[72:76].strip() if line[72:73].isalpha() else ""
            key, name = f"{piece}{line[21:27]}{segment}", line[12:16]
            if (key, line[17:20], name) not in seen:
                seen.add((key, line[17:20], name))
                element = line[76:78].strip() or name.lstrip(" 0123456789")[:1]
                yield key, line[17:21].strip(), element in ("H", "D")


def residues_of_file(path: Path) -> tuple[Counter[str], dict[str, Counter[int]]]:
    """Of a PDB file: how many residues there are of each usual amino acid, and of each of these the
    numbers of hydrogens."""
    hydrogens: dict[tuple[str, str], int] = defaultdict(int)
    for key, name, is_hydrogen in lines_of_atoms(path):
        if name in HEAVY:
            hydrogens[key, name] += is_hydrogen
    counts: dict[str, Counter[int]] = defaultdict(Counter)
    for (_, name), count in hydrogens.items():
        counts[name][count] += 1
    return Counter(name for _, name in hydrogens), counts


def residue_names(structure) -> np.ndarray:
    """A name for each residue."""
    return structure.residue_names[np.unique(structure.residue_of, return_index=True)[1]]


def residues_of(structure) -> tuple[Counter[str], dict[str, Counter[int]]]:
    """The same of a structure that was read."""
    is_hydrogen = np.isin(structure.symbols, ["H", "D"])
    hydrogens = np.bincount(structure.residue_of, is_hydrogen, structure.residue_count).astype(int)
    counts: dict[str, Counter[int]] = defaultdict(Counter)
    for name, count in zip(residue_names(structure), hydrogens, strict=True):
        if name in HEAVY:
            counts[str(name)][int(count)] += 1
    return Counter({name: rows.total() for name, rows in counts.items()}), counts


def residues(path: Path, structure) -> Iterator[str]:
    """Residues that are more or fewer than the file has, or have other hydrogens."""
    expected, expected_hydrogens = residues_of_file(path)
    found, found_hydrogens = residues_of(structure)
    if expected != found:
        yield f"residues {dict(found - expected)} too many, {dict(expected - found)} missing"
    elif expected_hydrogens != found_hydrogens:
        yield "hydrogens of residues are not those of the file"


def sequence(path: Path, structure) -> Iterator[str]:
    """Chains that have more residues than the file says of their sequence."""
    try:
        file = gemmi.read_structure(str(path))
    except (RuntimeError, ValueError):  # gemmi reads fewer files
        return
    file.setup_entities()
    for chain in file[0] if len(file) else ():
        polymer = chain.get_polymer()
        entity = file.get_entity_of(polymer)
        if entity is None or not entity.full_sequence:
            continue
        names = {gemmi.Entity.first_mon(name) for name in entity.full_sequence}
        of_chain = (structure.chains == chain.name) & np.isin(
            structure.residue_names, sorted(names)
        )
        ours = len(np.unique(structure.residue_of[of_chain]))
        # Ligands and ends may have the names of residues: what is bound as none is not counted.
        others = sum(residue.name in names for residue in chain) - len(polymer)
        most = len(entity.full_sequence)
        if ours > most + others:
            yield f"chain {chain.name} has {ours} residues, of {most} in its sequence"


def allowed_hydrogens(name: str, outside: dict[str, int]) -> set[int]:
    """Numbers that a residue may have whose atoms have so many neighbours in other residues: each
    takes a hydrogen, but those along the chain; a nitrogen without one begins the chain."""
    links = sum(count for atom, count in outside.items() if atom not in ("N", "C"))
    more = (0,) if outside.get("N") else (0, 1, 2)
    return {count - links + extra for count in HYDROGENS[name] for extra in more}


def hydrogens(structure) -> Iterator[str]:
    """Whole residues of a prepared protein that do not have the hydrogens of their kind."""
    bonded = neighbours(structure)
    names, residue_names, residue_of = (
        structure.names,
        structure.residue_names,
        structure.residue_of,
    )
    is_hydrogen = np.isin(structure.symbols, ["H", "D"])
    for atoms in np.split(np.arange(len(names)), np.flatnonzero(np.diff(residue_of)) + 1):
        name = str(residue_names[atoms[0]])
        heavy = [atom for atom in atoms if not is_hydrogen[atom] and names[atom] != "OXT"]
        if len(heavy) != HEAVY.get(name):
            continue
        outside = {
            str(names[atom]): sum(residue_of[other] != residue_of[atom] for other in bonded[atom])
            for atom in heavy
        }
        count, allowed = int(is_hydrogen[atoms].sum()), allowed_hydrogens(name, outside)
        if count not in allowed:
            yield f"{structure.label(atoms[0])}: {count} hydrogens, not {sorted(allowed)}"
