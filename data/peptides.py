# SPDX-License-Identifier: MIT
"""Peptides with the atom names of the Protein Data Bank and Amber, hydrogens included."""

from rdkit import Chem
from rdkit.Chem import AllChem, rdMolTransforms
from sketch import Sketch

SEED = 20240607

# SMILES from N to C, charged as in water, and the names of its atoms in that order. Neutral
# histidine has its hydrogen on NE2.
RESIDUES = {
    "ALA": ("N[C@@H](C)C(=O)", "N CA CB C O"),
    "ARG": ("N[C@@H](CCCNC(=[NH2+])N)C(=O)", "N CA CB CG CD NE CZ NH1 NH2 C O"),
    "ASN": ("N[C@@H](CC(=O)N)C(=O)", "N CA CB CG OD1 ND2 C O"),
    "ASP": ("N[C@@H](CC(=O)[O-])C(=O)", "N CA CB CG OD1 OD2 C O"),
    "CYS": ("N[C@@H](CS)C(=O)", "N CA CB SG C O"),
    "GLN": ("N[C@@H](CCC(=O)N)C(=O)", "N CA CB CG CD OE1 NE2 C O"),
    "GLU": ("N[C@@H](CCC(=O)[O-])C(=O)", "N CA CB CG CD OE1 OE2 C O"),
    "GLY": ("NCC(=O)", "N CA C O"),
    "HIS": ("N[C@@H](Cc1c[nH]cn1)C(=O)", "N CA CB CG CD2 NE2 CE1 ND1 C O"),
    "ILE": ("N[C@@H]([C@@H](C)CC)C(=O)", "N CA CB CG2 CG1 CD1 C O"),
    "LEU": ("N[C@@H](CC(C)C)C(=O)", "N CA CB CG CD1 CD2 C O"),
    "LYS": ("N[C@@H](CCCC[NH3+])C(=O)", "N CA CB CG CD CE NZ C O"),
    "MET": ("N[C@@H](CCSC)C(=O)", "N CA CB CG SD CE C O"),
    "PHE": ("N[C@@H](Cc1ccccc1)C(=O)", "N CA CB CG CD1 CE1 CZ CE2 CD2 C O"),
    "PRO": ("N1[C@@H](CCC1)C(=O)", "N CA CB CG CD C O"),
    "SER": ("N[C@@H](CO)C(=O)", "N CA CB OG C O"),
    "THR": ("N[C@@H]([C@H](O)C)C(=O)", "N CA CB OG1 CG2 C O"),
    "TRP": ("N[C@@H](Cc1c[nH]c2ccccc12)C(=O)", "N CA CB CG CD1 NE1 CE2 CZ2 CH2 CZ3 CE3 CD2 C O"),
    "TYR": ("N[C@@H](Cc1ccc(O)cc1)C(=O)", "N CA CB CG CD1 CE1 CZ OH CE2 CD2 C O"),
    "VAL": ("N[C@@H](C(C)C)C(=O)", "N CA CB CG1 CG2 C O"),
    "ACE": ("CC(=O)", "CH3 C O"),
    "NME": ("NC", "N C"),
}

# Order of the residues: proline and acids at the start, bases at the end, as helices have them.
TWENTY = ["SER", "PRO", "GLU", "ASP", "THR", "ALA", "TRP", "LEU", "VAL", "ILE"]
TWENTY += ["MET", "GLN", "PHE", "TYR", "HIS", "CYS", "LYS", "ASN", "ARG", "GLY"]


