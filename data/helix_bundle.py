# SPDX-License-Identifier: MIT
"""A small protein of three helices: backbone by its torsions, side chains of the peptide of 20.

Two helices lie side by side, the third is ajar: pulled at its end, it swings about the loop.
"""

import re
from pathlib import Path

import numpy as np
from peptides import SEED, Peptide
from rdkit.Chem import AllChem, Conformer
from rdkit.Geometry import Point3D
from sketch import Sketch
from writers import write_pdb

HERE = Path(__file__).resolve().parent
LETTERS = dict(
    zip(
        "ARNDCQEGHILKMFPSTWYV",
        "ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL".split(),
        strict=True,
    )
)
HELICES = ("SAEELLKKFEELIKKA", "SPEELVRKLAEWLRKA", "SPEEVLKKLAELYKKLG")
LOOP = "GNG"
SEQUENCE = LOOP.join(HELICES)
# Basins of phi and psi that the residues of a loop may take: alpha, beta, left-handed.
BASINS = ((-65.0, -40.0), (-120.0, 130.0), (-75.0, 145.0), (60.0, 40.0))
TRIALS = 4000
REACH = {"G": 0.0, "A": 1.5, "S": 2.0, "P": 1.9, "V": 2.0, "N": 2.5}  # of side chains, Angstrom


def place(a, b, c, length, angle, torsion):
    """Points (T, 3) bound to c at a length (Angstrom), an angle and torsions (degrees)."""
    angle, torsion = np.radians(angle), np.radians(torsion)[:, None]
    bc = (c - b) / np.linalg.norm(c - b, axis=1, keepdims=True)
    n = np.cross(b - a, bc)
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    out = np.cos(torsion) * np.cross(n, bc) + np.sin(torsion) * n
    return c + length * (np.sin(angle) * out - np.cos(angle) * bc)


def backbone(phi, psi):
    """N, CA, C of each residue, (T, K, 3, 3), of torsions (T, K): ideal lengths and angles
    (Engh & Huber 1991)."""
    trials, count = phi.shape
    flat = np.full(trials, 180.0)
    start = np.array([[0, 0, 0], [1.458, 0, 0], [1.458 + 1.525 * 0.358368, 1.525 * 0.933580, 0]])
    atoms = list(np.repeat(start[:, None], trials, axis=1))
    for k in range(1, count):
        atoms.append(place(*atoms[-3:], 1.329, 117.2, psi[:, k - 1]))
        atoms.append(place(*atoms[-3:], 1.458, 121.7, flat))
        atoms.append(place(*atoms[-3:], 1.525, 111.0, phi[:, k]))
    return np.stack(atoms, axis=1).reshape(trials, count, 3, 3)


def stretches():
    """First and last residue of each helix."""
    found, at = [], 0
    for helix in HELICES:
        found.append((at, at + len(helix)))
        at += len(helix) + len(LOOP)
    return found


def axis(alpha_carbons):
    """Middle and direction of a helix."""
    middle = alpha_carbons.mean(axis=0)
    way = np.linalg.svd(alpha_carbons - middle)[2][0]
    return middle, way * np.sign(way @ (alpha_carbons[-1] - alpha_carbons[0]))


def tips(atoms):
    """Where the side chains end, about: along CA to CB, as far as the residue is long."""
    n, ca, c = atoms[:, 0], atoms[:, 1], atoms[:, 2]
    out = 2 * ca - n - c
    side = np.cross(n - ca, c - ca)
    way = 0.58 * out / np.linalg.norm(out, axis=1, keepdims=True)
    way += 0.82 * side / np.linalg.norm(side, axis=1, keepdims=True)
    return ca + way * np.array([REACH.get(letter, 3.0) for letter in SEQUENCE])[:, None]


def badness(atoms):
    """Least where the first two helices pack, and the third is ajar and touches nothing."""
    ca = atoms[:, 1]
    between = np.linalg.norm(ca[:, None] - ca[None], axis=2)
    near = between[np.triu_indices(len(ca), 3)]
    clashes = np.clip(5.2 - near, 0, None).sum()
    ends = tips(atoms)
    crowd = np.linalg.norm(np.concatenate([ends, ca])[:, None] - ends[None], axis=2)
    far = np.abs(np.subtract.outer(np.tile(np.arange(len(ca)), 2), np.arange(len(ca)))) > 3
    clashes += np.clip(4.6 - crowd[far], 0, None).sum()
    (m1, w1), (m2, w2), (m3, w3) = (axis(ca[a:b]) for a, b in stretches())
    packed = abs(np.linalg.norm(m2 - m1) - 10.2) + 8 * (1 + w1 @ w2)
    side = abs(np.linalg.norm(m3 - m2) - 15.0) + abs(np.linalg.norm(m3 - m1) - 17.0)
    first, second, third = (ca[a:b] for a, b in stretches())
    across = np.linalg.norm(third[:, None] - np.concatenate([first, second])[None], axis=2)
    apart = np.clip(8.0 - across.min(), 0, None)
    return 4 * clashes + packed + 0.4 * side + 6 * abs(w2 @ w3 + 0.6) + 2 * apart


def drawn(random, trials):
    """Torsions (trials, K) of helices, those of the loops from their basins."""
    phi = np.full((trials, len(SEQUENCE)), -62.0)
    psi = np.full((trials, len(SEQUENCE)), -43.0)
    for _, end in stretches()[:2]:
        for k in range(end - 1, end + len(LOOP) + 1):
            may_turn = SEQUENCE[k] == "G"
            basins = np.array(BASINS if may_turn else BASINS[:3])
            chosen = basins[random.integers(len(basins), size=trials)]
            chosen = chosen + random.normal(0, 10, chosen.shape)
            phi[:, k] = -65.0 if SEQUENCE[k] == "P" else chosen[:, 0]
            psi[:, k] = chosen[:, 1]
    return phi, psi


