# SPDX-License-Identifier: MIT
"""Ligands and modified residues under a force field: their chemistry, and GAFF2 by AmberTools."""
