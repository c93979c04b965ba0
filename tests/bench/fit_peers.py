# SPDX-License-Identifier: MIT
"""Fits of open adenylate kinase to a map of the closed one: `pliant fit` beside molecular dynamics.

The recipe is MDFF's (L. Trabuco et al., Structure 16 (2008) 673), in OpenMM: forces along the
gradient of the map, 0.3 kcal/mol for each dalton at the greatest density; Amber 14 in a
vacuum, 300 K; helices and strands held by dihedral restraints. Both begin at the same place. Times
are of processors, one thread each.

    python tests/bench/fit_peers.py --picoseconds 50
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
import warnings
from pathlib import Path

import MDAnalysisTests
import numpy as np
import openmm
from openmm import app, unit
from pliant.trajectory.superposition import superpose_onto

import pliant

DATA = Path(MDAnalysisTests.__file__).parent / "data"
RESOLUTION = 8.0
SCALE = 0.3 * 4.184  #: kJ/mol for each dalton
HELD = 200.0  #: kJ/mol/rad^2
RIGID = ((-65.0, -40.0, 30.0), (-120.0, 130.0, 40.0))  #: phi, psi of helix, strand; how near


def alpha_carbons(structure: pliant.Structure) -> np.ndarray:
    return np.flatnonzero((structure.names == "CA") & (structure.elements == 6))


def density_force(density: pliant.DensityMap, system: openmm.System) -> openmm.Force:
    """Of the map with its greatest value 1; nothing below 0."""
    values = np.maximum(density.values / density.values.max(), 0).astype(float)
    ends = density.origin + (np.array(density.shape) - 1) * density.spacing
    sides = np.stack([density.origin, ends], axis=1).ravel() / 10
    function = openmm.Continuous3DFunction(*values.shape, values.ravel(order="F"), *sides)
    force = openmm.CustomCompoundBondForce(1, "-scale * density(x1, y1, z1)")
    force.addTabulatedFunction("density", function)
    force.addPerBondParameter("scale")
    for atom in range(system.getNumParticles()):
        mass = system.getParticleMass(atom).value_in_unit(unit.dalton)
        if mass > 2:
            force.addBond([atom], [SCALE * mass])
    return force


def backbone_force(modeller: app.Modeller, phi_psi: dict[int, tuple[float, float]]) -> openmm.Force:
    """Holds the dihedrals of residues in helices and strands."""
    force = openmm.CustomTorsionForce(
        f"0.5 * {HELD} * min(d, 6.283185307 - d)^2; d = abs(theta - start)"
    )
    force.addPerTorsionParameter("start")
    residues = list(modeller.topology.residues())
    for k, angles in phi_psi.items():
        at = [{a.name: a.index for a in residues[j].atoms()} for j in (k - 1, k, k + 1)]
        phi = (at[0]["C"], at[1]["N"], at[1]["CA"], at[1]["C"])
        psi = (at[1]["N"], at[1]["CA"], at[1]["C"], at[2]["N"])
        for atoms, angle in zip((phi, psi), angles, strict=True):
            force.addTorsion(*atoms, [angle])
    return force


def dihedral(p: np.ndarray) -> float:
    b0, b1, b2 = p[0] - p[1], p[2] - p[1], p[3] - p[2]
    b1 = b1 / np.linalg.norm(b1)
    v, w = b0 - (b0 @ b1) * b1, b2 - (b2 @ b1) * b1
    return float(np.arctan2(np.cross(b1, v) @ w, v @ w))


def rigid_dihedrals(
    modeller: app.Modeller, positions: np.ndarray
) -> dict[int, tuple[float, float]]:
    residues = list(modeller.topology.residues())
    found = {}
    for k in range(1, len(residues) - 1):
        at = [{a.name: a.index for a in residues[j].atoms()} for j in (k - 1, k, k + 1)]
        phi = dihedral(positions[[at[0]["C"], at[1]["N"], at[1]["CA"], at[1]["C"]]])
        psi = dihedral(positions[[at[1]["N"], at[1]["CA"], at[1]["C"], at[2]["N"]]])
        angles = np.degrees([phi, psi])
        if any(np.abs(angles - [a, b]).max() < near for a, b, near in RIGID):
            found[k] = (phi, psi)
    return found


def by_dynamics(start: Path, density: pliant.DensityMap, picoseconds: float, report) -> np.ndarray:
    pdb = app.PDBFile(str(start))
    forces = app.ForceField("amber14-all.xml")
    modeller = app.Modeller(pdb.topology, pdb.positions)
    modeller.addHydrogens(forces)
    system = forces.createSystem(
        modeller.topology,
        nonbondedMethod=app.CutoffNonPeriodic,
        nonbondedCutoff=1.0 * unit.nanometer,
        constraints=app.HBonds,
    )
    positions = np.array(modeller.positions.value_in_unit(unit.angstrom))
    system.addForce(density_force(density, system))
    system.addForce(backbone_force(modeller, rigid_dihedrals(modeller, positions)))
    integrator = openmm.LangevinMiddleIntegrator(300, 5, 0.002)
    platform = openmm.Platform.getPlatformByName("CPU")
    simulation = app.Simulation(modeller.topology, system, integrator, platform, {"Threads": "1"})
    simulation.context.setPositions(modeller.positions)
    simulation.minimizeEnergy(maxIterations=200)
    simulation.context.setVelocitiesToTemperature(300, 1)
    chosen = [atom.index for atom in modeller.topology.atoms() if atom.name == "CA"]
    done = 0.0
    while done < picoseconds:
        simulation.step(2500)
        done += 5.0
        state = simulation.context.getState(getPositions=True)
        here = np.array(state.getPositions().value_in_unit(unit.angstrom))[chosen]
        report(done, here)
    return here


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--picoseconds", type=float, default=50.0)
    asked = parser.parse_args()
    os.environ["PLIANT_THREADS"] = "1"
    warnings.simplefilter("ignore")
    closed, opened = pliant.read(DATA / "adk_closed.pdb"), pliant.read(DATA / "adk_open.pdb")
    goal = closed.positions[alpha_carbons(closed)]
    opened.positions = superpose_onto(opened.positions[None], alpha_carbons(opened), goal)[0]
    density = pliant.DensityMap.from_structure(closed, RESOLUTION)
    with tempfile.TemporaryDirectory() as folder:
        start = Path(folder) / "start.pdb"
        pliant.Trajectory(opened).save(start, select="not element H")
        compare(start, density, goal, asked.picoseconds)


def off(here: np.ndarray, goal: np.ndarray) -> float:
    moved = superpose_onto(here[None], slice(None), goal)[0]
    return float(np.sqrt(((moved - goal) ** 2).sum(axis=1).mean()))


def compare(start: Path, density: pliant.DensityMap, goal: np.ndarray, length: float) -> None:
    begun = time.process_time()
    found = pliant.fit(start, map=density, resolution=RESOLUTION)
    seconds = time.process_time() - begun
    here = found.positions[0][alpha_carbons(found.structure)]
    print(f"pliant fit {seconds:7.1f} s  {off(here, goal):.2f} A")
    begun = time.process_time()

    def report(done: float, here: np.ndarray) -> None:
        spent = time.process_time() - begun
        print(f"{done:6.0f} ps  {spent:7.1f} s ({spent / seconds:.0f} x)  {off(here, goal):.2f} A",
              flush=True)  # fmt: skip

    last = by_dynamics(start, density, length, report)
    assert off(here, goal) < off(last, goal), "molecular dynamics came nearer"


if __name__ == "__main__":
    main()
