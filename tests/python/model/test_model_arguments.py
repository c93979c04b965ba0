# SPDX-License-Identifier: MIT
"""Arguments of preparation and contacts: each reaches the model, wherever it may be given."""

import numpy as np
import pytest
from real_files import PEPTIDE

import pliant


def edited(path, lines):
    path.write_text("".join(lines) + "END\n")
    return path


@pytest.fixture(scope="module")
def lines():
    """Atoms of the first nine residues."""
    with PEPTIDE.open() as file:
        return [row for row in file if row.startswith("ATOM") and int(row[22:26]) < 10]


@pytest.fixture(scope="module")
def heavy(lines, tmp_path_factory):
    """Without hydrogens and without OG of SER 1; a water, a glycerol's oxygen and an assembly."""
    rows = [row for row in lines if row[76:78] != " H" and row[12:26] != " OG  SER A   1"]
    water = "HETATM  900  O   HOH A 201      40.000  40.000  40.000  1.00 60.00           O\n"
    turn = "".join(
        f"REMARK 350   BIOMT{k}   {copy}{row}\n"
        for copy, places in (
            (1, ("  1.000000  0.000000  0.000000        0.00000",
                 "  0.000000  1.000000  0.000000        0.00000",
                 "  0.000000  0.000000  1.000000        0.00000")),
            (2, ("  1.000000  0.000000  0.000000       90.00000",
                 "  0.000000  1.000000  0.000000        0.00000",
                 "  0.000000  0.000000  1.000000        0.00000")),
        )
        for k, row in enumerate(places, 1)
    )  # fmt: skip  # matrices
    head = "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    folder = tmp_path_factory.mktemp("heavy")
    return edited(folder / "heavy.pdb", [head, turn, *rows, water])


def sampled(given, **options):
    return pliant.sample(given, frames=1, sampler="modes", threads=1, **options).model


def rated(given, **options):
    return pliant.rigidity(given, **options)


def hydrogens(structure):
    return int((structure.elements == 1).sum())


TAKE = [sampled, rated, pliant.build_model, pliant.prepare]


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("take", TAKE)
def test_each_option_of_preparation_reaches_the_structure(heavy, take):
    plain = take(heavy).structure
    assert len(take(heavy, keep_waters=True).structure) == len(plain) + 1
    full = take(heavy, all_hydrogens=True).structure
    assert hydrogens(full) > 2 * hydrogens(plain)
    assert np.count_nonzero(full.elements > 1) == np.count_nonzero(plain.elements > 1)
    filled = take(heavy, fill_side_chains=True).structure
    assert np.count_nonzero(filled.elements > 1) == np.count_nonzero(plain.elements > 1) + 1
    acid = take(heavy, protonate=["GLU3:GLH"]).structure
    assert hydrogens(acid) == hydrogens(plain) + 1
    chosen = take(heavy, select="resid 1:5").structure
    assert chosen.residue_ids.tolist() == sorted(chosen.residue_ids.tolist())
    assert max(chosen.residue_ids) == 5
    assert len(take(heavy, assembly=1).structure) == 2 * len(plain)
    both = take(heavy, assembly="1", select="resid 1:5").structure
    assert len(both) == 2 * len(chosen)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("take", TAKE[:3])
def test_each_option_of_contacts_reaches_the_model(take, tmp_path):
    usual = take(PEPTIDE).contacts
    bonds = usual["energy"] < 0
    strong = take(PEPTIDE, hbond_cutoff=-3.0).contacts
    assert len(strong) == len(usual) - np.count_nonzero(bonds & (usual["energy"] >= -3.0))
    assert len(take(PEPTIDE, floppy_below=50.0).contacts) < len(usual)
    assert (take(PEPTIDE, contacts=usual[:3]).contacts == usual[:3]).all()


@pytest.mark.filterwarnings("ignore")
def test_free_torsions_reach_the_sample():
    assert sampled(PEPTIDE).framework.torsion_preferences is not None
    assert sampled(PEPTIDE, free_torsions=True).framework.torsion_preferences is None


@pytest.fixture(scope="module")
def model():
    return pliant.build_model(PEPTIDE)


@pytest.mark.parametrize("take", [pliant.sample, pliant.rigidity])
@pytest.mark.parametrize(
    "given",
    [{"all_hydrogens": True}, {"keep": ["GOL"]}, {"hbond_cutoff": -2.0}, {"select": "name CA"},
     {"assembly": 1}, {"more_contacts": ["cation_pi"]}],
)  # fmt: skip  # a row
def test_of_a_model_nothing_is_left_to_choose(model, take, given):
    (name,) = given
    with pytest.raises(pliant.OptionError) as error:
        take(model, **given)
    told = "goes with a Structure; a MolecularModel is prepared already"
    assert str(error.value) == f"{name}: {told}"


@pytest.mark.parametrize(
    ("model", "given", "told"),
    [
        ("bonds", {"all_hydrogens": True}, 'model="molecule" or model="protein", not "bonds"'),
        ("molecule", {"hbond_cutoff": -2.0}, 'model="protein", not "molecule"'),
        ("molecule", {"contacts": "no.csv"}, 'model="protein", not "molecule"'),
    ],
)
@pytest.mark.parametrize("take", [pliant.sample, pliant.build_model])
def test_what_a_model_has_no_use_for_is_refused(take, model, given, told):
    (name,) = given
    with pytest.raises(pliant.OptionError) as error:
        take(PEPTIDE, model=model, **given)
    assert str(error.value) == f"{name}: goes with {told}"


@pytest.mark.parametrize("take", [pliant.sample, pliant.rigidity, pliant.build_model])
def test_an_assembly_is_of_a_file(take):
    with pytest.raises(pliant.OptionError) as error:
        take(pliant.read(PEPTIDE), assembly=1)
    assert str(error.value) == "assembly: goes with the path of a file of a molecule"


RUN = (
    "model = pliant.build_model(molecule, {}=...), then pliant.%s(model.framework, model.positions)"
)


@pytest.mark.parametrize(
    ("call", "name", "told"),
    [
        ("contacts", "all_hydrogens", ": pliant.build_model(molecule, {}=...).contacts has it"),
        ("contacts", "keep", ": pliant.build_model(molecule, {}=...).contacts has it"),
        ("run", "fill_side_chains", ": " + RUN % "run"),
        ("run_ensemble", "hbond_cutoff", ": " + RUN % "run_ensemble"),
    ],
)
def test_functions_that_build_no_model_say_how_to_give_one(call, name, told):
    with pytest.raises(TypeError) as error:
        getattr(pliant, call)(PEPTIDE, PEPTIDE, **{name: True})
    assert str(error.value) == f"{call}: has no argument {name!r}{told.format(name)}"


@pytest.mark.filterwarnings("ignore")
def test_the_ways_that_are_named_work(heavy):
    model = pliant.build_model(heavy, all_hydrogens=True)
    assert len(pliant.run(model.framework, model.positions, steps=2)[0]) == len(model.structure)
    end = pliant.sample(model, frames=1, amplitude=0.3)
    assert len(pliant.path(model, end[:1]).structure) == len(model.structure)
