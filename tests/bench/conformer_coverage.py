# SPDX-License-Identifier: MIT
"""Which conformers of RDKit and MMFF `pliant sample` finds, beside RDKit itself.

    .venv/bin/python tests/bench/conformer_coverage.py [--molecules atenolol,...] [--json FILE]

Reference: 200 conformers by ETKDGv3 (seed 42), minimised by MMFF94, those within 10 kcal/mol of the
lowest, in greedy clusters by RMSD over heavy atoms, symmetry counted, at 0.5 and at 0.75 Angstrom.
Found is a cluster with a frame as near to its first member. Handedness that the names leave open is
that of our start for all: no frame of ours leaves it. Both begin alike from nothing but the
molecule: ours are 1000 frames from one conformer (ETKDGv3, seed 7, MMFF94), RDKit's the 1000 raw
conformers of ETKDGv3 (seed 11). Every bar of every frame is checked. Of the first two tables six
molecules were looked at while rotors were written (lidocaine, ibuprofen, captopril, atenolol,
chlorambucil, fentanyl). Large and fused rings were tuned on the third table, and measured on the
second.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from pathlib import Path

import numpy as np
from rdkit import Chem, RDLogger
from rdkit.Chem import AllChem

import pliant

WITHOUT_FLEXIBLE_RINGS = {
    "lidocaine": "CCN(CC)CC(=O)Nc1c(C)cccc1C",
    "propranolol": "CC(C)NCC(O)COc1cccc2ccccc12",
    "atenolol": "CC(C)NCC(O)COc1ccc(CC(N)=O)cc1",
    "ibuprofen": "CC(C)Cc1ccc(cc1)C(C)C(=O)O",
    "captopril": "CC(CS)C(=O)N1CCCC1C(=O)O",
    "gemfibrozil": "Cc1ccc(C)c(OCCCC(C)(C)C(=O)O)c1",
    "diphenhydramine": "CN(C)CCOC(c1ccccc1)c1ccccc1",
    "procainamide": "CCN(CC)CCNC(=O)c1ccc(N)cc1",
    "fluoxetine": "CNCCC(Oc1ccc(cc1)C(F)(F)F)c1ccccc1",
    "salbutamol": "CC(C)(C)NCC(O)c1ccc(O)c(CO)c1",
    "chlorambucil": "OC(=O)CCCc1ccc(cc1)N(CCCl)CCCl",
    "metoprolol": "CC(C)NCC(O)COc1ccc(CCOC)cc1",
}
WITH_FLEXIBLE_RINGS = {
    "dodecanolide": "O=C1CCCCCCCCCCO1",
    "fentanyl": "CCC(=O)N(c1ccccc1)C1CCN(CCc2ccccc2)CC1",
    "cyclic peptide": "O=C1CNC(=O)C(C)NC(=O)CNC(=O)C(CC(C)C)NC(=O)CN1",
    "haloperidol": "OC1(CCN(CCCC(=O)c2ccc(F)cc2)CC1)c1ccc(Cl)cc1",
}
#: Large rings, rings beside rotors and fused rings: what was looked at while these were written.
TUNED_ON = {
    "cyclododecane": "C1CCCCCCCCCCC1",
    "cyclotetradecane": "C1CCCCCCCCCCCCC1",
    "cyclodecene": "C1CC=CCCCCCC1",
    "muscone": "CC1CCCCCCCCCCCCC(=O)C1",
    "pentadecanolide": "O=C1CCCCCCCCCCCCCCO1",
    "18-crown-6": "C1COCCOCCOCCOCCOCCO1",
    "erythronolide B": "CCC1OC(=O)C(C)C(O)C(C)C(O)C(C)CC(C)C(=O)C(C)C(O)C1C",
    "cyclohexaglycine": "O=C1CNC(=O)CNC(=O)CNC(=O)CNC(=O)CNC(=O)CN1",
    "cyclotetrapeptide": "O=C1CNC(=O)C(C)NC(=O)CNC(=O)C(C(C)C)N1",
    "cis-decalin": "C1CC[C@H]2CCCC[C@H]2C1",
    "hydrindane": "C1CC[C@H]2CCC[C@H]2C1",
    "tropyl benzoate": "CN1[C@H]2CC[C@@H]1CC(OC(=O)c1ccccc1)C2",
    "paroxetine": "Fc1ccc(cc1)C1CCNCC1COc1ccc2OCOc2c1",
}
CUTOFFS = (0.5, 0.75)  #: Angstrom
FRAMES = 1000
WITHIN = 10.0  #: kcal/mol
MOST_SYMMETRIES = 2000


def embedded(molecule: Chem.Mol, count: int, seed: int) -> Chem.Mol:
    """A copy with conformers of ETKDGv3."""
    copy = Chem.Mol(molecule)
    copy.RemoveAllConformers()
    settings = AllChem.ETKDGv3()
    settings.randomSeed = seed
    AllChem.EmbedMultipleConfs(copy, count, settings)
    return copy


def started(molecule: Chem.Mol) -> Chem.Mol:
    """One minimised conformer, whose handedness becomes that of the molecule."""
    start = embedded(molecule, 1, 7)
    AllChem.MMFFOptimizeMolecule(start, maxIters=2000)
    Chem.AssignStereochemistryFrom3D(start)
    return start


def positions_of(molecule: Chem.Mol) -> np.ndarray:
    """(F, N, 3) Angstrom."""
    return np.array([conformer.GetPositions() for conformer in molecule.GetConformers()])


def reference(molecule: Chem.Mol) -> np.ndarray:
    """Minimised conformers, the lowest first."""
    made = embedded(molecule, 200, 42)
    energies = np.array([e for _, e in AllChem.MMFFOptimizeMoleculeConfs(made, maxIters=2000)])
    order = np.argsort(energies, kind="stable")
    return positions_of(made)[order[energies[order] < energies.min() + WITHIN]]


def symmetries(molecule: Chem.Mol) -> np.ndarray:
    """(S, n) orders of the heavy atoms that are alike."""
    heavy = Chem.RemoveHs(molecule)
    matches = heavy.GetSubstructMatches(heavy, uniquify=False, maxMatches=MOST_SYMMETRIES)
    return np.array(matches)


def rmsds(ours: np.ndarray, theirs: np.ndarray, orders: np.ndarray) -> np.ndarray:
    """(a, b) least RMSD of (a, n, 3) and (b, n, 3) over the orders, superposed (Kabsch)."""
    ours, theirs = (x - x.mean(axis=1, keepdims=True) for x in (ours, theirs))
    squares = (ours**2).sum((1, 2))[None] + (theirs**2).sum((1, 2))[:, None]
    least = np.full((len(ours), len(theirs)), np.inf)
    for order in orders:
        products = np.einsum("bni,anj->baij", theirs[:, order], ours)
        values = np.linalg.svd(products, compute_uv=False)
        values[..., 2] *= np.sign(np.linalg.det(products))
        sums = np.maximum(squares - 2 * values.sum(axis=-1), 0)
        least = np.minimum(least, np.sqrt(sums / ours.shape[1]).T)
    return least


def clusters(conformers: np.ndarray, orders: np.ndarray, cutoff: float) -> np.ndarray:
    """Their first members: each is the lowest of what is left."""
    apart = rmsds(conformers, conformers, orders)
    left, first = np.arange(len(conformers)), []
    while len(left):
        first.append(left[0])
        left = left[apart[first[-1], left] >= cutoff]
    return conformers[first]


def sampled(start: Chem.Mol) -> tuple[np.ndarray, float]:
    """Our frames, and the seconds that they took, reading and model included."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "start.sdf"
        Chem.MolToMolFile(start, str(path))
        begun = time.perf_counter()
        ensemble = pliant.sample(pliant.read(path), FRAMES, sampler="torsions")
        seconds = time.perf_counter() - begun
    assert ensemble.max_residual < 1e-9
    return np.array(ensemble.positions), seconds


