# SPDX-License-Identifier: MIT
"""Which residues are of a chain: modified ones are, ligands are not."""

import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
FOLDER = MDA.PDB_small.rsplit("/", 1)[0]


def test_modified_residues_are_of_their_chain_and_ligands_are_not():
    from pliant.measure.stages.units import trace_atoms

    universe = pliant.to_mdanalysis(pliant.read(f"{FOLDER}/1hvr.pdb"))
    names = trace_atoms(universe.atoms).resnames
    assert len(names) == 198
    assert np.count_nonzero(names == "CSO") == 2
    assert "XK2" not in names
