# SPDX-License-Identifier: MIT
"""Molecules that turn about their bonds, written as pliant run writes them."""

import sys
from pathlib import Path

import h5py
import numpy as np
import pytest
from forked import DOT, save_dot, save_figures_by
from pliant.base.png import save_png

sys.path.insert(0, str(Path(__file__).parent))  # so that tests can import what lies beside them
from turned_molecule import SYMBOLS, Molecule, rotated

STOPS = {"converged": 0, "max_sweeps": 1, "not_finite": 2, "stopped_by_caller": 3}
MASSES = {1: 1.008, 6: 12.011, 7: 14.007, 8: 15.999, 16: 32.06}


def zigzag(n):
    """n carbons in an all-trans chain, 1.54 Angstrom apart, angles 111 degrees."""
    half = np.radians(111 / 2)
    k = np.arange(n)
    return np.stack([1.54 * np.sin(half) * k, 1.54 * np.cos(half) * (k % 2), 0.0 * k], axis=1)


@pytest.fixture
def no_drawing(monkeypatch):
    """Reports with dots for figures, for tests of all else."""

    def no_picture(picture, found, path, dpi):
        path.write_bytes(DOT)

    monkeypatch.setattr("pliant.report.figures.draw_in_parallel.save_picture", no_picture)


@pytest.fixture(scope="session", autouse=True)
def unrendered_figures():
    """All figures of reports, but those of tests that ask for `rendered`."""
    before = save_figures_by(save_dot)
    yield
    save_figures_by(before)


@pytest.fixture
def rendered():
    """Figures as users have them."""
    before = save_figures_by(save_png)
    yield
    save_figures_by(before)


@pytest.fixture
def pentane():
    """Five carbons in a chain: two rotatable bonds, 1-2 and 2-3."""
    return Molecule([6] * 5, [(0, 1), (1, 2), (2, 3), (3, 4)], zigzag(5))


@pytest.fixture
def peptide():
    """Four alanines without hydrogens, built from internal coordinates."""
    names, elements, bonds, residues, atoms = [], [], [], [], []
    for k in range(4):
        first = len(names)
        names += ["N", "CA", "C", "O", "CB"]
        elements += [7, 6, 6, 8, 6]
        bonds += [(first, first + 1), (first + 1, first + 2), (first + 2, first + 3)]
        bonds += [(first + 1, first + 4)]
        if k:
            bonds.append((first - 3, first))
            n = placed(*(atoms[first - 5 + i] for i in (0, 1, 2)), 1.33, 117, 140)
        else:
            n = np.zeros(3)
        atoms += _alanine(n, atoms[-4:-2] if k else None)
        residues.append(("ALA", k + 1, "A", range(first, first + 5)))
    molecule = Molecule(elements, bonds, atoms, names, residues)
    molecule.rotatable = [(a, b) for a, b in bonds if names[b] not in ("O", "CB")]
    return molecule


def _alanine(n, before):
    """N, CA, C, O, CB; `before` are CA and C of the residue before."""
    if before is None:
        ca, c = np.array([1.46, 0, 0]), np.array([2.0, 1.43, 0])
    else:
        ca = placed(*before, n, 1.46, 122, 180)
        c = placed(before[1], n, ca, 1.53, 111, -70)
    return [n, ca, c, placed(n, ca, c, 1.23, 120, -40), placed(c, n, ca, 1.53, 110, 120)]


def placed(a, b, c, length, angle, torsion):
    """A point at `length` from c, with angle b-c-point and torsion a-b-c-point (degrees)."""
    angle, torsion = np.radians(angle), np.radians(torsion)
    along = (c - b) / np.linalg.norm(c - b)
    normal = np.cross(b - a, along)
    normal /= np.linalg.norm(normal)
    local = [-np.cos(angle), np.sin(angle) * np.cos(torsion), np.sin(angle) * np.sin(torsion)]
    return c + length * np.array(local) @ np.array([along, np.cross(normal, along), normal])


@pytest.fixture
def wander():
    """Function (molecule, turns, frames, seed) -> (F, N, 3): random turns about the bonds."""

    def make(molecule, bonds, frames, seed=1, degrees=30.0):
        random = np.random.default_rng(seed)
        positions = molecule.positions.copy()
        trajectory = [positions.copy()]
        for _ in range(frames - 1):
            j, k = bonds[random.integers(len(bonds))]
            positions = molecule.turned(positions, j, k, degrees * random.standard_normal())
            turn, shift = random.standard_normal(3), random.standard_normal(3)
            positions = rotated(positions, turn, 5.0) + 0.1 * shift
            trajectory.append(positions.copy())
        return np.array(trajectory)

    return make


@pytest.fixture
def write_run():
    """Function that writes an H5MD file as pliant run does; see `write`."""
    return write


