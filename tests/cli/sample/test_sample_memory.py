# SPDX-License-Identifier: MIT
"""What pliant sample takes of memory: a protein, and an assembly of a hundred thousand atoms."""

import json

import numpy as np
import pytest

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
pytest.importorskip("scipy")

from pliant.lab.validity.costs import cost_of  # noqa: E402

CHAINS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcd"


def assembly(path):
    """Thirty copies of adenylate kinase side by side: 100230 atoms, 6420 residues."""
    with open(MDA.PDB_small) as file:
        lines = [line for line in file if line.startswith("ATOM")]
    atoms = np.array([[float(line[k : k + 8]) for k in (30, 38, 46)] for line in lines])
    step = np.ptp(atoms, axis=0) + 3.0
    with open(path, "w") as file:
        for copy, chain in enumerate(CHAINS):
            place = np.array([copy % 4, copy // 4 % 4, copy // 16]) - 1.5
            for line, x in zip(lines, atoms - atoms.mean(axis=0) + place * step, strict=True):
                where = "".join(f"{value:8.3f}" for value in x)
                file.write(f"{line[:21]}{chain}{line[22:30]}{where}{line[54:]}")
            file.write("TER\n")


def test_a_protein_takes_less_than_100_mb():
    assert cost_of(MDA.PDB_small, 5).megabytes < 100.0


@pytest.mark.long
def test_an_assembly_takes_less_than_2_gb(pliant, tmp_path):
    assembly(tmp_path / "assembly.pdb")
    assert cost_of(tmp_path / "assembly.pdb", 20).megabytes < 2000.0
    words = ("--frames", 1, "--topology", "none", "--json")
    report = json.loads(pliant("sample", tmp_path / "assembly.pdb", *words).out)
    assert (report["atoms"], report["failed"]) == (100230, 0)
    assert report["worst_residual"] < 1e-10
