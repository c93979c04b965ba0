# SPDX-License-Identifier: MIT
import json


def test_techniques_as_json(pliant):
    tables = json.loads(pliant("lab", "techniques", "--json").out)
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
    ended = pliant("lab", "techniques")
    assert ended.code == 0
    assert "bfs_reverse      bfs_cycle, then backwards and forwards in turn" in ended.out
    assert "anderson         bfs_cycle with Anderson acceleration" in ended.out
