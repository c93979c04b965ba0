# SPDX-License-Identifier: MIT
"""The drawing of an aromatic ring decides nothing: all Kekule forms give the same."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from drawings import drawings, embedded
from rdkit import Chem
from rdkit.Chem import AllChem

SMILES = Path(__file__).parents[2] / "support" / "python" / "molecules.smi"
DRUG_LIKE = {
    "2-anilinopyridine": "c1ccccc1Nc1ccccn1",
    "4-anilinopyrimidine": "c1ccccc1Nc1ccncn1",
    "2-aminopyridine": "Nc1ccccn1",
    "2-methylaminopyrimidine": "CNc1ncccn1",
    "2-dimethylaminothiazole": "CN(C)c1nccs1",
    "2-anilinoimidazole": "c1ccccc1Nc1ncc[nH]1",
    "3-anilinopyrazole": "c1ccccc1Nc1cc[nH]n1",
    "5-methylaminotetrazole": "CNc1nnn[nH]1",
    "2-methylaminobenzoxazole": "CNc1nc2ccccc2o1",
    "4-anilinoquinazoline": "c1ccccc1Nc1ncnc2ccccc12",
    "6-methyladenine": "CNc1ncnc2[nH]cnc12",
    "7-anilinopyrazolopyrimidine": "c1ccccc1Nc1ccnc2ccnn12",
    "3-methylaminoimidazopyridine": "CNc1cnc2ccccn12",
    "N-methylcytosine": "CNc1cc[nH]c(=O)n1",
    "4-methylaminopyridone": "CNc1cc[nH]c(=O)c1",
    "2-acetamidopyridine": "CC(=O)Nc1ccccn1",
    "N-phenyl-N-pyridylurea": "NC(=O)N(c1ccccc1)c1ccccn1",
    "2-methylaminotropone": "CNc1cccccc1=O",
    "6-methylaminoazulene": "CNc1ccc2cccc2cc1",
    "2-anilinopyridine N-oxide": "c1ccccc1Nc1cccc[n+]1[O-]",
    "2-methylaminopyrylium": "CNc1cccc[o+]1",
    "2-methylaminophenazine": "CNc1ccc2nc3ccccc3nc2c1",
    "5-methylaminoindolizine": "CNc1cccc2cccn12",
    "benzamidine": "NC(=N)c1ccccc1",
    "methylguanidinium of pyridine": "CNC(N)=[NH+]c1ccccn1",
    "2-pyridylpyridone": "O=c1ccccn1-c1ccccn1",
    "triaminotriazine": "CNc1nc(NC)nc(N(C)C)n1",
    "N-methylthieno[2,3-d]pyrimidine-4-amine": "CNc1ncnc2sccc12",
    "2-methylaminobiphenylene": "CNc1ccc2c(c1)c1ccccc12",
    "2-methylaminopteridinone": "CNc1nc2nccnc2c(=O)[nH]1",
    "4-anilinocoumarin": "O=c1cc(Nc2ccccc2)c2ccccc2o1",
}


def read(block: str, folder: Path) -> Any:
    path = folder / "drawn.sdf"
    path.write_text(block + "$$$$\n")
    return pliant.read(path)


def what_is_held(structure: Any) -> tuple[Any, ...]:
    """Bars across angles and planar groups; bonds that turn; bars of each edge in a count."""
    framework = structure.framework("angles")
    counted = pliant.rigidity(structure, contacts=np.empty(0, pliant.contacts(structure).dtype))
    return (
        framework.bars.tolist(),
        structure.aromatic_bonds.tolist(),
        counted.edge_bars.tolist(),
        counted.degrees_of_freedom,
    )


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("name", DRUG_LIKE)
def test_every_drawing_has_the_same_rotors(name: str, tmp_path: Path) -> None:
    blocks = set(drawings(embedded(DRUG_LIKE[name])))
    held = [what_is_held(read(block, tmp_path)) for block in blocks]
    assert all(one == held[0] for one in held)


def test_most_molecules_have_several_drawings() -> None:
    counts = [len(set(drawings(embedded(smiles)))) for smiles in DRUG_LIKE.values()]
    assert len(counts) >= 30
    assert sum(count > 2 for count in counts) >= 20  # others have one Kekule form


# RDKit's rule looks at the ring of sixteen of porphine too, and takes rings of three of phosphorus.
DIFFERENT = {"porphine", "white-phosphorus"}


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")  # all is in one plane
def test_aromatic_bonds_of_many_molecules_are_those_of_rdkit(tmp_path: Path) -> None:
    different = set()
    lines = [line.split() for line in SMILES.read_text().splitlines() if line.strip()]
    for smiles, name in (line[:2] for line in lines if not line[0].startswith("#")):
        made = Chem.MolFromSmiles(smiles)
        flat = Chem.AddHs(made)
        AllChem.Compute2DCoords(flat)
        kekule = Chem.Mol(flat)
        Chem.Kekulize(kekule, clearAromaticFlags=True)
        structure = read(Chem.MolToMolBlock(kekule), tmp_path)
        found = {tuple(pair) for pair in structure.bonds[structure.aromatic_bonds].tolist()}
        wanted = {
            tuple(sorted((bond.GetBeginAtomIdx(), bond.GetEndAtomIdx())))
            for bond in flat.GetBonds()
            if bond.GetIsAromatic()
        }
        if found != wanted:
            different.add(name)
    assert different == DIFFERENT


def test_nothing_is_aromatic_where_orders_are_not_known() -> None:
    made = pliant.Structure(
        1.39 * np.array([[np.cos(a), np.sin(a), 0.0] for a in np.arange(6) * np.pi / 3]),
        elements=[6] * 6,
        bonds=[[k, (k + 1) % 6] for k in range(6)],
    )
    assert not made.aromatic_bonds.any()
