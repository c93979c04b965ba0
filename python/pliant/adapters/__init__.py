# SPDX-License-Identifier: MIT
"""Converts structures from and to other packages, imported only when an adapter is called."""

from pliant.adapters.mdanalysis import from_mdanalysis, to_mdanalysis
from pliant.adapters.mdtraj import from_mdtraj, mdtraj_frames, to_mdtraj
from pliant.adapters.openmm import constraints_from_openmm, from_openmm, to_openmm
from pliant.adapters.prody import from_prody, prody_frames, to_prody
from pliant.adapters.rdkit import from_rdkit, rdkit_frames, to_rdkit
from pliant.adapters.smiles import from_smiles

__all__ = [
    "constraints_from_openmm",
    "from_mdanalysis",
    "from_mdtraj",
    "from_openmm",
    "from_prody",
    "from_rdkit",
    "from_smiles",
    "mdtraj_frames",
    "prody_frames",
    "rdkit_frames",
    "to_mdanalysis",
    "to_mdtraj",
    "to_openmm",
    "to_prody",
    "to_rdkit",
]
