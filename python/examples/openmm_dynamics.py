# SPDX-License-Identifier: MIT
"""Molecular dynamics by OpenMM beside a run of Pliant, from the same structure.

    python python/examples/openmm_dynamics.py peptide.pdb -o out

runs OpenMM (amber14, the implicit solvent GBn2, Langevin dynamics at 300 K) and `pliant run` from
the minimised structure, and compares both by `pliant compare`. The PDB file must have all hydrogens
and the names of the Amber residues, as data/molecules/alanine_dipeptide.pdb has. In the folder:

    NAME-openmm.dcd  NAME-start.pdb  NAME.h5md  NAME.compare.png  NAME.compare-torsions.png
"""

from __future__ import annotations

import argparse
import pathlib
import sys

import openmm
from openmm import app, unit
from pliant.report.compare.sections import print_report

import pliant

FORCE_FIELD = ("amber14-all.xml", "implicit/gbn2.xml")


def make_simulation(pdb: app.PDBFile, platform: str, seed: int) -> app.Simulation:
    """OpenMM's usual set-up: bonds to hydrogen constrained, 2 fs a step, 300 K, friction 1/ps."""
    system = app.ForceField(*FORCE_FIELD).createSystem(
        pdb.topology, nonbondedMethod=app.NoCutoff, constraints=app.HBonds
    )
    integrator = openmm.LangevinMiddleIntegrator(
        300 * unit.kelvin, 1 / unit.picosecond, 2 * unit.femtoseconds
    )
    integrator.setRandomNumberSeed(seed)
    chosen = openmm.Platform.getPlatformByName(platform)
    simulation = app.Simulation(pdb.topology, system, integrator, chosen)
    simulation.context.setPositions(pdb.positions)
    simulation.minimizeEnergy()
    simulation.context.setVelocitiesToTemperature(300 * unit.kelvin, seed)
    return simulation


def run_dynamics(simulation: app.Simulation, picoseconds: float, frames: int, dcd: str) -> None:
    """Runs a tenth of the time to warm up, then the time, and writes so many frames."""
    steps = max(frames, round(picoseconds / 0.002))
    simulation.step(steps // 10)
    simulation.reporters.append(app.DCDReporter(dcd, steps // frames))
    simulation.step(steps // frames * frames)
    simulation.reporters.clear()  # closes the file


def write_start(simulation: app.Simulation, path: str) -> None:
    """The minimised structure, from which both runs start, names the atoms of both."""
    state = simulation.context.getState(getPositions=True)
    with open(path, "w", encoding="utf-8") as file:
        app.PDBFile.writeFile(simulation.topology, state.getPositions(), file, keepIds=True)


def run_pliant(start: str, output: str, steps: int, seed: int) -> None:
    """The same structure, pushed and resolved."""
    structure = pliant.read(start)
    pliant.run(structure, output=output, steps=steps, seed=seed, overwrite=True)


def parse(words: list[str] | None = None) -> argparse.Namespace:
    """The options."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pdb", type=pathlib.Path, help="molecule with all its hydrogens")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("--picoseconds", type=float, default=200.0, help="of dynamics")
    parser.add_argument("--frames", type=int, default=500, help="of dynamics, and steps of Pliant")
    parser.add_argument("--platform", default="CPU", help="of OpenMM: CPU, Reference, ...")
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_args(words)


def main(words: list[str] | None = None) -> int:
    """Runs both and compares them."""
    arguments = parse(words)
    arguments.output.mkdir(parents=True, exist_ok=True)
    stem = str(arguments.output / arguments.pdb.stem)
    simulation = make_simulation(
        app.PDBFile(str(arguments.pdb)), arguments.platform, arguments.seed
    )
    write_start(simulation, f"{stem}-start.pdb")
    run_dynamics(simulation, arguments.picoseconds, arguments.frames, f"{stem}-openmm.dcd")
    run_pliant(f"{stem}-start.pdb", f"{stem}.h5md", arguments.frames, arguments.seed)
    report = pliant.compare(
        f"{stem}.h5md",
        f"{stem}-openmm.dcd",
        topology=f"{stem}-start.pdb",
        pictures=arguments.output,
    )
    print_report(report)
    return 0


if __name__ == "__main__":
    sys.exit(main())
