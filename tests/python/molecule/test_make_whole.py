# SPDX-License-Identifier: MIT
"""Molecules that a periodic cell cuts are made whole; MDAnalysis cuts them."""

import io

import numpy as np
import pytest

import pliant

mdamath = pytest.importorskip("MDAnalysis.lib.mdamath")
cut_by_box = pytest.importorskip("cut_by_box")
BOXES, cut_pdb = cut_by_box.BOXES, cut_by_box.cut_pdb

PEPTIDE = "data/molecules/peptide_20.pdb"


@pytest.fixture
def peptide():
    return pliant.read(PEPTIDE)


def lengths(structure):
    ends = structure.positions[structure.bonds]
    return np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)


@pytest.mark.parametrize("box", BOXES.values(), ids=BOXES)
def test_a_cut_protein_is_whole_again(peptide, box):
    whole = pliant.read_text(cut_pdb(peptide, box), "cut.pdb")
    assert whole.bonds.tolist() == peptide.bonds.tolist()
    np.testing.assert_allclose(lengths(whole), lengths(peptide), atol=0.003)
    # The same shape: every distance to the first atom is as before.
    for structure in (whole, peptide):
        structure.positions -= structure.positions[0].copy()
    np.testing.assert_allclose(whole.positions, peptide.positions, atol=0.003)


def test_the_box_did_cut(peptide):
    text = cut_pdb(peptide, BOXES["triclinic"])
    as_it_lies = pliant.read_text(text, "cut.pdb", perceive_bonds=False)
    assert np.ptp(as_it_lies.positions, axis=0).max() > 25.0


def test_what_was_moved_is_said(peptide, caplog):
    caplog.set_level("INFO", logger="pliant")
    pliant.read_text(cut_pdb(peptide, BOXES["right"]), "cut.pdb")
    said = [text for text in caplog.messages if "made whole" in text]
    assert len(said) == 1
    assert said[0].startswith("cut.pdb: 1 molecule cut by the periodic cell made whole (A:")
    assert said[0].endswith(" atoms moved by edges of the cell")


def test_without_a_cell_it_is_refused(peptide):
    text = cut_pdb(peptide, BOXES["right"], with_cell=False)
    with pytest.warns(pliant.PliantWarning, match="cut by a periodic box"):
        cut = pliant.read_text(text, "cut.pdb")
    for build in (pliant.build_model, pliant.sample, pliant.rigidity, pliant.Structure.framework):
        with pytest.raises(pliant.InputError) as error:
            build(cut)
        said = str(error.value)
        assert said.startswith("cut.pdb: bond A:")
        assert "Angstrom long: the molecule seems to be cut by a periodic box" in said
        assert said.endswith(
            "make it whole first (gmx trjconv -pbc whole), or give a file that states the box "
            "(CRYST1 of PDB)"
        )


def test_a_whole_molecule_in_a_cell_keeps_its_bits(peptide):
    text = cut_pdb(peptide, [500.0, 500.0, 500.0, 90.0, 90.0, 90.0])
    as_it_lies = pliant.read_text(text, "whole.pdb", perceive_bonds=False)
    assert pliant.read_text(text, "whole.pdb").positions.tobytes() == as_it_lies.positions.tobytes()


def test_the_cell_of_one_angstrom_is_none(peptide):
    text = cut_pdb(peptide, BOXES["right"], with_cell=False)
    dummy = "CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1\n"
    assert pliant.read_text(dummy + text, "d.pdb", perceive_bonds=False).cell is None


ETHANE = """8
Lattice="6 0 0 1 6 0 -1 2 7" Properties=species:S:1:pos:R:3
C  -0.56  0.66  0.00
C   0.56 -0.66  0.00
H  -1.52  0.14  0.10
H  -0.52  1.31 -0.88
H  -0.47  1.29  0.89
H   1.52 -0.14 -0.10
H   0.52 -1.31  0.88
H   0.47 -1.29 -0.89
"""


def test_extended_xyz_that_its_lattice_cuts():
    whole = pliant.read_text(ETHANE, "ethane.xyz")
    assert len(whole.bonds) == 7
    lines = ETHANE.splitlines()
    edges = whole.cell
    for k, line in enumerate(lines[2:], 2):
        symbol, *x = line.split()
        part = np.linalg.solve(edges.T, np.array(x, float))
        moved = (part - np.floor(part)) @ edges
        lines[k] = symbol + "  {:.6f} {:.6f} {:.6f}".format(*moved)
    cut = pliant.read_text("\n".join(lines) + "\n", "cut.xyz")
    assert cut.bonds.tolist() == whole.bonds.tolist()
    np.testing.assert_allclose(lengths(cut), lengths(whole), atol=1e-5)
    slab = "\n".join(lines).replace("Properties", 'pbc="T T F" Properties') + "\n"
    assert pliant.read_text(slab, "slab.xyz").cell is None


CELL = """_cell.length_a 30.0(1)
_cell.length_b 31.0
_cell.length_c 32.0
_cell.angle_alpha 90
_cell.angle_beta 100.5
_cell.angle_gamma 90
"""


def test_cells_of_mmcif_and_mdanalysis_are_the_same():
    atoms = (
        "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "1 C C1 LIG 0 0 0\n2 C C2 LIG 1.5 0 0\n"
    )
    cell = pliant.read_text("data_x\n" + CELL + atoms, "x.cif").cell
    expected = mdamath.triclinic_vectors([30, 31, 32, 90, 100.5, 90], dtype=np.float64)
    np.testing.assert_allclose(cell, expected, atol=1e-12)


def test_stated_bonds_of_a_universe(peptide):
    mda = pytest.importorskip("MDAnalysis")
    box = BOXES["right"]
    universe = mda.Universe(io.StringIO(cut_pdb(peptide, box)), format="PDB")
    universe.add_TopologyAttr("bonds", [tuple(bond) for bond in peptide.bonds.tolist()])
    structure = pliant.from_mdanalysis(universe)
    np.testing.assert_allclose(lengths(structure), lengths(peptide), atol=0.003)
    universe.atoms.unwrap()
    shift = structure.positions - universe.atoms.positions
    np.testing.assert_allclose(shift - shift[0], np.zeros_like(shift), atol=0.001)
