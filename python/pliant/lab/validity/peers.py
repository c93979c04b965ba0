# SPDX-License-Identifier: MIT
"""Elastic networks of alpha carbons as peers: fluctuations, modes, and frames of all atoms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from pliant._core import Structure, network_modes
from pliant.lab.structures import Trace

SHARED_MODES = 60  #: as many as frames are drawn from
DRAWN_MODES = 60  #: of a peer's frames: the stiffest modes would tear them worse
ALL_TO = 300  #: residues: ANM of more has its MANY lowest modes, all would take minutes
MANY = 100
GNM_CUTOFF = 10.0  #: Angstrom
TURNS_WITH = 8.0  #: Angstrom: neighbours that the atoms of a residue turn with


@dataclass(frozen=True)
class Network:
    """Modes of one network about a structure of N residues."""

    variances: np.ndarray  #: (K,) in the network's own unit, descending
    directions: np.ndarray  #: (K, N, 3), each mode of unit length over all residues

    @property
    def fluctuations(self) -> np.ndarray:
        """RMSF (N,) of the Gaussian of all modes, in a unit of its own."""
        squares = np.einsum("k,kni->n", self.variances, self.directions**2)
        rmsf: np.ndarray = np.sqrt(squares)
        return rmsf

    def superposed(self, atoms: np.ndarray, positions: np.ndarray) -> Network:
        """The same motion seen on `atoms` (M,) alone, at positions (M, 3), superposed on them.

        Superposing takes out of each mode, to first order, what moves these atoms as one body.
        """
        arms = positions - positions.mean(axis=0)
        turns = [np.cross(axis, arms).ravel() for axis in np.eye(3)]
        shifts = [np.broadcast_to(axis, arms.shape).ravel() for axis in np.eye(3)]
        rigid = np.linalg.qr(np.array(turns + shifts).T)[0]
        part = self.directions[:, atoms].reshape(len(self.variances), -1)
        part = part - (part @ rigid) @ rigid.T
        return Network(self.variances, part.reshape(-1, len(atoms), 3))


def network_of(structure: Structure, trace: Trace, name: str) -> Network:
    """Modes of a row of ``networks()``: all, of ``shared`` 60, of ANM 100 above 300 residues.

    A structure of amino acids has a node at each alpha carbon; of more than 1000 several share one.
    """
    residues = len(trace.sequence)
    many = 3 * residues if residues <= ALL_TO else MANY
    count = {"shared": SHARED_MODES, "anm": many}.get(name, 3 * residues)
    variances, directions, nodes = network_modes(structure, name, count)
    nearest = cKDTree(nodes).query(trace.positions)[1]
    return Network(variances, directions[:, nearest])


def gnm_fluctuations(positions: np.ndarray) -> np.ndarray:
    """RMSF (N,) of the Gaussian network model of nodes (N, 3), all modes, cut off at 10 Angstrom.

    By NumPy alone, and without merging nodes.
    """
    kirchhoff = np.zeros((len(positions),) * 2)
    pairs = cKDTree(positions).query_pairs(GNM_CUTOFF, output_type="ndarray")
    kirchhoff[pairs[:, 0], pairs[:, 1]] = kirchhoff[pairs[:, 1], pairs[:, 0]] = -1.0
    np.fill_diagonal(kirchhoff, -kirchhoff.sum(axis=1))
    return np.asarray(np.sqrt(np.diag(np.linalg.pinv(kirchhoff, hermitian=True))))


def drawn_frames(
    network: Network, trace: Trace, atoms: np.ndarray, owner: np.ndarray, frames: int, rmsf: float
) -> np.ndarray:
    """Frames (F, M, 3) of all atoms (M, 3), drawn from a network's Gaussian of that mean RMSF.

    An atom goes with its residue `owner` (M,) and turns with the residues within 8 Angstrom, as
    displacements of networks are usually extended to all atoms; 60 modes. Nothing holds atoms.
    """
    network = Network(network.variances[:DRAWN_MODES], network.directions[:DRAWN_MODES])
    amplitudes = np.random.default_rng(0).standard_normal((frames, len(network.variances)))
    amplitudes *= np.sqrt(network.variances) * rmsf / network.fluctuations.mean()
    moved = np.einsum("fk,kni->fni", amplitudes, network.directions)
    turns = _turns(trace.positions, moved)
    arms = atoms - trace.positions[owner]
    drawn: np.ndarray = atoms + moved[:, owner] + np.cross(turns[:, owner], arms)
    return drawn


def _turns(positions: np.ndarray, moved: np.ndarray) -> np.ndarray:
    """Turns (F, N, 3), radians, of the surroundings of each residue, by least squares."""
    turns = np.zeros_like(moved)
    for i, centre in enumerate(positions):
        arms = positions - centre
        near = np.flatnonzero(np.linalg.norm(arms, axis=1) < TURNS_WITH)
        arms = arms[near]
        inertia = (arms**2).sum() * np.eye(3) - arms.T @ arms
        torque = np.cross(arms, moved[:, near] - moved[:, i : i + 1]).sum(axis=1)
        turns[:, i] = torque @ np.linalg.pinv(inertia)
    return turns
