# SPDX-License-Identifier: MIT
"""Structure: from columns and from files, its views, bonds and framework."""

import gc
import logging
import warnings

import numpy as np
import pytest

import pliant

WATER = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"
PEPTIDE = """\
ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00  0.00           C
ATOM      3  C   GLY A   1       1.980   1.420   0.000  1.00  0.00           C
ATOM      4  O   GLY A   1       1.220   2.390   0.000  1.00  0.00           O
ATOM      5  N   ALA A   2A      3.300   1.560   0.000  1.00  0.00           N
ATOM      6  CA  ALA A   2A      3.950   2.860   0.000  1.00  0.00           C
END
"""


def address(array):
    return array.__array_interface__["data"][0]


def made(**columns):
    return pliant.Structure([[0, 0, 0], [1, 0, 0], [2, 0.5, 0]], **columns)


def test_columns_come_back():
    structure = made(
        elements=["C", "cl", ""],
        names=["CA", "CL1", "Q"],
        residue_names=["ALA", "ALA", "GLY"],
        residue_ids=[-1, -1, 7],
        insertion_codes=["A", "A", ""],
        chains=["X", "X", "Y"],
        serials=[10, 20, 30],
        bonds=[[2, 1], [0, 1]],
        bond_orders=[2, 4],
        title="made up",
    )
    assert structure.elements.tolist() == [6, 17, 0]
    assert structure.symbols.tolist() == ["C", "Cl", "X"]
    assert structure.names.tolist() == ["CA", "CL1", "Q"]
    assert structure.residue_names.tolist() == ["ALA", "ALA", "GLY"]
    assert structure.residue_ids.tolist() == [-1, -1, 7]
    assert structure.insertion_codes.tolist() == ["A", "A", ""]
    assert structure.chains.tolist() == ["X", "X", "Y"]
    assert structure.serials.tolist() == [10, 20, 30]
    assert structure.residue_of.tolist() == [0, 0, 1]
    assert structure.residue_count == 2
    assert structure.bonds.tolist() == [[0, 1], [1, 2]]
    assert structure.bond_orders.tolist() == [4, 2]
    assert structure.bond_origins.tolist() == ["file", "file"]
    assert structure.masses[0] == pytest.approx(12.011, abs=1e-3)
    assert structure.title == "made up"
    assert structure.label(0) == "X:ALA-1A:CA"
    assert len(structure) == 3


def test_columns_may_be_left_out():
    structure = made()
    assert structure.symbols.tolist() == structure.names.tolist() == ["X"] * 3
    assert structure.residue_count == 1
    assert structure.serials.tolist() == [1, 2, 3]
    assert structure.bonds.shape == (0, 2)
    assert repr(structure) == "<pliant.Structure: 3 atoms, 0 bonds>"


def test_elements_may_be_numbers_or_arrays():
    assert made(elements=np.array([1, 8, 1])).symbols.tolist() == ["H", "O", "H"]
    assert made(elements=np.array(["H", "O", "H"])).elements.tolist() == [1, 8, 1]
    assert made(names=np.array(["a", "b", "c"], dtype=object)).names.tolist() == ["a", "b", "c"]


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ({"elements": [1, 2]}, "elements: 2 for 3 atoms"),
        (
            {"elements": [1, 2, 119]},
            "elements[2]: expected an atomic number from 0 to 118, found 119",
        ),
        ({"elements": ["C", "Qq", "H"]}, 'elements[1]: "Qq" is no element'),
        ({"names": ["a"]}, "names: 1 for 3 atoms"),
        ({"residue_ids": [1]}, "residue_ids: 1 for 3 atoms"),
        ({"chains": ["A"] * 4}, "chains: 4 for 3 atoms"),
        (
            {"insertion_codes": ["", "AB", ""]},
            'insertion_codes[1]: expected one character or none, found "AB"',
        ),
        ({"bonds": [[0, 3]]}, "bonds[0] joins joints 0 and 3 but there are 3 joints"),
        ({"bonds": [[0, 1], [2, 2]]}, "bonds[1] joins atom 2 to itself"),
        ({"bonds": [[0, 1]], "bond_orders": [1, 2]}, "bond_orders: 2 for 1 bonds"),
        ({"bonds": [[0, 1]], "bond_orders": [5]}, "bond_orders[0]: expected 0 to 4, found 5"),
    ],
)
def test_refuses_bad_columns(columns, message):
    with pytest.raises(pliant.InputError) as caught:
        made(**columns)
    assert str(caught.value) == message


def test_refuses_positions_that_are_not_finite():
    with pytest.raises(pliant.InputError, match=r"^positions\[1\] is not finite$"):
        pliant.Structure([[0, 0, 0], [0, np.nan, 0]])


