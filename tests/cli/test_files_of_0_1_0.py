# SPDX-License-Identifier: MIT
"""Files that version 0.1.0 wrote are read as before.

``tests/golden/version_0_1_0`` was made by that version::

    pliant run molecule.xyz -o run.h5md --steps 12 --every 2 --seed 7 --record-forces forces.txt \\
      --technique bfs_cycle --weighting 0.5                       (run.h5md was then gzipped)
    pliant structgen 2-cycle-path -o graph.xml --seed 7 --depth 2
    pliant order graph.xml --ordering dfs_cycle -o ordering.txt
    pliant structgen --test-set test_set --classes tree,1-cycle-ring --graphs 1 --forces 2 \\
      --techniques bfs_cycle --weightings 0.5 --depth 2 --seed 1
"""

import gzip
import json
from pathlib import Path

import h5py
import numpy as np
import pytest

from pliant import H5mdReader, check, read_test_set

FILES = Path(__file__).parents[1] / "golden" / "version_0_1_0"


@pytest.fixture
def recorded(tmp_path):
    path = tmp_path / "run.h5md"
    path.write_bytes(gzip.decompress((FILES / "run.h5md.gz").read_bytes()))
    return path


def positions_in(path):
    with h5py.File(path) as file:
        return file["particles/trajectory/position/value"][:]


def test_a_trajectory_is_read_frame_by_frame(recorded):
    expected = positions_in(recorded)
    reader = H5mdReader(recorded)
    assert [reader.step(k) for k in range(len(reader))] == [0, 2, 4, 6, 8, 10, 12]
    for k, positions in enumerate(expected):
        assert np.array_equal(reader.positions(k), positions)
    framework = reader.framework()
    assert (framework.joint_count, framework.bar_count) == (9, 8)


def test_a_trajectory_without_a_schema_number_is_checked(recorded):
    with h5py.File(recorded) as file:
        assert "schema" not in file["h5md/creator"].attrs
    assert check(recorded).passed


def test_forces_are_replayed_to_the_frames_of_that_version(pliant, recorded, tmp_path):
    options = ("--technique", "bfs_cycle", "--weighting", 0.5, "--steps", 12, "--every", 2)
    ended = pliant(
        "run",
        FILES / "molecule.xyz",
        "-o",
        "again.h5md",
        "--forces",
        FILES / "forces.txt",
        *options,
    )
    assert ended.code == 0, ended.err
    assert np.array_equal(positions_in(tmp_path / "again.h5md"), positions_in(recorded))


def test_a_graph_and_its_ordering_are_read(pliant):
    printed = pliant("order", FILES / "graph.xml", "--ordering", "dfs_cycle").out
    assert printed == (FILES / "ordering.txt").read_text()
    arguments = ("--steps", 5, "--technique", "input", "--ordering", FILES / "ordering.txt")
    run = pliant("run", FILES / "graph.xml", "-o", "g.h5md", "--json", *arguments)
    assert json.loads(run.out)["unconverged_steps"] == 0


def test_a_test_set_is_read():
    test_set = read_test_set(FILES / "test_set")
    assert [row.name for row in test_set.classes] == ["tree", "1-cycle-ring"]
    for row in test_set.classes:
        (graph,) = row.graphs
        assert len(graph.pushes) == 2
        assert len(graph.ordering[0]) == graph.graph.framework.bar_count
