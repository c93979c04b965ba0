# SPDX-License-Identifier: MIT
"""The mistakes that people make first in Python: one line each, which has the line that works."""

from pathlib import Path

import pytest
from real_files import ASPIRIN, DIPEPTIDE, PEPTIDE

import pliant

Chem = pytest.importorskip("rdkit.Chem")
MDAnalysis = pytest.importorskip("MDAnalysis")

pytestmark = pytest.mark.filterwarnings(
    "ignore:frames reach an amplitude", "ignore:no bond can rotate", "ignore:select. .* bonds"
)
MOLECULES = (
    "a Structure, a path, a result of Pliant, a Universe or AtomGroup of MDAnalysis, "
    "an rdkit.Chem.Mol, an mdtraj.Trajectory, a Modeller, PDBFile or Simulation of OpenMM or "
    "an AtomGroup of ProDy"
)
EMBED = "molecule = Chem.AddHs(molecule); AllChem.EmbedMolecule(molecule, randomSeed=1)"
PREPARED = (
    "frames are of the prepared molecule, with hydrogens added and waters left out: "
    'ensemble.to_mdanalysis(), or the file "x-topology.pdb" beside them'
)
NONE_OF_RDKIT = (
    'molecule = None: must be an rdkit.Chem.Mol, such as Chem.MolFromMolFile("x.sdf", '
    "removeHs=False)"
)
ONE_FRAME = (
    "analyse: expected frames, or a file of them, found one Structure: "
    "pliant.analyse(pliant.sample(structure))"
)


def aspirin():
    return pliant.read(ASPIRIN)


def bare():
    """Without a conformer."""
    return Chem.MolFromSmiles("CC(=O)Oc1ccccc1C(=O)O")


def drawn():
    from rdkit.Chem import AllChem

    molecule = bare()
    AllChem.Compute2DCoords(molecule)
    return molecule


def sample_drawing():
    Path("drawn.sdf").write_text(Chem.MolToMolBlock(drawn()))
    with pytest.warns(pliant.PliantWarning, match="if this is a 2-D drawing"):
        pliant.sample("drawn.sdf")


def sample_drawn_molecule():
    with pytest.warns(pliant.PliantWarning, match="hydrogens without positions"):
        pliant.sample(drawn())


def analyse_with_the_input():
    pliant.sample(DIPEPTIDE, frames=2, output="x.h5md")
    pliant.analyse("x.h5md", topology=PEPTIDE)


def universe_of_the_input():
    ensemble = pliant.sample(DIPEPTIDE, frames=2)
    pliant.to_mdanalysis(pliant.read(PEPTIDE), ensemble.positions)


def view(source):
    pytest.importorskip("anywidget")
    pliant.view(source)


