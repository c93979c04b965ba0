# SPDX-License-Identifier: MIT
"""pliant lab techniques, and what pliant run says of one that does not fit."""

import json

from real_files import ASPIRIN

SAID = (
    "technique = random: goes from bar to bar, which does not converge or is slow where bars form "
    "rigid units (angles); use auto, which takes units"
)


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


def test_a_doubtful_technique_is_announced_before_the_run(pliant):
    ended = pliant("run", ASPIRIN, "--bars", "angles", "--technique", "random", "--dry-run")
    assert ended.code == 0
    assert f"warning: {SAID}\n" in ended.err


def test_it_is_among_the_warnings_of_the_run(pliant):
    words = ("--bars", "angles", "--technique", "random", "--steps", "2", "--max-sweeps", "5")
    ended = pliant("run", ASPIRIN, *words, "-o", "out.h5md", "--json")
    assert ended.code == 3
    assert json.loads(ended.out)["warnings"].count(SAID) == 1
