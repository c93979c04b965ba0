# SPDX-License-Identifier: MIT
"""Models of molecules against files that have their hydrogens, and against MDAnalysis."""

import re
from pathlib import Path

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN = DATA / "adk_open.pdb"  # all hydrogens
XRAY = DATA / "1a28.pdb.gz"  # none, with waters


@pytest.fixture(scope="module")
def adk():
    with pytest.warns(pliant.PliantWarning, match="no element"):
        return pliant.read(OPEN)


@pytest.fixture(scope="module")
def stripped(tmp_path_factory):
    """The same file without any hydrogen."""
    path = tmp_path_factory.mktemp("stripped") / "adk.pdb"
    lines = OPEN.read_text().splitlines()
    is_hydrogen = re.compile(r"^ATOM.{8}(\d?H| H)")
    path.write_text("\n".join(line for line in lines if not is_hydrogen.match(line)) + "\n")
    with pytest.warns(pliant.PliantWarning, match="no element"):
        return pliant.read(path)


# Hydrogens whose place follows from the heavy atoms alone, but for Trp's HE1, which has namesakes.
RIGID = ("H", "HE", "HH11", "HH12", "HH21", "HH22", "HD21", "HD22")


def test_hydrogens_lie_where_another_program_has_them(adk, stripped):
    ready = pliant.prepare(stripped).structure
    is_rigid = np.isin(ready.names, RIGID) & (ready.elements == 1)
    theirs = adk.positions[adk.elements == 1]
    apart = np.linalg.norm(ready.positions[is_rigid][:, None] - theirs[None], axis=2).min(axis=1)
    # CHARMM's hydrogens were relaxed with its force field, so they leave the bisector.
    assert len(apart) > 260
    assert np.median(apart) < 0.15
    assert np.mean(apart < 0.3) > 0.98


def test_preparation_gives_the_same_bits(stripped):
    one, other = pliant.prepare(stripped), pliant.prepare(stripped)
    np.testing.assert_array_equal(one.structure.positions, other.structure.positions)


def test_hydrogen_bonds_are_those_of_mdanalysis_by_geometry(adk):
    hydrogen_bonds = pytest.importorskip("MDAnalysis.analysis.hydrogenbonds.hbond_analysis")
    import MDAnalysis

    universe = MDAnalysis.Universe(OPEN)
    universe.add_TopologyAttr("elements", adk.symbols)
    # A tight geometry, inside ours, so that energy alone decides.
    analysis = hydrogen_bonds.HydrogenBondAnalysis(
        universe,
        donors_sel="element N or element O",
        hydrogens_sel="element H",
        acceptors_sel="element O",
        d_a_cutoff=3.1,
        d_h_a_angle_cutoff=155,
        d_h_cutoff=1.2,
    )
    analysis.run()
    theirs = {(int(row[2]), int(row[3])) for row in analysis.results.hbonds}
    contacts = pliant.contacts(adk)
    ours = {(int(row["hydrogen"]), int(row["b"])) for row in contacts if row["hydrogen"] >= 0}
    assert len(theirs) > 60
    assert len(theirs & ours) > 0.95 * len(theirs)


def test_what_contacts_measure_is_so(adk):
    contacts, x = pliant.contacts(adk), adk.positions
    apart = np.linalg.norm(x[contacts["a"]] - x[contacts["b"]], axis=1)
    np.testing.assert_allclose(contacts["distance"], apart, rtol=1e-12)
    bonds = contacts[contacts["hydrogen"] >= 0]
    heavy = x[bonds["a"]] - x[bonds["hydrogen"]]
    assert np.linalg.norm(heavy, axis=1).max() < 1.2
    assert (contacts["distance"] <= contacts["most"]).all()
    assert (contacts["energy"] <= -1).all()


def test_a_model_starts_without_a_violation(stripped):
    with pytest.warns(pliant.PliantWarning) as warned:
        model = pliant.build_model(pliant.read(XRAY))
    assert any("side chains: 5 residues lack atoms" in str(w.message) for w in warned)
    summary = pliant.measure_bars(model.framework, model.positions)
    assert summary.max_limit == 0
    assert summary.max_overlap == 0
    assert model.kind == "protein"
    groups = model.framework.limits["group"]
    assert set(groups) == set(range(len(model.contacts)))


def test_contacts_are_given_back(adk):
    contacts = pliant.contacts(adk)
    model = pliant.build_model(adk, contacts=contacts[:7])
    np.testing.assert_array_equal(model.contacts, contacts[:7])
    energies = model.framework.limits["energy"]
    np.testing.assert_allclose(energies[0], contacts["energy"][0] * 4.184, rtol=1e-15)


def test_contacts_that_are_none_are_refused(adk):
    with pytest.raises(TypeError, match=r"contacts\[0\]: expected a row"):
        pliant.build_model(adk, contacts=[1.5])
    wrong = pliant.contacts(adk)[:1].copy()
    wrong["a"] = len(adk)
    with pytest.raises(pliant.InputError, match=f"contact 0 names atom {len(adk)} of {len(adk)} "):
        pliant.build_model(adk, contacts=wrong)


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("4E43.pdb", "a dimer with waters, alternates and ligands"),
        ("19hc.pdb.gz", "hemes"),
        ("nmr_neopetrosiamide.pdb", "one of 24 models of NMR, with disulphides"),
        ("cobrotoxin.pdb", "a box of four-site water with ions"),
        ("5a7u.pdb", "zinc"),
        ("1hvr.pdb", "modified residues, polar hydrogens"),
        ("unordered_res.pdb", "atoms twice"),
        ("mmcif/1BD2.cif.gz", "mmCIF, five chains"),
        ("fullerene.pdb.gz", "no protein"),
    ],
)
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_files_as_they_come_make_a_model(name, what):
    model = pliant.build_model(pliant.read(DATA / name))
    summary = pliant.measure_bars(model.framework, model.positions)
    assert (summary.max_limit, summary.max_overlap) == (0, 0), what
    assert model.notes


def test_the_table_of_models():
    assert [row.name for row in pliant.models()] == ["bonds", "angles", "molecule", "protein"]
    with pytest.raises(pliant.OptionError, match="no model named"):
        pliant.build_model(pliant.read_text("1\n\nHe 0 0 0\n", "he.xyz"), "protien")
