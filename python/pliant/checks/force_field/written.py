# SPDX-License-Identifier: MIT
"""Systems written for OpenMM, GROMACS and AMBER, in the worker's process."""

from __future__ import annotations

import io
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import openmm
from openmm import app, unit

from pliant.base.extras import late
from pliant.base.force_field_options import PROGRAMS
from pliant.base.new_file import write_text
from pliant.checks.force_field.added import force_of
from pliant.checks.openmm.worker import Values

parmed_openmm = late("parmed.openmm")

MARGIN = 1.0  #: nm, of the box around the atoms


def named_topology(job: Values) -> app.Topology:
    """With chains, residues and atoms called as in the file."""
    topology, chain, before = app.Topology(), None, None
    residues, atoms = [], []
    columns = (job[key].tolist() for key in ("chains", "residue_names", "residue_ids"))
    for name, residue, number in zip(*columns, strict=True):
        if name != before:
            chain, before = topology.addChain(name), name
        residues.append(topology.addResidue(residue, chain, str(number)))
    columns = (job[key].tolist() for key in ("atom_names", "elements", "residue_of"))
    for name, element, residue in zip(*columns, strict=True):
        kind = app.Element.getByAtomicNumber(element)
        atoms.append(topology.addAtom(name, kind, residues[residue]))
    for a, b in job["bonds"].tolist():
        topology.addBond(atoms[a], atoms[b])
    return topology


def write(job: Values, system: openmm.System) -> None:
    """Writes the system, once, and each of structures (F, M, 3), nm, into the job's folder."""
    folder, topology = Path(str(job["folder"])), named_topology(job)
    names = job["files"].tolist()
    if job["to"] != "openmm":
        _write_with_parmed(job, system, topology, folder)
        return
    write_text(folder / "system.xml", openmm.XmlSerializer.serialize(system))
    for name, positions in zip(names, job["structures"], strict=True):
        text = io.StringIO()
        app.PDBFile.writeFile(topology, positions * unit.nanometer, text, keepIds=True)
        write_text(folder / f"{name}.pdb", text.getvalue())


def _write_with_parmed(
    job: Values, system: openmm.System, topology: app.Topology, folder: Path
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of ParmEd, on what NumPy and OpenMM will change
        solvent = force_of(system, openmm.GBSAOBCForce)
        radii = [solvent.getParticleParameters(k)[1:] for k in range(system.getNumParticles())]
        kinds = [type(force).__name__ for force in system.getForces()]
        system.removeForce(kinds.index("GBSAOBCForce"))  # neither has it in its topology
        made: Any = parmed_openmm.load_topology(
            topology, system, xyz=job["structures"][0] * unit.nanometer
        )
        for atom, (radius, screen) in zip(made.atoms, radii, strict=True):
            atom.solvent_radius = radius.value_in_unit(unit.angstrom)
            atom.screen = screen
        of_system, of_frame = PROGRAMS[str(job["to"])][2]
        made.save(str(folder / f"system{of_system}"))
        for name, positions in zip(job["files"].tolist(), job["structures"], strict=True):
            made.coordinates = 10 * (positions - positions.min(axis=0) + MARGIN)
            size = 10 * (np.ptp(positions, axis=0) + 2 * MARGIN)
            made.box = [*size, 90.0, 90.0, 90.0] if of_frame == ".gro" else None
            made.save(str(folder / f"{name}{of_frame}"))
