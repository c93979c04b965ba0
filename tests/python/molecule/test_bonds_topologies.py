# SPDX-License-Identifier: MIT
"""Bonds against the topologies (PSF, TPR) with which simulations were run."""

from pathlib import Path

import pytest
import support_program

MDAnalysis = pytest.importorskip("MDAnalysis")
tests_of_mdanalysis = pytest.importorskip("MDAnalysisTests")

MDA = Path(tests_of_mdanalysis.__file__).parent / "data"

# Topology and coordinates; CHARMM and OPLS names.
SYSTEMS = {
    "adk, a frame of a trajectory": ("adk.psf", "adk_dims.dcd"),
    "adk, open": ("adk.psf", "adk_open.pdb"),
    "ion channel": ("2r9r-1b.psf", "2r9r-1b.xyz"),
    "peptide with a modified residue": ("namd_cgenff.psf", "namd_cgenff.pdb"),
    "cobrotoxin in water": ("cobrotoxin.tpr", "cobrotoxin.pdb"),
    "water box": ("tip125_tric_C36.psf", "tip125_tric_C36.dcd"),
    "adk in a box that cuts it": ("adk_oplsaa.tpr", "adk_oplsaa.gro"),
}


@pytest.fixture(scope="module")
def compared(tmp_path_factory):
    """{name: (universe, our answer)}, from PDB files without CONECT."""
    folder = tmp_path_factory.mktemp("pdb")
    universes, files = [], []
    for number, (topology, coordinates) in enumerate(SYSTEMS.values()):
        universes.append(MDAnalysis.Universe(MDA / topology, MDA / coordinates))
        files.append(folder / f"{number}.pdb")
        universes[-1].atoms.write(files[-1], bonds=None)
    answers = support_program.bonds(files)
    return dict(zip(SYSTEMS, zip(universes, answers, strict=True), strict=True))


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", SYSTEMS)
def test_bonds_equal_the_topologys(name, compared):
    universe, answer = compared[name]
    theirs = set()
    for a, b in universe.bonds.indices:
        ends = universe.atoms[[a, b]]
        # Rigid water models have a bar between the hydrogens, which is no bond.
        if all(name.startswith("H") for name in ends.names):
            continue
        theirs.add((min(int(a), int(b)), max(int(a), int(b))))
    assert len(theirs) > 100
    assert support_program.differences(answer["labels"], answer["pairs"], theirs) == []
