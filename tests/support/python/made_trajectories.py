# SPDX-License-Identifier: MIT
"""Trajectories for tests of the Python package, written by h5py as `pliant run` lays them out,
and a complex: a bundle of helices with aspirin beside it, where most atoms are near."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

import pliant

ELEMENTS = {"H": (1, 1.008), "C": (6, 12.011), "N": (7, 14.007), "O": (8, 15.999)}


@dataclass
class Made:
    """What goes into a file; change it, then write it."""

    positions: np.ndarray  #: (F, N, 3) Angstrom
    bars: np.ndarray
    rest_lengths: np.ndarray
    bonds: np.ndarray
    elements: list
    tolerance: float = 1e-6
    tolerance_length: float = 0.0
    kind_of_bars: str = "bonds"
    pinned: tuple = ()
    converged: np.ndarray | None = None
    max_residual: np.ndarray | None = None  #: recorded; default: what it is
    names: list = field(default_factory=list)
    residues: list = field(default_factory=list)  #: (name, number) of each atom

    @property
    def masses(self):
        return np.array([ELEMENTS[e][1] for e in self.elements])

    def residual(self):
        ends = self.positions[:, self.bars]
        length = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=-1)
        return np.abs(length / self.rest_lengths - 1).max(axis=1, initial=0.0)

    def write(self, path, dtype="f8"):
        with h5py.File(path, "w") as file:
            self._write_particles(file, dtype)
            self._write_framework(file)
            self._write_topology(file)
            self._write_options(file)
        return path

    def _write_particles(self, file, dtype):
        count = len(self.positions)
        group = file.create_group("particles/trajectory")
        box = group.create_group("box")
        box.attrs["dimension"] = 3
        box.attrs["boundary"] = ["none", "none", "none"]
        position = group.create_group("position")
        position.create_dataset("value", data=self.positions.astype(dtype))
        position["value"].attrs["unit"] = "Angstrom"
        position.create_dataset("time", data=np.arange(count) * 0.01)
        position["time"].attrs["unit"] = "ps"
        position.create_dataset("step", data=np.arange(count))
        group.create_dataset("mass", data=self.masses)
        group.create_dataset("species", data=[ELEMENTS[e][0] for e in self.elements])
        converged = np.ones(count, bool) if self.converged is None else self.converged
        residual = self.residual() if self.max_residual is None else self.max_residual
        for name, values in (("converged", converged), ("max_residual", residual)):
            element = file.create_group(f"observables/{name}")
            element["value"] = values
            element["step"] = position["step"]
            element["time"] = position["time"]

    def _write_framework(self, file):
        file.create_dataset("connectivity/bars", data=np.asarray(self.bars, "i4").reshape(-1, 2))
        file.create_dataset("connectivity/bonds", data=np.asarray(self.bonds, "i4").reshape(-1, 2))
        for name in ("bars", "bonds"):
            reference = file["particles/trajectory"].ref
            file[f"connectivity/{name}"].attrs["particles_group"] = reference
        group = file.create_group("parameters/framework")
        group["rest_length"] = np.asarray(self.rest_lengths, "f8")
        group["pinned"] = np.isin(np.arange(len(self.elements)), self.pinned)

    def _write_topology(self, file):
        group = file.create_group("parameters/topology")
        names = self.names or [f"{e}{k + 1}" for k, e in enumerate(self.elements)]
        residues = self.residues or [("UNK", 1)] * len(names)
        starts = [k for k in range(len(names)) if k == 0 or residues[k] != residues[k - 1]]
        text = h5py.string_dtype("utf-8")
        group.create_dataset("atom_name", data=names, dtype=text)
        group.create_dataset("element", data=self.elements, dtype=text)
        group["atomic_number"] = [ELEMENTS[e][0] for e in self.elements]
        group["atom_serial"] = np.arange(1, len(names) + 1)
        group["residue_of"] = np.searchsorted(starts, np.arange(len(names)), side="right") - 1
        group.create_dataset("residue_name", data=[residues[k][0] for k in starts], dtype=text)
        group["residue_number"] = [residues[k][1] for k in starts]
        group.create_dataset("insertion_code", data=[""] * len(starts), dtype=text)
        group.create_dataset("chain", data=[""] * len(starts), dtype=text)
        group["bond_origin"] = np.zeros(len(self.bonds), "u1")
        group["bond_order"] = np.zeros(len(self.bonds), "u1")

    def _write_options(self, file):
        run = file.create_group("parameters/run")
        run["tolerance"] = self.tolerance
        run["tolerance_length"] = self.tolerance_length
        file["parameters/input/bars"] = self.kind_of_bars


def with_angles(bonds, count):
    """The bonds, and a bar for each two bonds that share an atom."""
    around = [[] for _ in range(count)]
    for a, b in bonds:
        around[a].append(b)
        around[b].append(a)
    pairs = {(min(p), max(p)) for p in bonds}
    pairs |= {(min(p, q), max(p, q)) for near in around for p in near for q in near if p != q}
    return np.array(sorted(pairs))


def conformer(smiles):
    """Elements, bonds and relaxed positions (N, 3) of a molecule, by RDKit."""
    from rdkit import Chem
    from rdkit.Chem import AllChem

    molecule = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMolecule(molecule, randomSeed=1)
    AllChem.MMFFOptimizeMolecule(molecule)
    bonds = [(b.GetBeginAtomIdx(), b.GetEndAtomIdx()) for b in molecule.GetBonds()]
    elements = [atom.GetSymbol() for atom in molecule.GetAtoms()]
    return elements, bonds, molecule.GetConformer().GetPositions()


def moved(framework, start, frames, tolerance=1e-6, seed=0, displacement=0.1):
    """(frames, N, 3): a run in which every joint is displaced, resolved and shown."""
    shown, start = [], start.copy()
    pliant.resolve(framework, start, tolerance=tolerance / 2)
    pliant.run(
        framework,
        start,
        steps=frames - 1,
        perturb="displacement",
        displacement=displacement,
        tolerance=tolerance,
        seed=seed,
        observers=[lambda frame: shown.append(np.array(frame.positions))],
    )
    return np.array(shown)


def molecule_run(smiles, frames=12, kind_of_bars="bonds", tolerance=1e-6, pinned=(), **options):
    """A trajectory of a molecule whose bars have the lengths of its relaxed geometry."""
    elements, bonds, start = conformer(smiles)
    bars = np.array(bonds)
    if kind_of_bars == "angles":
        bars = with_angles(bonds, len(elements))
    ends = start[bars]
    rest = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
    framework = pliant.Framework(bars, rest, len(elements), pinned=np.array(pinned, int))
    positions = moved(framework, start, frames, tolerance, **options)
    measured = positions, bars, rest, np.array(bonds), elements, tolerance
    return Made(*measured, kind_of_bars=kind_of_bars, pinned=pinned)


DATA = Path(__file__).parents[3] / "data"
LIGAND = "resname AIN"
#: Angstrom, of the drug's middle: of a grid where no atoms are within 2.9, most pairs within 4.5
PLACE = (9.908, 6.679, -19.477)


def ligand_complex():
    """The structure of both."""
    protein = pliant.build_model(DATA / "proteins" / "three_helices.pdb").structure
    drug = pliant.read(DATA / "molecules" / "aspirin.sdf")
    count = len(protein)
    x = np.concatenate([protein.positions, drug.positions - drug.positions.mean(axis=0) + PLACE])
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