class Peptide:
    """Residues joined from N to C, as an RDKit molecule with names."""

    def __init__(self, residues: list[str], head: str, tail: str):
        """`head` replaces the SMILES of the first N, `tail` that of the last C=O."""
        texts = [RESIDUES[name][0] for name in residues]
        texts[0] = head + texts[0][1:]
        texts[-1] = texts[-1].removesuffix("C(=O)") + tail if tail else texts[-1]
        self.molecule = Chem.AddHs(Chem.MolFromSmiles("".join(texts)))
        self.names, self.residues = [], []
        for number, name in enumerate(residues, 1):
            names = RESIDUES[name][1].split()
            self.names += names
            self.residues += [(name, number)] * len(names)
        heavy = sum(atom.GetAtomicNum() > 1 for atom in self.molecule.GetAtoms())
        if heavy == len(self.names) + 1:  # the second oxygen of the last residue
            self.names.append("OXT")
            self.residues.append(self.residues[-1])
        assert heavy == len(self.names)
        self.name_hydrogens()
        self.check_handedness()

    def name_hydrogens(self) -> None:
        """Hydrogens are called after their atom: HB2 and HB3 on CB, HD21 and HD22 on ND2."""
        for k, name in enumerate(list(self.names)):
            atom = self.molecule.GetAtomWithIdx(k)
            hydrogens = [a.GetIdx() for a in atom.GetNeighbors() if a.GetAtomicNum() == 1]
            residue = self.residues[k]
            stem = "H" if name in ("N", "CH3") or residue[0] == "NME" else "H" + name[1:]
            numbers = {1: [""], 2: "23" if atom.GetSymbol() == "C" else "12", 3: "123"}
            for hydrogen, number in zip(hydrogens, numbers.get(len(hydrogens), []), strict=True):
                self.names += [""] * (hydrogen + 1 - len(self.names))
                self.residues += [residue] * (hydrogen + 1 - len(self.residues))
                self.names[hydrogen] = stem + number
                self.residues[hydrogen] = residue

    def check_handedness(self) -> None:
        """L amino acids have S at CA (cysteine R), isoleucine S and threonine R at CB."""
        expected = {("CYS", "CA"): "R", ("ILE", "CB"): "S", ("THR", "CB"): "R"}
        for k, label in Chem.FindMolChiralCenters(self.molecule, useLegacyImplementation=False):
            residue, name = self.residues[k][0], self.names[k]
            assert label == expected.get((residue, name), "S"), (residue, name, label)

    def atom(self, name: str, number: int) -> int:
        """The atom called `name` of the residue of that number."""
        return next(
            k
            for k, residue in enumerate(self.residues)
            if residue[1] == number and self.names[k] == name
        )

    def backbone_torsions(self) -> list[tuple[tuple[int, int, int, int], float]]:
        """Atoms and angles (degrees) of phi, psi and omega of an alpha helix."""
        count = self.residues[-1][1]
        torsions = []
        for k in range(1, count + 1):
            n, ca, c = (self.atom(name, k) for name in ("N", "CA", "C"))
            if k > 1 and self.residues[n][0] != "PRO":
                torsions.append(((self.atom("C", k - 1), n, ca, c), -60.0))
            if k < count:
                following = self.atom("N", k + 1)
                torsions.append(((n, ca, c, following), -45.0))
                torsions.append(((ca, c, following, self.atom("CA", k + 1)), 180.0))
        return torsions

    def embed(self, conformers: int) -> int:
        """Positions for a few conformers; the number of the best after MMFF94."""
        options = AllChem.ETKDGv3()
        options.randomSeed = SEED
        AllChem.EmbedMultipleConfs(self.molecule, conformers, options)
        results = AllChem.MMFFOptimizeMoleculeConfs(self.molecule, maxIters=10000)
        assert all(unfinished == 0 for unfinished, _ in results)
        return min(range(conformers), key=lambda k: round(results[k][1], 6))

    def embed_helix(self) -> None:
        """Positions of an alpha helix: torsions set, and held to 10 degrees as all else settles.

        Let go it would fold up in the end, with no water around it.
        """
        options = AllChem.ETKDGv3()
        options.randomSeed = SEED
        options.useRandomCoords = True
        assert AllChem.EmbedMolecule(self.molecule, options) == 0
        conformer = self.molecule.GetConformer()
        for atoms, angle in self.backbone_torsions():
            rdMolTransforms.SetDihedralDeg(conformer, *atoms, angle)
        properties = AllChem.MMFFGetMoleculeProperties(self.molecule)
        properties.SetMMFFDielectricConstant(80.0)  # charges as in water
        for stiffness, steps in ((100.0, 3000), (20.0, 20000)):
            field = AllChem.MMFFGetMoleculeForceField(self.molecule, properties)
            for atoms, angle in self.backbone_torsions():
                if angle < 180.0:
                    field.MMFFAddTorsionConstraint(*atoms, False, angle - 10, angle + 10, stiffness)
            unfinished = field.Minimize(maxIts=steps)
        assert unfinished == 0

    def sketch(self, conformer: int) -> Sketch:
        """Atoms by residue, heavy atoms first."""
        whole = Sketch.of_rdkit(self.molecule, conformer)
        whole.names, whole.residues = self.names, self.residues
        return whole.ordered(sorted(range(len(self.names)), key=lambda k: (self.residues[k][1], k)))


def alanine_dipeptide() -> Sketch:
    """Acetyl-alanine-methylamide."""
    peptide = Peptide(["ACE", "ALA", "NME"], head="C", tail="")
    return peptide.sketch(peptide.embed(20))


def cyclic_hexapeptide() -> Sketch:
    """Cyclo(Gly-Pro-Phe-Gly-Ala-Leu): a CONECT states the bond that closes the ring."""
    residues = ["GLY", "PRO", "PHE", "GLY", "ALA", "LEU"]
    peptide = Peptide(residues, head="N9", tail="C9(=O)")
    sketch = peptide.sketch(peptide.embed(20))
    head = sketch.residues.index(("GLY", 1))
    tail = next(
        k for k, name in enumerate(sketch.names) if name == "C" and sketch.residues[k][1] == 6
    )
    sketch.stated_bonds = [(head, tail)]
    return sketch


def helix_of_twenty() -> Sketch:
    """Each amino acid once, with charged ends."""
    peptide = Peptide(TWENTY, head="[NH3+]", tail="C(=O)[O-]")
    peptide.embed_helix()
    return peptide.sketch(-1)
