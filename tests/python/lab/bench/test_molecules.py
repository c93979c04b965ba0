# SPDX-License-Identifier: MIT
"""The loop of the thesis on small molecules: rows against a run by hand, and the command."""

import csv
import json
import warnings

import pytest

import pliant

pytest.importorskip("rdkit")
pytest.importorskip("openmm")

from pliant.lab.bench.command import main
from pliant.lab.bench.molecules import molecule_loops, structure_of
from pliant.lab.bench.well_known_molecules import MOLECULES


def test_there_are_thirty_molecules_which_rdkit_reads():
    from rdkit import Chem

    assert len(MOLECULES) == 30
    assert all(Chem.MolFromSmiles(smiles) is not None for smiles in MOLECULES.values())


def test_rows_are_what_a_run_by_hand_gives():
    found = molecule_loops(["aspirin"], ["auto", "bfs_cycle", "bfs_tree"], steps=5)
    aspirin = structure_of(MOLECULES["aspirin"])
    for row in found.rows:
        if row.technique == "bfs_tree":
            assert "is for trees only" in row.unable
            continue
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            run = pliant.run(
                aspirin, steps=5, technique=row.technique, bars=row.bars, max_sweeps=3000
            )
        assert row.fit == ("doubtful" if said else "fits")
        assert (row.sweeps, row.residual) == (run.sweeps / 5, run.worst_residual)
        assert row.unconverged == run.unconverged_steps
    table = {(row.technique, row.bars): row for row in found.techniques}
    assert table["auto", "angles"].converged == 1
    assert table["auto", "bonds"].time_to_auto == 1.0
    assert table["bfs_tree", "bonds"].able == 0


def test_the_command_prints_and_writes(tmp_path, capsys):
    table = tmp_path / "loops.csv"
    words = ["molecules", "--only", "butane,benzene", "--technique", "auto,bfs_tree"]
    assert main([*words, "--steps", "3", "--csv", str(table), "--quiet"]) == 0
    out = capsys.readouterr().out
    assert "bfs_tree, bonds: 1 unable: technique = bfs_tree: is for trees only" in out
    with open(table, newline="") as file:
        assert len(list(csv.DictReader(file))) == 8
    assert main([*words, "--steps", "2", "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)["techniques"]) == 4
    assert main(["molecules", "--only", "unobtainium"]) == 2
    assert "--only unobtainium: must be one of ethanol," in capsys.readouterr().err
