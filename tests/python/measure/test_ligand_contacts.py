# SPDX-License-Identifier: MIT
"""Contacts of ligands over frames, and groups of their poses."""

import csv
import json

import numpy as np
import pytest
from made_trajectories import LIGAND, ligand_complex

import pliant

pytest.importorskip("MDAnalysis")
from pliant.measure.pockets.ligand_contacts import pose_distances


@pytest.fixture(scope="module")
def analysed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ligand")
    model = pliant.build_model(ligand_complex())
    ensemble = pliant.sample(
        model, 30, around=LIGAND, amplitude=0.2, seed=3, output=folder / "out.h5md"
    )
    report = pliant.analyse(folder / "out.h5md", folder / "report")
    return model, ensemble, json.loads(json.dumps(report.as_json())), folder / "report"


def pairs(structure, positions):
    """Residues that the ligand touches and how, by the contacts of one structure."""
    structure.positions = positions
    own = structure.residue_names == "AIN"
    found = set()
    for row in pliant.contacts(structure):
        a, b = int(row["a"]), int(row["b"])
        if own[a] != own[b]:
            other = b if own[a] else a
            found.add((int(structure.residue_ids[other]), str(row["kind"])))
    return found


def test_shares_are_those_of_contacts_frame_by_frame(analysed):
    model, ensemble, values, folder = analysed
    (ligand,) = values["ligands"]["found"]
    frames = [pairs(model.structure, x) for x in np.asarray(ensemble.positions)]
    start = pairs(model.structure, model.positions)
    assert ligand["contacts"]
    for one in ligand["contacts"]:
        number = int("".join(c for c in one["residue"].split(":")[-1] if c.isdigit()))
        key = number, one["kind"]
        assert one["at_start"] == (key in start)
        assert one["share"] == pytest.approx(np.mean([key in here for here in frames]), abs=0.05)
    with open(folder / "ligand_contacts.csv") as file:
        assert len(list(csv.DictReader(file))) == len(ligand["contacts"])


def test_every_frame_has_a_pose_and_each_group_a_model(analysed):
    _, ensemble, values, folder = analysed
    (ligand,) = values["ligands"]["found"]
    assert sum(one["frames"] for one in ligand["poses"]) == len(ensemble.positions)
    text = (folder / "ligand_poses.pdb").read_text()
    assert max(text.count("MODEL "), 1) == min(len(ligand["poses"]), 10)
    assert "Ligands" in (folder / "report.html").read_text()


def test_a_ring_turned_over_is_the_same_pose():
    x = np.array([[0, 0, 0], [1.4, 1.2, 0], [1.4, -1.2, 0], [2.8, 0, 0.0]])
    over = x[[0, 2, 1, 3]]
    classes = np.array([0, 1, 1, 2])
    assert pose_distances(np.array([x, over]), classes)[0, 1] == 0
    assert pose_distances(np.array([x, over]), np.arange(4))[0, 1] > 1
    assert pose_distances(np.array([x, x + np.array([0, 0, 3.0])]), classes)[0, 1] == pytest.approx(
        3
    )
