# SPDX-License-Identifier: MIT
"""Recording some atoms only: what is there is as if all had been recorded."""

import json

import h5py
import MDAnalysis
import numpy as np
import pytest
from real_files import PEPTIDE

import pliant as package
from pliant import mdanalysis  # noqa: F401

POSITIONS = "particles/trajectory/position/value"
COMMANDS = {
    "run": ("run", PEPTIDE, "--model", "protein", "--steps", "12", "--every", "4"),
    "sample": ("sample", PEPTIDE, "--frames", "5"),
}


def arrays(path):
    with h5py.File(path) as file:
        names = []
        file.visit(names.append)
        return {name: file[name][()] for name in names if isinstance(file[name], h5py.Dataset)}


@pytest.mark.parametrize("selection", ["name CA", "not element H", "resid 3:7", "all"])
@pytest.mark.parametrize("command", COMMANDS)
def test_what_is_there_is_that_of_all(pliant, tmp_path, command, selection):
    for name, more in (("all", ()), ("some", ("--save", selection))):
        assert pliant(*COMMANDS[command], *more, "-o", f"{name}.h5md").code in (0, 3)
    whole, part = arrays(tmp_path / "all.h5md"), arrays(tmp_path / "some.h5md")
    universe = MDAnalysis.Universe(tmp_path / "all.h5md")
    kept = part["particles/trajectory/id"]
    assert kept.tolist() == universe.select_atoms(selection).ix.tolist()
    assert part[POSITIONS].tobytes() == whole[POSITIONS][:, kept].tobytes()
    counts = ("contacts_held", "contacts_broken", "contacts_off")
    for name in whole:
        if name.startswith("observables") and not any(count in name for count in counts):
            assert part[name].tobytes() == whole[name].tobytes(), name
    for name in ("bars", "bonds", "limits"):
        wanted = whole[f"connectivity/{name}"]
        wanted = wanted[np.isin(wanted, kept).all(axis=1)]
        found = part.get(f"connectivity/{name}", np.empty((0, 2), int))
        assert kept[found].tolist() == wanted.tolist()


def test_contacts_of_the_part_are_counted(pliant, tmp_path):
    for name, more in (("all", ()), ("some", ("--save", "resid 2:10"))):
        pliant(*COMMANDS["sample"], *more, "-o", f"{name}.h5md")
    whole, part = (package.H5mdReader(tmp_path / f"{name}.h5md") for name in ("all", "some"))
    for frame in range(5):
        positions = whole.positions(frame)
        kept = arrays(tmp_path / "some.h5md")["particles/trajectory/id"]
        assert np.array_equal(part.positions(frame), positions[kept])
    states = arrays(tmp_path / "some.h5md")["connectivity/contact_states/value"]
    held = arrays(tmp_path / "some.h5md")["observables/contacts_held/value"]
    assert (
        0
        < states.shape[1]
        < arrays(tmp_path / "all.h5md")["connectivity/contact_states/value"].shape[1]
    )
    assert held.tolist() == (states == 0).sum(axis=1).tolist()


def test_names_are_those_of_the_part(pliant, tmp_path):
    pliant(*COMMANDS["sample"], "--save", "backbone", "-o", "some.h5md")
    of_file = MDAnalysis.Universe(tmp_path / "some.h5md")
    of_topology = MDAnalysis.Universe(tmp_path / "some.pdb", tmp_path / "some.h5md")
    assert set(of_file.atoms.names) == {"N", "CA", "C", "O"}
    assert of_topology.atoms.names.tolist() == of_file.atoms.names.tolist()
    assert of_topology.atoms.resids.tolist() == of_file.atoms.resids.tolist()
    pliant(*COMMANDS["sample"], "--save", "backbone", "-o", "models.pdb")
    models = MDAnalysis.Universe(tmp_path / "models.pdb")
    assert len(models.trajectory) == 5
    for one, other in zip(models.trajectory, of_file.trajectory, strict=True):
        assert np.abs(one.positions - other.positions).max() < 6e-4


def test_python_does_the_same(pliant, tmp_path):
    assert pliant("sample", PEPTIDE, "--frames", "3", "--save", "name CA", "-o", "c.h5md").code == 0
    structure = package.read(PEPTIDE)
    package.sample(structure, 3, save="name CA", output=tmp_path / "p.h5md")
    files = {"output": tmp_path / "r.h5md", "topology": tmp_path / "r.pdb"}
    package.run(structure, steps=3, save="name CA", precision=1e-3, **files)
    command, python = arrays(tmp_path / "c.h5md"), arrays(tmp_path / "p.h5md")
    assert python[POSITIONS].tobytes() == command[POSITIONS].tobytes()
    run = arrays(tmp_path / "r.h5md")
    assert run[POSITIONS].shape == (4, 20, 3) and not (run[POSITIONS] * 1024 % 1).any()
    assert len(package.read(tmp_path / "r.pdb")) == 20
    package.run(structure, steps=3, save="name CA", output=tmp_path / "x.pdb")
    assert len(package.read(tmp_path / "x.pdb")) == 20
    with pytest.raises(package.OptionError, match=r"^precision: goes with H5MD, not with the PDB"):
        package.run(structure, precision=1e-3, output=tmp_path / "y.pdb")


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (("--save", "name XX"), '--save: selection "name XX" names no atom'),
        (("--save", "nam CA"), 'selection "nam CA": expected a word that selects atoms'),
        (("--save", "all", "-o", "x.sdf"), "x.sdf"),
    ],
)
@pytest.mark.parametrize("command", COMMANDS)
def test_what_cannot_be_saved_leaves_nothing(pliant, tmp_path, command, more, message):
    ended = pliant(*COMMANDS[command], *more)
    assert ended.code == 2 and message in ended.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", COMMANDS)
def test_nothing_goes_on_from_a_part(pliant, tmp_path, command):
    pliant(*COMMANDS[command], "--save", "name CA", "-o", "some.h5md")
    before = (tmp_path / "some.h5md").read_bytes()
    ended = pliant(command, "--continue", "some.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: some.h5md: holds some of the molecule's atoms only (--save), so that its "
        "run cannot go on\n",
    )
    assert (tmp_path / "some.h5md").read_bytes() == before


@pytest.mark.long
def test_the_report_says_what_it_looked_at(pliant, tmp_path):
    pliant("sample", PEPTIDE, "--frames", "40", "--save", "not element H", "-o", "some.h5md")
    ended = pliant("analyse", "some.h5md", "-o", "report")
    assert "the file holds " in ended.err and "atoms (--save): bars and stereo" in ended.err
    assert "report          report/report.html" in ended.out
    ended = pliant("check", "some.h5md")
    assert ended.code == 1 and "a check by a force field needs all of them" in ended.err


def test_atoms_without_bonds_have_no_torsions(pliant):
    pliant("sample", PEPTIDE, "--frames", "40", "--save", "name CA", "-o", "trace.h5md")
    ended = pliant("analyse", "trace.h5md", "-o", "report")
    assert "no torsions: there are no bonds among the recorded atoms" in ended.err
    assert ended.code == 0 and "rotatable" not in ended.out


@pytest.mark.long
def test_a_part_is_compared_as_the_whole_is(pliant, tmp_path):
    for name, more in (("all", ()), ("some", ("--save", "name CA"))):
        pliant("sample", PEPTIDE, "--frames", "40", *more, "-o", f"{name}.h5md")
    ended = [pliant("compare", f"{name}.h5md", "all.h5md", "--json") for name in ("all", "some")]
    residues = [json.loads(one.out)["residues"] for one in ended]
    assert residues[0]["rmsf"] == residues[1]["rmsf"]
