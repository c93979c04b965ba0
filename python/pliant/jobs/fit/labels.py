# SPDX-License-Identifier: MIT
"""Kinds of distances, and where labels are: by the frames of residues, which alpha carbons span."""

from __future__ import annotations

import numpy as np

from pliant._core import InputError, Structure, accessible_volume, outward_places, select_atoms

#: longest distance between alpha carbons that a reagent spans, Angstrom: E. Merkley et al., Protein
#: Sci. 23 (2014) 747; of diazirines (SDA) A. Belsom et al., Mol. Cell. Proteomics 15 (2016) 1105
REAGENTS = {"DSS": 30.0, "BS3": 30.0, "DSSO": 30.0, "DSBU": 30.0, "SDA": 25.0, "EDC": 20.0}
#: how far a label's mean position is from the alpha carbon, towards the beta carbon, Angstrom:
#: of rotamers of MTSL (chiLife's R1M, 70 sites of three proteins; where a label is differs from
#: that by 3.7 Angstrom along any line)
LABELS = {"MTSL": 4.1}
#: dyes, whose mean positions are those of their accessible volumes in START
DYES = ("FRET",)

BETA = 1.53  #: Angstrom from an alpha to a beta carbon
BACKBONE = ("N", "CA", "C", "O")
#: van der Waals radii of heavy atoms (A. Bondi, J. Phys. Chem. 68 (1964) 441), Angstrom
RADII = {6: 1.7, 7: 1.55, 8: 1.52}
OTHER_RADIUS = 1.8


def places(nodes: np.ndarray, at: np.ndarray, local: np.ndarray) -> np.ndarray:
    """(..., K, 3) points beside nodes ``at`` (K) of (..., M, 3), at `local` (K, 3): a, b, c as
    ``outward_places`` gives them; 0 is at the node."""
    here = nodes[..., at, :]
    if not local.any():
        return np.asarray(here)
    u, v = _neighbours(nodes, at)
    a, b, c = local.T[:, :, None]
    return np.asarray(here + a * u + b * v + c * np.cross(u, v))


def local_of(nodes: np.ndarray, node: int, point: np.ndarray) -> np.ndarray:
    """(3,) where a point is beside a node of (M, 3), as `places` takes it."""
    u, v = _neighbours(nodes, np.array([node]))
    frame = np.concatenate([u, v, np.cross(u, v)]).T
    return np.asarray(np.linalg.solve(frame, point - nodes[node]))


def _neighbours(nodes: np.ndarray, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    here = nodes[..., at, :]
    after = nodes[..., np.minimum(at + 1, nodes.shape[-2] - 1), :]
    return after - here, nodes[..., np.maximum(at - 1, 0), :] - here


class Labels:
    """Where labels of the residues of a structure are, each residue at one of the atoms (M)."""

    def __init__(self, structure: Structure, atoms: np.ndarray) -> None:
        self.structure = structure
        self.atoms = atoms
        self.nodes = np.asarray(structure.positions)[atoms]
        self.outward = outward_places(structure)
        residues = np.asarray(structure.residue_of)[atoms].tolist()
        self.node_of = {int(residue): node for node, residue in enumerate(residues)}

    def has_frame(self, node: int) -> bool:
        """Whether places beside a node move with it: not at ends of chains, not of nucleotides."""
        return bool(self.outward[node].any())

    def beta(self, node: int) -> np.ndarray:
        """(3,) where the beta carbon is, or would be."""
        return np.asarray(places(self.nodes, np.array([node]), BETA * self.outward[[node]])[0])

    def place(self, kind: str, node: int) -> np.ndarray:
        """(3,) of a label, as `places` takes it; 0 where the kind has none.

        Raises InputError: what residue was expected.
        """
        if kind not in LABELS and kind not in DYES:
            return np.zeros(3)
        if not self.has_frame(node):
            raise InputError("an amino acid that is not the end of a chain, for a label")
        return self._dye(node) if kind in DYES else np.asarray(LABELS[kind] * self.outward[node])

    def _dye(self, node: int) -> np.ndarray:
        """The mean of the accessible volume, without the side chain that carries the dye."""
        structure, alpha = self.structure, self.atoms[node]
        around = select_atoms(structure, "not water and not element H")
        own = np.asarray(structure.residue_of)[around] == structure.residue_of[alpha]
        around = around[~own | np.isin(structure.names[around], BACKBONE)]
        radii = [RADII.get(int(element), OTHER_RADIUS) for element in structure.elements[around]]
        volume = accessible_volume(structure.positions[around], radii, self.beta(node))
        if not len(volume):
            raise InputError("a residue that leaves room for a dye in START")
        return local_of(self.nodes, node, volume.mean(axis=0))