def test_positions_are_a_writeable_view():
    structure = made()
    positions = structure.positions
    positions[2] = [7, 8, 9]
    assert structure.positions[2].tolist() == [7, 8, 9]
    assert address(positions) == address(structure.positions)
    structure.positions = np.zeros((3, 3))
    assert not positions.any()
    with pytest.warns(pliant.PliantWarning, match="of unknown element without bonds"):
        structure.perceive_bonds()
    assert address(positions) == address(structure.positions)
    del structure
    gc.collect()
    positions[:] = 1
    assert (positions == 1).all()


def test_reads_a_file(tmp_path):
    path = tmp_path / "peptide.pdb"
    path.write_text(PEPTIDE)
    structure = pliant.read(path)
    assert structure.format == "pdb"
    assert structure.source == str(path)
    assert (structure.model, structure.model_count) == (1, 1)
    assert structure.names.tolist() == ["N", "CA", "C", "O", "N", "CA"]
    assert structure.residue_ids.tolist() == [1, 1, 1, 1, 2, 2]
    assert structure.insertion_codes.tolist() == ["", "", "", "", "A", "A"]
    assert structure.label(5) == "A:ALA2A:CA"
    assert structure.positions[5].tolist() == [3.95, 2.86, 0]
    bonds = dict(zip(map(tuple, structure.bonds.tolist()), structure.bond_origins, strict=True))
    assert bonds == {
        (0, 1): "residue",
        (1, 2): "residue",
        (2, 3): "residue",
        (2, 4): "link",
        (4, 5): "residue",
    }


def test_bonds_may_be_left_to_the_caller():
    structure = pliant.read_text(WATER, "w.xyz", perceive_bonds=False)
    assert len(structure.bonds) == 0
    structure.perceive_bonds(guess_distances=False)
    assert len(structure.bonds) == 0
    structure.perceive_bonds(slack=-0.5)
    assert len(structure.bonds) == 0
    structure.perceive_bonds()
    assert structure.bond_origins.tolist() == ["distance", "distance"]


def test_errors_name_file_and_line(tmp_path):
    with pytest.raises(pliant.InputError, match=r"^bad\.xyz:4: .*1,458"):
        pliant.read_text(WATER.replace("0.96", "1,458"), "bad.xyz")
    with pytest.raises(pliant.FileError, match=r"No such file or directory$"):
        pliant.read(tmp_path / "none.pdb")
    with pytest.raises(pliant.OptionError, match=r"^no frame 2 in w\.xyz: it has 1$"):
        pliant.read_text(WATER, "w.xyz", 2)
    with pytest.raises(pliant.OptionError, match=r"^model is -1: must be from 1$"):
        pliant.read_text(WATER, "w.xyz", -1)
    with pytest.raises(pliant.OptionError, match=r'no format named "xzy"; known: '):
        pliant.read_text(WATER, "w.xyz", format="xzy")


def test_guesses_are_warnings_at_the_callers_line():
    with pytest.warns(pliant.PliantWarning, match="Qq") as caught:
        pliant.read_text(WATER.replace("H", "Qq", 1), "w.xyz")
    assert {warning.filename for warning in caught} == {__file__}


def test_notes_go_to_the_logger(caplog):
    with caplog.at_level(logging.INFO, logger="pliant"), warnings.catch_warnings():
        warnings.simplefilter("error")
        pliant.read_text(WATER * 2, "w.xyz", model=2)
    assert any("frame 2 of 2" in message for message in caplog.messages)


def test_frameworks_of_a_structure():
    structure = pliant.read_text(WATER, "w.xyz")
    bonds = structure.framework()
    assert bonds.bars.tolist() == [[0, 1], [0, 2]]
    assert bonds.rest_lengths[0] == pytest.approx(0.96)
    assert bonds.inverse_masses[0] == pytest.approx(1 / 15.999, rel=1e-4)
    assert bonds.label(0) == "O(1)"
    angles = structure.framework("angles", pin="name O", use_masses=False)
    assert angles.bar_count == 3
    assert angles.pinned.tolist() == [0]
    assert angles.inverse_masses.tolist() == [0, 1, 1]
    with pytest.raises(pliant.OptionError, match="known: bonds, angles"):
        structure.framework("torsions")
    with pytest.raises(pliant.OptionError):
        structure.framework(pin="nonsense 5")


def test_a_framework_may_take_its_names_from_a_structure():
    structure = pliant.read_text(PEPTIDE, "p.pdb")
    framework = pliant.Framework([[1, 5]], positions=structure.positions, structure=structure)
    assert framework.bar_label(0) == "A:GLY1:CA - A:ALA2A:CA"
    with pytest.raises(TypeError, match="not both"):
        pliant.Framework([[1, 5]], [1], 6, names=["a"] * 6, structure=structure)
    with pytest.raises(pliant.InputError, match="2 joints but 6 atom names"):
        pliant.Framework([[0, 1]], [1], structure=structure)


def test_the_table_of_formats():
    assert {"pdb", "xyz"} <= {row.name for row in pliant.formats()}
    for row in pliant.formats():
        assert row.summary
        assert all(extension.startswith(".") for extension in row.extensions)