def best_of(phi, psi):
    """The torsions of the trial with the least badness, and that."""
    values = [badness(atoms) for atoms in backbone(phi, psi)]
    best = int(np.argmin(values))
    return values[best], phi[best], psi[best]


def loops(random):
    """Torsions by trial, and then by ever smaller changes of the best."""
    best = best_of(*drawn(random, TRIALS))
    free = [k for _, end in stretches()[:2] for k in range(end - 1, end + len(LOOP) + 1)]
    for width in (12.0, 6.0, 3.0, 1.5):
        phi, psi = (np.repeat(angles[None], TRIALS // 8, axis=0) for angles in best[1:])
        phi[1:, free] += random.normal(0, width, (len(phi) - 1, len(free)))
        psi[1:, free] += random.normal(0, width, (len(phi) - 1, len(free)))
        best = best_of(phi, psi)
    return best


def templates():
    """{residue: {atom: position}} of the peptide of 20."""
    found = {}
    text = (HERE / "molecules" / "peptide_20.pdb").read_text()
    for line in re.findall("^ATOM.*", text, flags=re.MULTILINE):
        place_of = [float(line[k : k + 8]) for k in (30, 38, 46)]
        found.setdefault(line[17:20], {})[line[12:16].strip()] = np.array(place_of)
    return found


def onto(template, atoms):
    """A residue laid onto N, CA, C: least squares (Kabsch 1976)."""
    own = np.array([template[name] for name in ("N", "CA", "C")])
    left, _, right = np.linalg.svd((own - own.mean(axis=0)).T @ (atoms - atoms.mean(axis=0)))
    turn = left @ np.diag([1, 1, np.sign(np.linalg.det(left @ right))]) @ right
    return {n: (x - own.mean(axis=0)) @ turn + atoms.mean(axis=0) for n, x in template.items()}


def one(*points):
    """For `place`, which takes many at a time."""
    return (np.array(point)[None] for point in points)


def grafted(peptide, atoms, psi):
    """Positions of all atoms: side chains of the helix of 20, O and H by the backbone."""
    known, count = templates(), len(atoms)
    built = []
    for k, letter in enumerate(SEQUENCE):
        n, ca, c = atoms[k]
        new = onto(known[LETTERS[letter]], atoms[k])
        new |= {"N": n, "CA": ca, "C": c}
        new["O"] = place(*one(n, ca, c), 1.231, 120.5, np.array([psi[k] + 180.0]))[0]
        if k:
            before = atoms[k - 1, 2]
            out = (n - before) / np.linalg.norm(n - before) + (n - ca) / np.linalg.norm(n - ca)
            new["H"] = n + 1.01 * out / np.linalg.norm(out)
        for number, turn in zip("123", (60.0, 180.0, 300.0), strict=True):
            new[f"H{number}"] = place(*one(c, ca, n), 1.01, 109.5, np.array([turn]))[0]
        new["OXT"] = place(*one(n, ca, c), 1.25, 118.0, np.array([psi[k]]))[0]
        built.append(new)
    assert count == len(built)
    rows = zip(peptide.residues, peptide.names, strict=True)
    return np.array([built[number - 1][name] for (_, number), name in rows])


def settle(peptide, positions):
    """MMFF94, the backbone held near its place, until no atom is too near another."""
    molecule = peptide.molecule
    conformer = Conformer(molecule.GetNumAtoms())
    for k, x in enumerate(positions):
        conformer.SetAtomPosition(k, Point3D(*map(float, x)))
    molecule.AddConformer(conformer)
    properties = AllChem.MMFFGetMoleculeProperties(molecule)
    properties.SetMMFFDielectricConstant(80.0)  # charges as in water
    for slack, steps in ((0.1, 300), (0.3, 1500)):
        field = AllChem.MMFFGetMoleculeForceField(molecule, properties, nonBondedThresh=9.0)
        for k, name in enumerate(peptide.names):
            if name in ("N", "CA", "C", "O"):
                field.MMFFAddPositionConstraint(k, slack, 200.0)
        field.Initialize()
        field.Minimize(maxIts=steps)
    hold_helices(peptide, properties)


def hold_helices(peptide, properties):
    """O of a residue and H of the fourth after it are drawn to where they bind.

    In vacuum the hydrogen bonds of helices grow long.
    """
    field = AllChem.MMFFGetMoleculeForceField(peptide.molecule, properties, nonBondedThresh=7.0)
    field.Initialize()
    for begin, end in stretches():
        for number in range(begin + 1, end - 3):
            if SEQUENCE[number + 3] != "P":
                ends = peptide.atom("O", number), peptide.atom("H", number + 4)
                field.MMFFAddDistanceConstraint(*ends, False, 1.9, 2.05, 300.0)
    field.Minimize(maxIts=400)


def three_helices() -> Sketch:
    """Fifty-five residues: two helices side by side and one ajar, with charged ends."""
    _, phi, psi = loops(np.random.default_rng(SEED))
    names = [LETTERS[letter] for letter in SEQUENCE]
    peptide = Peptide(names, head="[NH3+]", tail="C(=O)[O-]")
    settle(peptide, grafted(peptide, backbone(phi[None], psi[None])[0], psi))
    return peptide.sketch(-1)


if __name__ == "__main__":
    made = three_helices().centred()
    (HERE / "proteins").mkdir(exist_ok=True)
    (HERE / "proteins" / "three_helices.pdb").write_text(write_pdb(made, "three helices"))
