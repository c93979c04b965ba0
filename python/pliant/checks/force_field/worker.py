# SPDX-License-Identifier: MIT
"""Minimises and moves proteins under amber14 and OBC2, in a process of its own.

Run as ``_openmm/worker.py`` is. Units are OpenMM's: nm, u, kJ/mol. On the platform CPU there is one
thread, with deterministic forces, so that a job gives the same bits whatever runs beside it.

OBC2 (Onufriev, Bashford and Case, Proteins 55 (2004) 383) is a GBSAOBCForce with the radii mbondi2:
the CustomGBForce of OpenMM's implicit/obc2.xml has the same energy and takes ten times as long.
"""

from __future__ import annotations

import contextlib
import pathlib
import sys
import time
from typing import Any

import numpy as np
import openmm
from openmm import app

from pliant.checks.force_field.added import Added, added_of, force_of
from pliant.checks.force_field.platforms import make_context, platforms
from pliant.checks.force_field.written import write
from pliant.checks.openmm import worker
from pliant.checks.openmm.worker import Arrays, Values

FORCE_FIELD = "amber14/protein.ff14SB.xml"
ION_FILE = "amber14/tip3p.xml"
CUTOFF = 1.6  #: nm; water screens what charges further away do to an eightieth
TOLERANCE = 0.1  #: kJ/mol/nm: so small that the minimiser makes all its steps
STEP = 0.004  #: ps
HEAVY_HYDROGEN = 3.0  #: u
TEMPERATURE = 300.0
FRICTION = 1.0  #: 1/ps
SEED = 1
#: nm, and how much of a volume counts: mbondi2 radii, and OBC's screening
RADII = {6: 0.17, 7: 0.155, 8: 0.15, 9: 0.15, 15: 0.185, 16: 0.18, 17: 0.17}
SCREENING = {1: 0.85, 6: 0.72, 7: 0.79, 8: 0.85, 9: 0.88, 15: 0.86, 16: 0.96}
APART = 20.0  #: nm between a ligand and the protein that do not touch
ALONE_STEPS = 500  #: of minimising a ligand by itself
CYSTEINE_BRIDGE = "CYX"


def topology_of(job: Values) -> app.Topology:
    """One chain: templates are found by elements and bonds, whatever atoms are called."""
    topology = app.Topology()
    chain = topology.addChain()
    residues = [topology.addResidue(str(label), chain) for label in job["labels"]]
    atoms = []
    for name, number, residue in zip(
        job["names"].tolist(), job["elements"].tolist(), job["residue_of"].tolist(), strict=True
    ):
        element = app.Element.getByAtomicNumber(number)
        atoms.append(topology.addAtom(str(name), element, residues[residue]))
    for a, b in job["bonds"].tolist():
        topology.addBond(atoms[a], atoms[b])
    return topology


def bridges(topology: app.Topology) -> dict[Any, str]:
    """Templates of cysteines of disulphides, which look like anions without their partner."""
    found = {}
    for a, b in topology.bonds():
        if {a.element.symbol, b.element.symbol} == {"S"} and a.residue is not b.residue:
            found[a.residue] = _end_of(topology, a.residue) + CYSTEINE_BRIDGE
            found[b.residue] = _end_of(topology, b.residue) + CYSTEINE_BRIDGE
    return found


def _end_of(topology: app.Topology, residue: Any) -> str:
    """ "N" or "C" where the residue has the atoms of an end, else ""."""
    names = {atom.name: atom for atom in residue.atoms()}
    on_nitrogen = [
        atom
        for bond in topology.bonds()
        for atom in bond
        if names.get("N") in bond and atom.element.symbol == "H"
    ]
    if len(on_nitrogen) > 1:
        return "N"
    return "C" if sum(atom.element.symbol == "O" for atom in residue.atoms()) > 1 else ""


def ions(topology: app.Topology) -> dict[Any, str]:
    """Templates of residues of one atom."""
    lone = (residue for residue in topology.residues() if len([*residue.atoms()]) == 1)
    return {one: next(one.atoms()).element.symbol.upper() for one in lone}


_added: dict[bytes, dict[int, Added]] = {}


