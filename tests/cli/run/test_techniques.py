# SPDX-License-Identifier: MIT
import json
from pathlib import Path

import h5py
import pytest


def test_techniques_as_json(pliant):
    tables = json.loads(pliant("techniques", "--json").out)
    names = [row["name"] for row in tables["techniques"]]
    assert (
        names[:11]
        == (
            "auto random bfs_tree dfs_tree bfs_cycle dfs_cycle bfs_reverse dfs_reverse bfs_adapt "
            "bfs_random input"
        ).split()
    )
    assert [row["name"] for row in tables["perturbations"]] == [
        "force",
        "force_all",
        "displacement",
    ]
    trees_only = [row["name"] for row in tables["techniques"] if row["applies_to"] == "trees"]
    assert trees_only == ["bfs_tree", "dfs_tree"]


def test_techniques_as_a_table(pliant):
    ended = pliant("techniques")
    assert ended.code == 0
    assert "bfs_reverse      bfs_cycle, then backwards and forwards in turn" in ended.out
    assert "anderson         bfs_cycle with Anderson acceleration" in ended.out


ADAMANTANE = Path(__file__).parents[3] / "data" / "molecules" / "adamantane.mol"
REMOVED = {
    "bfs_local": "blocks",
    "rings_first": "blocks, or anderson if there are limits",
    "rings_anderson": "blocks, or anderson if there are limits",
}


@pytest.mark.parametrize("name", REMOVED)
def test_a_removed_technique_is_refused_with_what_replaces_it(pliant, name):
    ended = pliant("run", ADAMANTANE, "--technique", name)
    assert ended.code == 2
    assert f'no choice named "{name}": removed in 0.3.0; use {REMOVED[name]}\n' in ended.err


def test_no_run_goes_on_with_a_removed_technique(pliant, tmp_path):
    assert pliant("run", ADAMANTANE, "--steps", 3, "-o", "old.h5md").code == 0
    with h5py.File(tmp_path / "old.h5md", "r+") as file:
        del file["parameters/run/technique"]
        file["parameters/run/technique"] = "rings_first"
    ended = pliant("run", "--continue", "old.h5md", "--steps", 5)
    assert (ended.code, ended.out) == (1, "")
    assert 'its run cannot go on: no technique named "rings_first": removed in 0.3.0' in ended.err
