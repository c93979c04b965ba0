# SPDX-License-Identifier: MIT
"""Hydrogen bonds of ligands beside those that ProLIF finds (Bouysset, Fiorucci, J. Cheminform. 13
(2021) 72), which gets the ligand with hydrogens."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from pliant.checks.ligands.chemistry import chemistry_of
from pliant.checks.ligands.found import part_of

import pliant

pytestmark = pytest.mark.long
MDA = pytest.importorskip("MDAnalysisTests.datafiles")
DATA = Path(MDA.PDB_small).parent

#: file -> ligand, residues that both find, that we alone find, that ProLIF alone finds
CASES = {
    # the two aspartates share protons; ProLIF sees one of them by where RDKit puts the hydrogens
    "1hvr.pdb": ("XK2", "A:50 B:50 A:25", "B:25", ""),
    # our energy of the bond to Gln725 is above -1 kcal/mol (N..O 3.3 Angstrom)
    "1a28.pdb.gz": ("STR", "", "", "A:725"),
}


def with_hydrogens(structure, atoms, name):
    """The ligand as ProLIF takes it."""
    chem = pytest.importorskip("rdkit.Chem")
    part = part_of(structure, atoms)
    made = chemistry_of(part, name, {})
    molecule, places = chem.Mol(made.molecule), made.complete(np.asarray(part.positions))
    conformer = chem.Conformer(len(places))
    conformer.SetPositions(np.ascontiguousarray(places))
    molecule.RemoveAllConformers()
    molecule.AddConformer(conformer)
    for atom in molecule.GetAtoms():
        words = {"residueName": name, "residueNumber": 1, "chainId": "L"}
        atom.SetMonomerInfo(chem.AtomPDBResidueInfo(atom.GetSymbol(), **words))
    return molecule


@pytest.mark.parametrize("file", CASES)
def test_hydrogen_bonds_are_those_of_prolif(file):
    prolif = pytest.importorskip("prolif")
    name, both, ours_alone, theirs_alone = CASES[file]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = pliant.sample(DATA / file, frames=1, all_hydrogens=True).model
        structure = model.structure
        universe = pliant.to_mdanalysis(structure)
        ligand = universe.select_atoms(f"resname {name} and segid A")
        around = universe.select_atoms("protein and byres around 12 group l", l=ligand)
        protein = prolif.Molecule.from_mda(around)
        drawn = prolif.Molecule.from_rdkit(with_hydrogens(structure, ligand.ix, name))
        kinds = prolif.Fingerprint(["HBDonor", "HBAcceptor"])
        found = kinds.generate(drawn, protein, metadata=True)
    theirs = {f"{place.chain}:{place.number}" for _, place in found}
    own = set(ligand.ix.tolist())
    rows = [row for row in pliant.contacts(structure) if row["kind"] == "hydrogen_bond"]
    pairs = [(int(row["a"]), int(row["b"])) for row in rows]
    others = [b if a in own else a for a, b in pairs if (a in own) != (b in own)]
    ours = {f"{structure.chains[k]}:{structure.residue_ids[k]}" for k in others}
    assert ours == {*both.split(), *ours_alone.split()}
    assert theirs == {*both.split(), *theirs_alone.split()}
