# SPDX-License-Identifier: MIT
"""Kinds of contacts: their table, and cation-pi contacts against plain geometry."""

from pathlib import Path

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")

FOLDER = Path(MDAnalysisTests.__file__).parent / "data"
CHARGES = {"LYS": "NZ", "ARG": "CZ"}
BENZENE = "CG CD1 CE1 CZ CE2 CD2"
RINGS = {
    "PHE": [BENZENE],
    "TYR": [BENZENE],
    "TRP": ["CG CD1 NE1 CE2 CD2", "CD2 CE2 CZ2 CH2 CZ3 CE3"],
}


def places_of(structure, residue):
    """Position and index of each atom of a residue, by name."""
    return {
        structure.names[k]: (structure.positions[k], k)
        for k in np.flatnonzero(structure.residue_of == residue)
    }


def pairs_by_geometry(structure):
    """(charge, atom of the ring) of each charge over a ring; planes by singular values."""
    residues = [
        (structure.residue_names[np.argmax(structure.residue_of == r)], places_of(structure, r))
        for r in range(structure.residue_of.max() + 1)
    ]
    charges = [atoms[CHARGES[name]] for name, atoms in residues if CHARGES.get(name) in atoms]
    pairs = set()
    for name, atoms in residues:
        rings = [ring.split() for ring in RINGS.get(name, [])]
        rings = [[atoms[one] for one in ring] for ring in rings if set(ring) <= set(atoms)]
        middles = [np.mean([place for place, _ in ring], axis=0) for ring in rings]
        for charge, k in charges:
            if not any(np.abs(charge - middle).max() < 6 for middle in middles):
                continue
            found = []
            for ring in rings:
                places = np.array([place for place, _ in ring])
                way = charge - places.mean(axis=0)
                axis = np.linalg.svd(places - places.mean(axis=0))[2][2]
                if np.linalg.norm(way) < 6 and np.linalg.norm(np.cross(way, axis)) < 2:
                    nearest = np.linalg.norm(places - charge, axis=1).argmin()
                    found.append((np.linalg.norm(way), (k, ring[nearest][1])))
            pairs |= {min(found)[1]} if found else set()
    return pairs


@pytest.mark.parametrize(
    ("file", "count"),
    [("mmcif/5PTI.cif.gz", 1), pytest.param("mmcif/1BD2.cif.gz", 7, marks=pytest.mark.long)],
)
def test_cation_pi_contacts_are_where_geometry_says(file, count):
    structure = pliant.prepare(pliant.read(FOLDER / file)).structure
    found = pliant.contacts(structure, more_contacts=["cation_pi"])
    rows = found[found["kind"] == "cation_pi"]
    pairs = list(zip(rows["a"].tolist(), rows["b"].tolist(), strict=True))
    assert len(pairs) == count
    assert set(pairs) == pairs_by_geometry(structure)
    usual = pliant.contacts(structure)
    assert (found[: len(usual)] == usual).all()
    assert len(found) == len(usual) + count


@pytest.fixture(scope="module")
def inhibitor():
    return pliant.read(FOLDER / "mmcif" / "5PTI.cif.gz")


def test_models_and_rigidity_take_more_kinds(inhibitor):
    model = pliant.build_model(inhibitor, more_contacts=["cation_pi"])
    assert (model.contacts["kind"] == "cation_pi").sum() == 1
    found = pliant.rigidity(inhibitor, more_contacts=["cation_pi"])
    assert (found.contacts == model.contacts).all()
    assert (pliant.rigidity(model).cluster == found.cluster).all()
    with pytest.raises(pliant.OptionError, match=r"^more_contacts: goes with a Structure"):
        pliant.rigidity(model, more_contacts=["cation_pi"])


def test_the_table_says_what_each_kind_is():
    rows = {row.name: row for row in pliant.contact_kinds()}
    assert {name for name, row in rows.items() if row.has_hydrogen} == {
        "hydrogen_bond",
        "salt_bridge",
    }
    assert rows["hydrogen_bond"].is_usual
    assert not rows["cation_pi"].is_usual
    assert rows["cation_pi"].plural == "cation-pi contacts"
    assert (rows["metal"].bars, rows["metal"].slack, rows["metal"].colour) == (5, 0.2, "#6b5bd2")
