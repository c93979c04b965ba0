# SPDX-License-Identifier: MIT
"""The options of a molecule in paths: the same words, and the same models, as everywhere."""

from pathlib import Path

import numpy as np
import pytest
from real_files import PEPTIDE

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.jobs.path.command import main
from pliant.jobs.path.walk import PathEnds, PathOptions

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"
GLYCEROL = "HETATM 9{0}  {1}  GOL A 900    {2:8.3f}   0.000   0.000  1.00  0.00           {3}"

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def atoms_of(path):
    return [line for line in path.read_text().splitlines() if line.startswith("ATOM")]


def ends(options, start=PEPTIDE, end=PEPTIDE):
    return PathEnds(options.start_of(start), options.end_of(end), options)


def test_a_selection_moves_what_a_file_of_it_alone_does(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    cut = [line for line in atoms_of(OPEN) if int(line[22:26]) <= 100]
    Path("cut.pdb").write_text("\n".join([*cut, "END", ""]))
    main(["cut.pdb", str(CLOSED), "-o", "cut.h5md"])
    main([str(OPEN), str(CLOSED), "-o", "selected.h5md", "--select", "resid 1-100"])
    of_file, selected = (pliant.H5mdReader(f"{name}.h5md") for name in ("cut", "selected"))
    assert len(selected) == len(of_file) > 5
    for k in range(len(selected)):
        assert np.array_equal(selected.positions(k), of_file.positions(k))
    python = pliant.path(OPEN, CLOSED, select="resid 1-100")
    assert np.array_equal(python.positions[-1], selected.positions(len(selected) - 1))


def test_contacts_that_are_given_replace_those_of_the_start():
    start, end = pliant.read(OPEN), pliant.read(CLOSED)
    found = pliant.build_model(start).contacts
    whole = PathEnds(start, end)
    given = PathEnds(start, end, PathOptions(contacts=found))
    assert np.array_equal(given.model.contacts, whole.model.contacts)
    few = PathEnds(start, end, PathOptions(contacts=found[:40]))
    assert len(few.model.contacts) + few.only_start == 40
    assert np.isin(few.model.contacts, whole.model.contacts).all()
    assert few.only_end > whole.only_end


@pytest.mark.parametrize(
    "options",
    [
        {"keep": ["GOL"]},
        {"all_hydrogens": True},
        {"protonate": ["LYS17:LYN"]},
        {"hbond_cutoff": -3.0},
        {"model": "molecule"},
        {"select": "resid 1-10"},
    ],
    ids=str,
)
def test_the_start_is_the_model_that_build_model_makes(tmp_path, options):
    atoms = [GLYCEROL.format(*row) for row in ((1, "C1", 50, "C"), (2, "O1", 51.4, "O"))]
    start = tmp_path / "start.pdb"
    start.write_text("\n".join([*atoms_of(PEPTIDE), *atoms, "END", ""]))
    wanted = pliant.build_model(start, **options)
    model = ends(PathOptions(**options), start, start).model
    assert model.kind == wanted.kind
    assert model.structure.names.tolist() == wanted.structure.names.tolist()
    assert np.array_equal(model.positions, wanted.positions)
    assert len(model.contacts) == len(wanted.contacts)


def test_files_say_it_as_those_of_samples_do(tmp_path):
    options = {"select": "resid 1-10", "keep": ["GOL", "SO4"], "hbond_cutoff": -2.0}
    pliant.path(PEPTIDE, PEPTIDE, output=tmp_path / "p.h5md", seed=3, **options)
    pliant.sample(PEPTIDE, frames=1, output=tmp_path / "s.h5md", topology="none", **options)
    path, sample = (
        pliant.H5mdReader(tmp_path / name).parameters() for name in ("p.h5md", "s.h5md")
    )
    of_molecule = {
        name: value
        for name, value in sample.items()
        if name.startswith(("input/", "model/")) and name in path
    }
    assert set(of_molecule) >= {"input/file", "input/select", "model/keep", "model/kind"}
    assert {name: path[name] for name in of_molecule} == of_molecule
    assert path["path/seed"] == "3"
    assert path["path/end"] == PEPTIDE.name


def test_the_end_has_an_assembly_but_no_selection_or_frame(tmp_path):
    options = PathOptions(select="resid 1-10", frame=2)
    two = tmp_path / "two.pdb"
    atoms = "\n".join(atoms_of(PEPTIDE))
    two.write_text(f"MODEL 1\n{atoms}\nENDMDL\nMODEL 2\n{atoms}\nENDMDL\nEND\n")
    assert options.start_of(two).model == 2
    assert options.end_of(two).model == 1
    assert len(options.end_of(two)) > len(options.start_of(two))
    with pytest.raises(pliant.OptionError) as error:
        PathOptions(assembly=1).end_of(pliant.read(PEPTIDE))
    assert str(error.value) == "assembly: goes with the path of a file of a molecule"
