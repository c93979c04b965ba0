# SPDX-License-Identifier: MIT
"""Helices and strands that the page draws are those of the report: MDAnalysis' DSSP."""

import warnings

import pytest
from wasm_solver import ROOT

MDAnalysis = pytest.importorskip("MDAnalysis")
dssp = pytest.importorskip("MDAnalysis.analysis.dssp")

PEPTIDE = ROOT / "data" / "molecules" / "peptide_20.pdb"
#: Real proteins where they are: shared/ is not part of a clone.
PROTEINS = sorted((ROOT / "shared" / "validation").glob("*.pdb"))


def page_letters(solver, path):
    return solver.open(path, "bonds")["secondary"].replace(" ", "")


def letters_of_dssp(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        protein = MDAnalysis.Universe(str(path)).select_atoms("protein")
        return "".join(dssp.DSSP(protein).run(stop=1).results.dssp[0])


def test_the_peptide_is_a_helix_but_for_its_ends(solver):
    assert page_letters(solver, PEPTIDE) == "--" + 17 * "H" + "-"


@pytest.mark.parametrize("path", PROTEINS, ids=lambda path: path.stem)
def test_the_letters_are_those_of_dssp(solver, path):
    try:
        wanted = letters_of_dssp(path)
    except ValueError as refusal:
        pytest.skip(str(refusal))
    assert page_letters(solver, path) == wanted


def test_a_molecule_without_a_backbone_has_no_letters(solver):
    reply = solver.open(ROOT / "data" / "molecules" / "caffeine.sdf")
    assert reply["secondary"].strip() == ""