@pytest.fixture
def analysis(tmp_path, peptide, wander, write_run):
    """Of a dozen frames of the peptide."""
    from pliant.measure.stages.analysis import AnalysisOptions
    from pliant.report.sections.table import analyse_trajectory

    trajectory = wander(peptide, peptide.rotatable, 12, degrees=25.0)
    run = write_run(tmp_path / "run.h5md", peptide, trajectory)
    return analyse_trajectory(AnalysisOptions(str(run)))


def write(path, molecule, trajectory, *, tolerance=1e-6, converged=None, single=False, bars=True):
    """Writes the file. Observables are what a run would have measured."""
    trajectory = np.asarray(trajectory)
    frames = len(trajectory)
    with h5py.File(path, "w", libver=("earliest", "v108")) as file:
        file.create_group("h5md").attrs["version"] = np.array([1, 1], dtype=np.int32)
        creator = file.create_group("h5md/creator")
        creator.attrs["name"], creator.attrs["version"] = "pliant", "0.1.0"
        box = file.create_group("particles/trajectory/box")
        box.attrs["dimension"] = np.int32(3)
        box.attrs["boundary"] = ["none", "none", "none"]
        position = file.create_group("particles/trajectory/position")
        dtype = np.float32 if single else np.float64
        position.create_dataset("value", data=trajectory.astype(dtype)).attrs["unit"] = "Angstrom"
        position.create_dataset("time", data=0.001 * np.arange(frames)).attrs["unit"] = "ps"
        position.create_dataset("step", data=10 * np.arange(frames))
        _write_observables(file, molecule, trajectory, converged)
        if bars:
            file["connectivity/bars"] = molecule.bonds.astype(np.uint32)
            file["parameters/framework/rest_length"] = molecule.rest_lengths
        file["connectivity/bonds"] = molecule.bonds.astype(np.uint32)
        _write_topology(file, molecule)
        for name, value in {
            "tolerance": tolerance,
            "technique": "bfs_cycle",
            "weighting": 0.5,
        }.items():
            file[f"parameters/run/{name}"] = value
    return path


def _write_observables(file, molecule, trajectory, converged):
    ends = trajectory[:, molecule.bonds]
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    relative = np.abs(lengths / molecule.rest_lengths - 1)
    frames = len(trajectory)
    flags = np.ones(frames, dtype=bool) if converged is None else np.asarray(converged)
    truth = h5py.enum_dtype({"FALSE": 0, "TRUE": 1}, np.int8)
    columns = {
        "sweeps": 5 + np.arange(frames) % 3,
        "projections": (5 + np.arange(frames) % 3) * len(molecule.bonds),
        "max_residual": relative.max(axis=1),
        "rms_residual": np.sqrt((relative**2).mean(axis=1)),
        "root_joint": np.zeros(frames, dtype=np.int64),
    }
    for name, values in columns.items():
        file[f"observables/{name}/value"] = values
    file.create_dataset("observables/converged/value", data=flags.astype(np.int8), dtype=truth)
    stops = np.where(flags, STOPS["converged"], STOPS["max_sweeps"]).astype(np.uint8)
    file.create_dataset(
        "observables/stop/value", data=stops, dtype=h5py.enum_dtype(STOPS, np.uint8)
    )
    for name in file["observables"]:
        for part in ("time", "step"):
            file[f"observables/{name}/{part}"] = file[f"particles/trajectory/position/{part}"]


def _write_topology(file, molecule):
    group = file.create_group("parameters/topology")
    group["atom_name"] = np.array(molecule.names, dtype="S4")
    group["atomic_number"] = molecule.elements.astype(np.uint8)
    group["element"] = np.array([SYMBOLS[element] for element in molecule.elements], dtype="S2")
    group["atom_serial"] = np.arange(1, len(molecule.elements) + 1)
    residue_of = np.zeros(len(molecule.elements), dtype=np.uint32)
    for k, (*_, atoms) in enumerate(molecule.residues):
        residue_of[list(atoms)] = k
    group["residue_of"] = residue_of
    group["residue_name"] = np.array([r[0] for r in molecule.residues], dtype="S4")
    group["residue_number"] = np.array([r[1] for r in molecule.residues])
    group["chain"] = np.array([r[2] for r in molecule.residues], dtype="S4")
    group["insertion_code"] = np.array(["" for _ in molecule.residues], dtype="S1")
    group["bond_order"] = np.ones(len(molecule.bonds), dtype=np.uint8)
    origin = h5py.enum_dtype({"file": 0, "residue": 1, "link": 2, "distance": 3}, np.uint8)
    group.create_dataset("bond_origin", data=np.zeros(len(molecule.bonds), np.uint8), dtype=origin)
    table = np.array([MASSES[element] for element in molecule.elements])
    file["particles/trajectory/mass"] = table
    file["particles/trajectory/species"] = molecule.elements.astype(np.uint8)
