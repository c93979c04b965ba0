# SPDX-License-Identifier: MIT
"""``pliant path``: a way from one structure to another, each frame whole (targeted FRODA).

At each step the other structure is superposed on the molecule, whose residues are asked to go
towards it by a fixed r.m.s. distance; technique ``froda`` then makes bars whole, keeps atoms apart
and holds the contacts that both structures have. Those of one alone are let go (targeting: S. Wells
et al., Phys. Biol. 2 (2005) S127; D. W. Farrell, K. Speranskiy, M. F. Thorpe, Proteins 78 (2010)
2908).
"""

from pliant.path.found import MolecularPath, PathFrame
from pliant.path.walk import find_path

__all__ = ["MolecularPath", "PathFrame", "find_path"]
