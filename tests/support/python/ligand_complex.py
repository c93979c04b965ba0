# SPDX-License-Identifier: MIT
"""A bundle of helices with aspirin beside it, where most atoms are near and none overlaps."""

from pathlib import Path

import numpy as np

import pliant

DATA = Path(__file__).parents[3] / "data"
LIGAND = "resname AIN"
NEAR, LEAST = 4.5, 2.9  #: Angstrom


def ligand_complex():
    """The structure of both."""
    protein = pliant.build_model(DATA / "proteins" / "three_helices.pdb").structure
    drug = pliant.read(DATA / "molecules" / "aspirin.sdf")
    count = len(protein)
    x = np.concatenate([protein.positions, drug.positions + _place(protein, drug)])
    names = [f"{s}{k + 1}" for k, s in enumerate(drug.symbols)]
    return pliant.Structure(
        x,
        elements=np.concatenate([protein.elements, drug.elements]),
        names=[*protein.names, *names],
        residue_names=[*protein.residue_names, *["AIN"] * len(drug)],
        residue_ids=np.concatenate([protein.residue_ids, np.full(len(drug), 900)]),
        chains=[*protein.chains, *["L"] * len(drug)],
        bonds=np.concatenate([protein.bonds, drug.bonds + count]),
        bond_orders=np.concatenate([protein.bond_orders, drug.bond_orders]),
    )


def _place(protein, drug):
    """A shift, of a grid of 1 Angstrom around the protein."""
    middle = drug.positions.mean(axis=0)
    low, high = protein.positions.min(axis=0) - 4, protein.positions.max(axis=0) + 4
    grid = np.stack(np.meshgrid(*map(np.arange, low, high), indexing="ij"), axis=-1)
    best, most = None, -1
    for place in grid.reshape(-1, 3):
        moved = drug.positions - middle + place
        apart = np.linalg.norm(moved[:, None] - protein.positions, axis=2)
        near = np.count_nonzero(apart < NEAR)
        if apart.min() > LEAST and near > most:
            best, most = place - middle, near
    assert best is not None
    return best
