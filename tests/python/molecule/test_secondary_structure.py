# SPDX-License-Identifier: MIT
"""Helices and strands, which the page and reports draw: the letters of MDAnalysis' DSSP."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from real_files import PEPTIDE, ROOT

import pliant

MDAnalysis = pytest.importorskip("MDAnalysis")
dssp = pytest.importorskip("MDAnalysis.analysis.dssp")
DATA = pytest.importorskip("MDAnalysisTests.datafiles")

#: Real proteins where they are: shared/ is not part of a clone.
PROTEINS = [Path(DATA.PDB_small), *sorted((ROOT / "shared" / "validation").glob("*.pdb"))]


def read(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pliant.read(path)


def letters_of_dssp(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        protein = MDAnalysis.Universe(str(path)).select_atoms("protein")
        return "".join(dssp.DSSP(protein).run(stop=1).results.dssp[0])


def test_the_peptide_is_a_helix_but_for_its_ends():
    assert read(PEPTIDE).secondary_structure() == "--" + 17 * "H" + "-"


@pytest.mark.parametrize("path", PROTEINS, ids=lambda path: path.stem)
def test_the_letters_are_those_of_dssp(path):
    try:
        wanted = letters_of_dssp(path)
    except ValueError as refusal:
        pytest.skip(str(refusal))
    assert read(path).secondary_structure().replace(" ", "") == wanted


def test_a_molecule_without_a_backbone_has_no_letters():
    caffeine = read(ROOT / "data" / "molecules" / "caffeine.sdf")
    assert caffeine.secondary_structure().strip() == ""


def test_of_several_chains_each_has_its_own():
    one = read(DATA.PDB_small)
    count = 3
    shift = np.repeat([[100.0 * k, 0, 0] for k in range(count)], len(one), axis=0)
    many = pliant.Structure(
        np.tile(one.positions, (count, 1)) + shift,
        elements=np.tile(one.elements, count),
        names=np.tile(one.names, count).tolist(),
        residue_names=np.tile(one.residue_names, count).tolist(),
        residue_ids=np.tile(one.residue_ids, count),
        chains=np.repeat(list("ABC"), len(one)).tolist(),
    )
    assert many.secondary_structure() == count * one.secondary_structure()