def molecule_key(job: Values) -> bytes:
    """The same for all jobs on a molecule."""
    return b"".join(job[name].tobytes() for name in ("elements", "residue_of", "bonds"))


def added_to(job: Values) -> dict[int, Added]:
    """Molecules with topologies of their own, by number of their residue; read once."""
    found = _added.setdefault(molecule_key(job), {})
    if found:
        return found
    for k in range(len(job["labels"])):
        if f"prmtop-{k}" in job:
            text, where, own = (job[f"{name}-{k}"] for name in ("prmtop", "where", "own"))
            names = job["names"][where].tolist()
            found[k] = added_of(text.tobytes(), where, own, names, f"added-{k}")
    return found


def make_system(job: Values, *, moves: bool = False) -> openmm.System:
    """amber14 and OBC2; `moves`: with constraints and heavy hydrogens, for steps of 4 fs.

    Ends of a broken chain have the templates of residues within a chain.
    """
    topology = topology_of(job)
    added, lone = added_to(job), ions(topology)
    field = app.ForceField(FORCE_FIELD, *([ION_FILE] if lone else []))
    for one in added.values():
        one.register(field)
    residues = [*topology.residues()]
    system = field.createSystem(
        topology,
        nonbondedMethod=app.CutoffNonPeriodic,
        nonbondedCutoff=CUTOFF,
        constraints=app.HBonds if moves else None,
        hydrogenMass=HEAVY_HYDROGEN if moves else None,
        removeCMMotion=False,
        ignoreExternalBonds=True,
        residueTemplates=bridges(topology)
        | lone
        | {residues[k]: one.name for k, one in added.items()},
    )
    for one in added.values():
        one.add_terms(system, constrain=moves)
    nonbonded = force_of(system, openmm.NonbondedForce)
    nonbonded.setReactionFieldDielectric(1.0)  # what is beyond the cut-off is left out
    system.addForce(solvent(topology, nonbonded))
    return system


def solvent(topology: app.Topology, nonbonded: openmm.NonbondedForce) -> openmm.GBSAOBCForce:
    """OBC2 with the charges of the force field and mbondi2 radii."""
    on_nitrogen = {
        atom.index
        for bond in topology.bonds()
        for atom in bond
        if any(end.element.symbol == "N" for end in bond)
    }
    force = openmm.GBSAOBCForce()
    force.setNonbondedMethod(openmm.GBSAOBCForce.CutoffNonPeriodic)
    force.setCutoffDistance(CUTOFF)
    for atom in topology.atoms():
        number = atom.element.atomic_number
        charge = nonbonded.getParticleParameters(atom.index)[0]
        radius = RADII.get(number, 0.15)
        if number == 1:
            radius = 0.13 if atom.index in on_nitrogen else 0.12
        force.addParticle(charge, radius, SCREENING.get(number, 0.8))
    return force


_kept: dict[tuple[bytes, bool], openmm.System] = {}


def system_of(job: Values, *, moves: bool = False) -> openmm.System:
    """The System of the job's molecule, made once in this process."""
    key = (molecule_key(job), moves)
    if key not in _kept:
        _kept[key] = make_system(job, moves=moves)
    return _kept[key]


def energy_of(context: openmm.Context) -> float:
    """kJ/mol."""
    return float(context.getState(getEnergy=True).getPotentialEnergy()._value)


def worst_force(context: openmm.Context) -> float:
    """On any atom, kJ/(mol nm)."""
    forces = context.getState(getForces=True).getForces(asNumpy=True)._value
    return float(np.max(np.linalg.norm(np.asarray(forces, float), axis=1)))


def require_time(job: Values) -> None:
    """Raises TimeoutError when the time for all jobs is over."""
    if time.time() > job["deadline"]:
        raise TimeoutError("not begun: the time for minimising was over")


def match(job: Values) -> Arrays:
    """Finds templates of all residues; raises ValueError naming the first without one.

    Gives the platforms that work here, the fastest first.
    """
    return {"atoms": np.array(system_of(job).getNumParticles()), "platforms": np.array(platforms())}


