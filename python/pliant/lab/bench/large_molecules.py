# SPDX-License-Identifier: MIT
"""Molecules of any size with real geometry: one long peptide chain, and copies of one molecule.

The chain is polyalanine with all hydrogens, in turns a helix of twelve residues and a strand of
four. That repeats itself along a screw, so that no part comes near another, and helices have their
hydrogen bonds. Bond lengths and angles: Engh and Huber, Acta Cryst. A47 (1991) 392.
"""

from __future__ import annotations

import math

import numpy as np

import pliant

HELIX, STRAND = (-57.0, -47.0), (-120.0, 130.0)  #: phi and psi, degrees
PATTERN = (HELIX,) * 12 + (STRAND,) * 4
ATOMS = ("N", "H", "CA", "HA", "C", "O", "CB", "HB1", "HB2", "HB3")
ELEMENTS = (7, 1, 6, 1, 6, 8, 6, 1, 1, 1)
BONDS = ((0, 1), (0, 2), (2, 3), (2, 4), (4, 5), (2, 6), (6, 7), (6, 8), (6, 9))
ORDERS = (1, 1, 1, 1, 2, 1, 1, 1, 1)
APART = 10.0  #: Angstrom between copies


def _turn(length: float, angle: float, torsion: np.ndarray) -> np.ndarray:
    """(R, 4, 4): from the frame of an atom, x along the bond to it, to that of the next."""
    tau, bend = np.radians(torsion), math.pi - math.radians(angle)
    c, s, one, none = np.cos(tau), np.sin(tau), np.ones_like(tau), np.zeros_like(tau)
    cb, sb = math.cos(bend) * one, math.sin(bend) * one
    rows = [
        [cb, -sb, none, length * cb],
        [c * sb, c * cb, -s, length * c * sb],
        [s * sb, s * cb, c, length * s * sb],
        [none, none, none, one],
    ]
    found: np.ndarray = np.moveaxis(np.array(rows), -1, 0)
    return found


def _products(steps: np.ndarray) -> np.ndarray:
    """(R, 4, 4): step 0, steps 0 and 1, ...: doubling, so that a million take no loop over them."""
    found: np.ndarray = steps.copy()
    reach = 1
    while reach < len(found):
        found[reach:] = found[:-reach] @ found[reach:]
        reach *= 2
    return found


def _unit(vectors: np.ndarray) -> np.ndarray:
    found: np.ndarray = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return found


def _opposite(at: np.ndarray, *others: np.ndarray, length: float) -> np.ndarray:
    """The atom on the far side of an atom's other neighbours."""
    away = np.sum([_unit(other - at) for other in others], axis=0)
    found: np.ndarray = at - length * _unit(away)
    return found


def _backbone(residues: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """N, CA and C; N has one more, where the next residue would begin."""
    phi, psi = np.array(PATTERN)[np.arange(residues) % len(PATTERN)].T
    alpha = _turn(1.458, 121.7, np.full(residues, 180.0))
    carbonyl = alpha @ _turn(1.525, 111.0, phi)
    ends = _products(carbonyl @ _turn(1.329, 117.2, psi))
    starts = np.concatenate([np.eye(4)[None], ends])
    places = [starts[:-1] @ alpha, starts[:-1] @ carbonyl]
    return starts[:, :3, 3], places[0][:, :3, 3], places[1][:, :3, 3]


def _methyl(cb: np.ndarray, ca: np.ndarray, n: np.ndarray) -> list[np.ndarray]:
    """Three hydrogens on CB, staggered to what is bonded to CA."""
    axis = _unit(cb - ca)
    across = _unit(np.cross(axis, n - ca))
    up = np.cross(across, axis)
    tilt = math.radians(180.0 - 109.5)
    out = math.cos(tilt) * axis
    return [
        cb + 1.09 * (out + math.sin(tilt) * (math.cos(turn) * up + math.sin(turn) * across))
        for turn in np.radians([60.0, 180.0, 300.0])
    ]


def peptide_positions(residues: int) -> np.ndarray:
    """(residues * 10, 3) Angstrom, in the order of ATOMS."""
    n, ca, c = _backbone(residues)
    n, following = n[:-1], n[1:]
    before = np.concatenate([[n[0] - [1.329, 0.0, 0.0]], c[:-1]])
    b, d = ca - n, c - ca
    # Of the ideal L amino acid: its CB from N, CA and C.
    cb = ca - 0.58273431 * np.cross(b, d) + 0.56802827 * b - 0.54067466 * d
    h = _opposite(n, before, ca, length=1.01)
    ha = _opposite(ca, n, c, cb, length=1.09)
    o = _opposite(c, ca, following, length=1.231)
    atoms = [n, h, ca, ha, c, o, cb, *_methyl(cb, ca, n)]
    return np.stack(atoms, axis=1).reshape(-1, 3)


def peptide(count: int) -> pliant.Structure:
    """A chain of about `count` atoms."""
    residues = max(2, round(count / len(ATOMS)))
    shift = len(ATOMS) * np.arange(residues)
    own = (np.array(BONDS)[None] + shift[:, None, None]).reshape(-1, 2)
    links = np.column_stack([shift[:-1] + ATOMS.index("C"), shift[1:] + ATOMS.index("N")])
    orders = np.concatenate([np.tile(ORDERS, residues), np.ones(residues - 1, dtype=int)])
    return pliant.Structure(
        peptide_positions(residues),
        elements=np.tile(ELEMENTS, residues),
        names=list(ATOMS) * residues,
        residue_names=["ALA"] * (residues * len(ATOMS)),
        residue_ids=np.repeat(np.arange(1, residues + 1), len(ATOMS)),
        chains=["A"] * (residues * len(ATOMS)),
        bonds=np.concatenate([own, links]),
        bond_orders=orders,
        title=f"polyalanine, {residues} residues",
    )


def copies(molecule: pliant.Structure, count: int) -> pliant.Structure:
    """Copies of a molecule side by side in a cube, about `count` atoms in all."""
    atoms = len(molecule)
    times = max(1, round(count / atoms))
    side = math.ceil(times ** (1 / 3) - 1e-9)
    number = np.arange(times)
    cell = np.column_stack([number % side, number // side % side, number // side**2])
    x = molecule.positions - molecule.positions.mean(axis=0)
    spacing = np.ptp(x, axis=0) + APART
    bonds = molecule.bonds[None].astype(np.int64) + atoms * number[:, None, None]
    residues = int(molecule.residue_ids.max()) - int(molecule.residue_ids.min()) + 1
    return pliant.Structure(
        (x[None] + (cell * spacing)[:, None]).reshape(-1, 3),
        elements=np.tile(molecule.elements, times),
        names=np.tile(molecule.names, times).tolist(),
        residue_names=np.tile(molecule.residue_names, times).tolist(),
        residue_ids=(molecule.residue_ids[None] + residues * number[:, None]).reshape(-1),
        chains=np.repeat([f"{k}" for k in range(times)], atoms).tolist(),
        bonds=bonds.reshape(-1, 2),
        bond_orders=np.tile(molecule.bond_orders, times),
        title=f"{times} copies of {molecule.title}",
    )


def many_peptides(count: int) -> pliant.Structure:
    """Copies of a peptide of 20 residues."""
    return copies(peptide(200), count)