def measure(name: str, smiles: str) -> dict[str, object]:
    """One row of the table."""
    molecule = started(Chem.AddHs(Chem.MolFromSmiles(smiles)))
    heavy = [atom.GetIdx() for atom in molecule.GetAtoms() if atom.GetAtomicNum() > 1]
    orders, wanted = symmetries(molecule), reference(molecule)[:, heavy]
    ours, our_seconds = sampled(molecule)
    begun = time.perf_counter()
    theirs = positions_of(embedded(molecule, FRAMES, 11))
    their_seconds = time.perf_counter() - begun
    row: dict[str, object] = {"molecule": name}
    for cutoff in CUTOFFS:
        first = clusters(wanted, orders, cutoff)
        row[f"clusters {cutoff}"] = len(first)
        for what, found in (("pliant", ours), ("rdkit", theirs)):
            near = rmsds(first, found[:, heavy], orders).min(axis=1)
            row[f"{what} {cutoff}"] = round(float(np.mean(near < cutoff)), 3)
    row["pliant frames/s"] = round(len(ours) / our_seconds)
    row["rdkit frames/s"] = round(len(theirs) / their_seconds)
    return row


def show(title: str, rows: list[dict[str, object]]) -> None:
    """A table in Markdown, with means."""
    if not rows:
        return
    names = list(rows[0])
    print(f"\n{title}\n\n| " + " | ".join(names) + " |\n|" + "---|" * len(names))
    means = {n: round(float(np.mean([row[n] for row in rows])), 3) for n in names[1:]}
    for row in [*rows, {"molecule": "mean"} | means]:
        print("| " + " | ".join(str(row[name]) for name in names) + " |", flush=True)


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--molecules", type=lambda text: text.split(","), default=None)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    RDLogger.DisableLog("rdApp.*")
    tables = {}
    for title, molecules in (
        ("Without flexible rings", WITHOUT_FLEXIBLE_RINGS),
        ("With flexible rings", WITH_FLEXIBLE_RINGS),
        ("Tuned on", TUNED_ON),
    ):
        chosen = {n: s for n, s in molecules.items() if n in (arguments.molecules or molecules)}
        tables[title] = [measure(name, smiles) for name, smiles in chosen.items()]
        show(title, tables[title])
    if arguments.json:
        arguments.json.write_text(json.dumps(tables, indent=1))


if __name__ == "__main__":
    main()
