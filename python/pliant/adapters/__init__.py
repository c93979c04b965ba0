# SPDX-License-Identifier: MIT
"""Converts structures from and to other packages, imported only when an adapter is called."""

from pliant.adapters.mdanalysis import from_mdanalysis, to_mdanalysis
from pliant.adapters.openmm import constraints_from_openmm, from_openmm
from pliant.adapters.rdkit import from_rdkit
from pliant.adapters.smiles import from_smiles

__all__ = [
    "constraints_from_openmm",
    "from_mdanalysis",
    "from_openmm",
    "from_rdkit",
    "from_smiles",
    "to_mdanalysis",
]