def minimise(job: Values) -> Arrays:
    """Minimises a structure (M, 3) by L-BFGS, in stages of so many steps each.

    Gives energies before and after each stage (S + 1), positions after each (S, M, 3), and the
    worst force on an atom before; not-a-number from where OpenMM refuses to go on. For each of L
    ligands also what `of_ligand` gives after the first stage (L, 3).
    """
    require_time(job)
    stages = job["stages"].tolist()
    energies = np.full(len(stages) + 1, np.nan)
    positions = np.full((len(stages), *job["structure"].shape), np.nan)
    force = np.array(np.nan)
    molecules = [one for one in added_to(job).values() if one.is_molecule]
    ligands = np.full((len(molecules), 3), np.nan)
    context = make_context(system_of(job), openmm.VerletIntegrator(0.001), job["platform"])
    with contextlib.suppress(openmm.OpenMMException):  # such as "Particle coordinate is NaN"
        context.setPositions(job["structure"])
        force[...], energies[0] = worst_force(context), energy_of(context)
        for k, steps in enumerate(stages):
            openmm.LocalEnergyMinimizer.minimize(context, TOLERANCE, steps)
            energies[k + 1] = energy_of(context)
            positions[k] = worker.positions_of(context)
        for k, one in enumerate(molecules):
            ligands[k] = of_ligand(context, one, positions[0], job["platform"])
    return {"energies": energies, "positions": positions, "worst_force": force, "ligands": ligands}


def of_ligand(
    context: openmm.Context, ligand: Added, positions: np.ndarray, platform: str
) -> list[float]:
    """Energy of a ligand by itself at its positions, of its contacts, and its strain; kJ/mol.

    Contacts are the energy of the whole less that of the two moved APART; strain is what
    minimising the ligand alone takes from its energy. All are in implicit water.
    """
    context.setPositions(positions)
    together = energy_of(context)
    parted = positions.copy()
    parted[ligand.where] += [APART, 0.0, 0.0]
    context.setPositions(parted)
    contacts = together - energy_of(context)
    alone = make_context(alone_in_water(ligand), openmm.VerletIntegrator(0.001), platform)
    alone.setPositions(positions[ligand.where])
    energy = energy_of(alone)
    openmm.LocalEnergyMinimizer.minimize(alone, TOLERANCE, ALONE_STEPS)
    return [energy, contacts, energy - energy_of(alone)]


def alone_in_water(ligand: Added) -> openmm.System:
    """A System of its own, with the same implicit water."""
    system = openmm.XmlSerializer.clone(ligand.system)
    nonbonded = force_of(system, openmm.NonbondedForce)
    nonbonded.setNonbondedMethod(openmm.NonbondedForce.CutoffNonPeriodic)
    nonbonded.setCutoffDistance(CUTOFF)
    nonbonded.setReactionFieldDielectric(1.0)
    system.addForce(solvent(ligand.topology, nonbonded))
    return system


def dynamics(job: Values) -> Arrays:
    """Frames (F, M, 3) of Langevin dynamics at 300 K, evenly from its second half.

    The structure is minimised for as many steps as `settle` says before. `steps` in all.
    """
    require_time(job)
    integrator = openmm.LangevinMiddleIntegrator(TEMPERATURE, FRICTION, STEP)
    integrator.setRandomNumberSeed(SEED)
    context = make_context(system_of(job, moves=True), integrator, job["platform"])
    context.setPositions(job["structure"])
    openmm.LocalEnergyMinimizer.minimize(context, TOLERANCE, int(job["settle"]))
    context.setVelocitiesToTemperature(TEMPERATURE, SEED)
    steps, frames = int(job["steps"]), int(job["frames"])
    taken, found = 0, []
    for k in range(frames):
        ahead = steps // 2 + (k + 1) * (steps - steps // 2) // frames
        integrator.step(ahead - taken)
        taken = ahead
        found.append(worker.positions_of(context))
    return {"positions": np.array(found)}


def export(job: Values) -> Arrays:
    """Writes files for another program."""
    write(job, make_system(job))
    return {}


KINDS = {"match": match, "minimise": minimise, "dynamics": dynamics, "export": export}

if __name__ == "__main__":
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), KINDS)
