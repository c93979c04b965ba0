# SPDX-License-Identifier: MIT
"""--assembly: copies of chains that files state, in every command that reads a molecule."""

import json

import h5py
import numpy as np
import pytest
from real_files import HEXAPEPTIDE

REMARK = """\
REMARK 350 BIOMOLECULE: 1
REMARK 350 APPLY THE FOLLOWING TO CHAINS: {chain}
REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000
REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000
REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000
REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       30.00000
REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000
REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000
"""


@pytest.fixture
def pair(tmp_path):
    """The peptide, whose file states that two of them are one assembly."""
    atoms = HEXAPEPTIDE.read_text()
    chain = next(line for line in atoms.splitlines() if line.startswith(("ATOM", "HETATM")))[21]
    path = tmp_path / "pair.pdb"
    path.write_text(REMARK.format(chain="NULL" if chain == " " else chain) + atoms)
    return path


def test_info_names_them_and_counts_the_copies(pliant, pair):
    one = json.loads(pliant("info", pair, "--json").out)
    two = json.loads(pliant("info", pair, "--json", "--assembly", 1).out)
    assert one["assemblies"] == two["assemblies"] == ["1"]
    for what in ("atoms", "residues", "bonds", "bars", "components"):
        assert two[what] == 2 * one[what], what
    assert two["chains"] == 2
    assert "assemblies           1   1: biological ones, which --assembly makes" in (
        pliant("info", pair).out
    )


def test_contacts_and_samples_are_of_the_assembly(pliant, pair, tmp_path):
    one = json.loads(pliant("contacts", pair, "--json").out)["contacts"]
    two = json.loads(pliant("contacts", pair, "--json", "--assembly", 1).out)["contacts"]
    assert len(two) == 2 * len(one)  # 30 Angstrom apart
    ended = pliant(
        "sample", pair, *"-o o.h5md --assembly 1 --frames 2 --amplitude 0.4 --quiet".split()
    )
    assert ended.code == 0, ended.err
    with h5py.File(tmp_path / "o.h5md") as file:
        assert file["parameters/input/assembly"][()] == b"1"
        chains = file["parameters/topology/chain"][:]
        assert len(np.unique(chains)) == 2
        assert np.isfinite(file["particles/trajectory/position/value"][:]).all()
    ended = pliant("sample", "--continue", "o.h5md", "--frames", 3, "--assembly", 1, "--quiet")
    assert ended.code == 0, ended.err


@pytest.mark.parametrize(
    "command", ["info", "run", "sample", "contacts", "lab order", "lab forcegen", "rigidity"]
)
def test_an_assembly_has_a_name(pliant, pair, command):
    ended = pliant(*command.split(), pair, "--assembly", "")
    assert ended.code == 2
    assert '--assembly: expected the name, found ""' in ended.err
