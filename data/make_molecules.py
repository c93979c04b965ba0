#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the files of data/molecules and their table in data/README.md.

Geometry comes from RDKit (distance geometry with a fixed seed, then the MMFF94 force field) or
from formulas (cyclohexane, C60). The version of RDKit that made the committed files stands in
data/README.md; with it the files come out the same, byte for byte.

    python data/make_molecules.py [FOLDER]
"""

import itertools
import re
import sys
from math import cos, pi, sin, sqrt
from pathlib import Path

import numpy as np
import rdkit
from peptides import alanine_dipeptide, cyclic_hexapeptide, helix_of_twenty
from rdkit import Chem
from rdkit.Chem import AllChem
from sketch import Sketch
from writers import write_mmcif, write_pdb, write_sdf, write_v3000, write_xyz

HERE = Path(__file__).resolve().parent
SEED = 20240607
CONFORMERS = 20


def from_smiles(smiles: str, residue: str = "UNL") -> Sketch:
    """The conformer of lowest MMFF94 energy among a few, centred."""
    molecule = Chem.AddHs(Chem.MolFromSmiles(smiles))
    options = AllChem.ETKDGv3()
    options.randomSeed = SEED
    AllChem.EmbedMultipleConfs(molecule, CONFORMERS, options)
    results = AllChem.MMFFOptimizeMoleculeConfs(molecule, maxIters=10000)
    assert all(unfinished == 0 for unfinished, _ in results), smiles
    best = min(range(len(results)), key=lambda k: round(results[k][1], 6))
    return Sketch.of_rdkit(molecule, best, residue)


def ring_of_six(carbons: np.ndarray) -> Sketch:
    """Cyclohexane on carbons whose bonds make tetrahedral angles: hydrogens complete them."""
    hydrogens = []
    half = np.arccos(-1 / 3) / 2
    for k in range(6):
        one, other = carbons[k - 1] - carbons[k], carbons[(k + 1) % 6] - carbons[k]
        outward = -(one + other) / np.linalg.norm(one + other)
        across = np.cross(one, other) / np.linalg.norm(np.cross(one, other))
        hydrogens += [
            carbons[k] + 1.09 * (cos(half) * outward + sign * sin(half) * across)
            for sign in (1, -1)
        ]
    bonds = [(k, (k + 1) % 6, 1) for k in range(6)]
    bonds += [(k, 6 + 2 * k + j, 1) for k in range(6) for j in range(2)]
    return Sketch(["C"] * 6 + ["H"] * 12, np.array([*carbons, *hydrogens]), bonds)


def chair(bond: float = 1.54) -> Sketch:
    """The ring of diamond: symmetry D3d."""
    radius, height = bond * sqrt(8) / 3, bond / 6
    return ring_of_six(
        np.array(
            [
                [radius * cos(k * pi / 3), radius * sin(k * pi / 3), height * (-1) ** k]
                for k in range(6)
            ]
        )
    )


def boat(bond: float = 1.54) -> Sketch:
    """Four carbons in a plane, bow and stern above it: symmetry C2v, the same angles."""
    x, y, over, up = bond / 2, bond * sqrt(2 / 3), bond / 3, bond * sqrt(2) / 3
    bow, stern = [x + over, 0, up], [-x - over, 0, up]
    return ring_of_six(np.array([bow, [x, y, 0], [-x, y, 0], stern, [-x, -y, 0], [x, -y, 0]]))


def fullerene(single: float = 1.458, double: float = 1.401) -> Sketch:
    """C60: an icosahedron cut so that pentagon edges and the others have their own lengths."""
    golden = (1 + sqrt(5)) / 2
    corners = np.array(
        [
            np.roll([0, one, other * golden], turn)
            for turn in range(3)
            for one, other in itertools.product((1, -1), repeat=2)
        ]
    )
    edge = double + 2 * single
    corners *= edge / 2  # the edges of these corners are 2 long
    positions, owner = [], []
    for a, b in itertools.permutations(range(12), 2):
        if abs(np.linalg.norm(corners[a] - corners[b]) - edge) < 1e-6:
            positions.append(corners[a] + (corners[b] - corners[a]) * single / edge)
            owner.append(a)
    positions = np.array(positions)
    bonds = []
    for i, j in itertools.combinations(range(60), 2):
        length = np.linalg.norm(positions[i] - positions[j])
        if length < 1.5:
            bonds.append((i, j, 1 if owner[i] == owner[j] else 2))
    return Sketch(["C"] * 60, positions, bonds)


GLUCOSE = "OC[C@H]1O[C@@H](O)[C@H](O)[C@@H](O)[C@@H]1O"
CHOLESTEROL = "C[C@H](CCCC(C)C)[C@H]1CC[C@@H]2[C@@]1(CC[C@H]3[C@H]2CC=C4[C@@]3(CC[C@@H](C4)O)C)C"

# File, how it is made and written, and why it is here.
MOLECULES = [
    ("ethane.xyz", lambda: from_smiles("CC"), write_xyz, "the smallest molecule with a torsion"),
    ("butane.sdf", lambda: from_smiles("CCCC"), write_sdf, "a chain: every bar is a bridge"),
    ("cyclohexane_chair.xyz", chair, write_xyz, "a rigid ring once its angles are held; exact"),
    (
        "cyclohexane_boat.xyz",
        boat,
        write_xyz,
        "the same ring, flexible with the same angles; exact",
    ),
    ("benzene.sdf", lambda: from_smiles("c1ccccc1"), write_sdf, "a planar ring, aromatic bonds"),
    (
        "caffeine.sdf",
        lambda: from_smiles("Cn1cnc2c1c(=O)n(C)c(=O)n2C"),
        write_sdf,
        "fused rings and methyl groups; the molecule of the demo",
    ),
    (
        "aspirin.sdf",
        lambda: from_smiles("CC(=O)Oc1ccccc1C(=O)O"),
        write_sdf,
        "a ring with two flexible arms",
    ),
    (
        "glucose.cif",
        lambda: from_smiles(GLUCOSE, "BGC"),
        write_mmcif,
        "a saturated ring with oxygen and many hydroxyl groups; mmCIF with its bonds",
    ),
    (
        "cholesterol.cif",
        lambda: from_smiles(CHOLESTEROL, "CLR"),
        lambda sketch, title: write_mmcif(sketch, title, bonds=False),
        "four fused rings and a tail; mmCIF without bonds, found by distance",
    ),
    ("alanine_dipeptide.pdb", alanine_dipeptide, write_pdb, "the field's standard: phi and psi"),
    (
        "cyclic_hexapeptide.pdb",
        cyclic_hexapeptide,
        write_pdb,
        "a ring of 18 backbone atoms: loop closure",
    ),
    (
        "crown_18_6.cif",
        lambda: from_smiles("C1COCCOCCOCCOCCOCCO1", "O4B"),
        write_mmcif,
        "a macrocycle: one long flexible cycle",
    ),
    (
        "cubane.xyz",
        lambda: from_smiles("C12C3C4C1C5C2C3C45"),
        write_xyz,
        "a cage that its bonds alone hold nearly rigid",
    ),
    (
        "adamantane.mol",
        lambda: from_smiles("C1C2CC3CC1CC(C2)C3"),
        write_v3000,
        "three chairs in one cage; MOL V3000",
    ),
    ("c60.xyz", fullerene, write_xyz, "31 rings in one block: the most cyclic of all"),
    (
        "peptide_20.pdb",
        helix_of_twenty,
        write_pdb,
        "each of the 20 amino acids once, as a helix; amber14 accepts it unchanged",
    ),
]


def in_small_ring(around: list[set[int]], a: int, b: int) -> bool:
    """Whether a bond is in a ring of up to six atoms."""
    reached = {a}
    for _ in range(5):
        ways = [(x, y) for x in reached for y in around[x] if {x, y} != {a, b}]
        reached |= {y for _, y in ways}
        if b in reached:
            return True
    return False


def planar_torsions(sketch: Sketch, around: list[set[int]]) -> int:
    """Double bonds, and nitrogens at a carbon that has one, where something hangs on both ends."""
    doubled = {atom for a, b, order in sketch.bonds if order == 2 for atom in (a, b)}
    count = 0
    for a, b, order in sketch.bonds:
        c, n = (a, b) if sketch.elements[a] == "C" else (b, a)
        is_amide = (sketch.elements[c], sketch.elements[n]) == ("C", "N") and c in doubled
        if order == 2 or (order == 1 and is_amide):
            hangs = min(len(around[a]), len(around[b])) > 1
            count += hangs and not in_small_ring(around, a, b)
    return count


def graph_facts(sketch: Sketch) -> tuple[int, int, int, int]:
    """Atoms, bonds, bars of ``--bars angles``, independent cycles: from the bonds above."""
    around = [set() for _ in sketch.elements]
    for a, b, _ in sketch.bonds:
        around[a].add(b)
        around[b].add(a)
    bonded = {frozenset((a, b)) for a, b, _ in sketch.bonds}
    across = {frozenset(two) for ends in around for two in itertools.combinations(ends, 2)}
    seen, components = set(), 0
    for atom in range(len(around)):
        components += atom not in seen
        reached = [atom]
        while reached:
            here = reached.pop()
            if here not in seen:
                seen.add(here)
                reached += around[here]
    atoms, bonds = len(around), len(bonded)
    held = len(bonded | across) + planar_torsions(sketch, around)
    return atoms, bonds, held, bonds - atoms + components


def write_table(rows: list[str]) -> None:
    """Puts the rows between the marks in README.md."""
    readme = HERE / "README.md"
    table = "\n".join(
        [
            f"Made with RDKit {rdkit.__version__}.",
            "",
            "| file | why it is here | atoms | bars: bonds | bars: angles | cycles |",
            "|---|---|---:|---:|---:|---:|",
            *rows,
        ]
    )
    marks = r"(<!-- made by make_molecules.py -->\n).*?(\n<!-- end -->)"
    text = re.sub(marks, rf"\g<1>{table}\g<2>", readme.read_text(), flags=re.DOTALL)
    readme.write_text(text)


def main(folder: Path) -> None:
    """Writes every molecule; and the table, when the folder is the project's."""
    rows = []
    for file, make, write, why in MOLECULES:
        sketch = make().centred()
        title = file.rsplit(".")[0].replace("_", " ")
        (folder / file).write_text(write(sketch, title))
        rows.append("| " + " | ".join([file, why, *map(str, graph_facts(sketch))]) + " |")
    if folder == HERE / "molecules":
        write_table(rows)


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else HERE / "molecules")