#: what is done, the class of the error, and what it says; {here} is the folder
MISTAKES = {
    "a file that is not there": (
        lambda: pliant.sample("missing.pdb"),
        pliant.FileError,
        "cannot read missing.pdb: No such file or directory in {here}: give the whole path, "
        'such as "/data/missing.pdb"',
    ),
    "a name of a file misspelt": (
        lambda: (Path("aspirin.sdf").write_bytes(b""), pliant.sample("asprin.sdf")),
        pliant.FileError,
        'cannot read asprin.sdf: No such file or directory (did you mean "aspirin.sdf"?)',
    ),
    "frames=-1": (
        lambda: pliant.sample(ASPIRIN, frames=-1),
        pliant.OptionError,
        "frames = -1: must be a whole number from 1, such as frames=200",
    ),
    'frames="5"': (
        lambda: pliant.sample(ASPIRIN, frames="5"),
        TypeError,
        "frames = '5': must be a whole number, such as frames=5",
    ),
    'sampler="mode"': (
        lambda: pliant.sample(ASPIRIN, sampler="mode"),
        pliant.OptionError,
        'no sampler named "mode" (did you mean "modes"?); known: modes, dilute, turns, reach, '
        "pocket, torsions",
    ),
    "an unknown keyword": (
        lambda: pliant.sample(ASPIRIN, temperature_of_bath=300),
        TypeError,
        "sample: has no argument 'temperature_of_bath'; help(pliant.sample) lists them",
    ),
    "seed=-1": (
        lambda: pliant.sample(ASPIRIN, seed=-1),
        pliant.OptionError,
        "seed = -1: must be a whole number from 0 to 18446744073709551615",
    ),
    'output="x.dcd" of a sample': (
        lambda: pliant.sample(ASPIRIN, output="x.dcd"),
        pliant.OptionError,
        "output x.dcd: expected a name that ends in .h5md: "
        'pliant.sample(..., output="x.h5md").save("x.dcd")',
    ),
    'output="x.dcd" of a run': (
        lambda: pliant.run(ASPIRIN, output="x.dcd"),
        pliant.OptionError,
        "output x.dcd: trajectories are written as H5MD or PDB: "
        'pliant.run(..., output="x.h5md").save("x.dcd")',
    ),
    "a drawing": (
        sample_drawing,
        pliant.InputError,
        "drawn.sdf: this is a 2-D drawing (all z are 0): make it 3-D by RDKit: molecule = "
        'Chem.AddHs(Chem.MolFromMolFile("drawn.sdf")); AllChem.EmbedMolecule(molecule, '
        'randomSeed=1); Chem.MolToMolFile(molecule, "three_d.sdf")',
    ),
    "a drawn molecule of RDKit": (
        sample_drawn_molecule,
        pliant.InputError,
        f"this is a 2-D drawing (all z are 0): make it 3-D by RDKit: {EMBED}",
    ),
    "a molecule without conformer": (
        lambda: pliant.sample(bare()),
        pliant.InputError,
        "the molecule has no conformer, so that its atoms have no positions: make one with "
        + EMBED,
    ),
    "from_rdkit(None)": (lambda: pliant.from_rdkit(None), TypeError, NONE_OF_RDKIT),
    "sample(None)": (
        lambda: pliant.sample(None),
        TypeError,
        "molecule = None, which RDKit gives for what it cannot read: must be " + MOLECULES,
    ),
    'from_mdanalysis("x.pdb")': (
        lambda: pliant.from_mdanalysis("x.pdb"),
        TypeError,
        "atoms = 'x.pdb': must be a Universe or an AtomGroup, such as "
        'MDAnalysis.Universe("x.pdb")',
    ),
    "analyse(structure)": (lambda: pliant.analyse(aspirin()), pliant.InputError, ONE_FRAME),
    "the input as topology": (
        analyse_with_the_input,
        pliant.InputError,
        f"x.h5md with topology {PEPTIDE}: 22 atoms, but {PEPTIDE} has 327: " + PREPARED,
    ),
    "a Universe of the input": (
        universe_of_the_input,
        pliant.InputError,
        f"positions: 22 atoms, but {PEPTIDE} has 327: {PREPARED}",
    ),
    "view(framework)": (
        lambda: view(aspirin().framework()),
        TypeError,
        "view: a Framework has no positions: pliant.view(structure), or "
        "pliant.view(pliant.Trajectory(structure, positions))",
    ),
    "view(3)": (lambda: view(3), TypeError, "molecule = 3: must be " + MOLECULES),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_answered_by_the_line_that_works(mistake, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    do, error, message = MISTAKES[mistake]
    with pytest.raises(error) as raised:
        do()
    assert str(raised.value) == message.replace("{here}", str(tmp_path.resolve()))
    assert "\n" not in str(raised.value)


def test_the_line_that_makes_a_drawing_3d_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    from rdkit.Chem import AllChem

    Path("drawn.sdf").write_text(Chem.MolToMolBlock(drawn()))
    with (
        pytest.warns(pliant.PliantWarning),
        pytest.raises(pliant.InputError, match="by RDKit: ") as raised,
    ):
        pliant.sample("drawn.sdf")
    exec(str(raised.value).partition("by RDKit: ")[2], {"Chem": Chem, "AllChem": AllChem})
    assert len(pliant.sample("three_d.sdf", frames=3)) == 3
