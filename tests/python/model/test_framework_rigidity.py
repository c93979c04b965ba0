# SPDX-License-Identifier: MIT
"""Freedoms of joints and bars beside numpy's rank, bars taken out one by one, and Laman's count."""

import networkx
import numpy as np
import pytest
from real_files import MECHANISMS

import pliant

EXAMPLES = {example.name: example for example in pliant.examples()}


def matrix_of(framework, positions, dimension):
    """A row of unit length for each bar, a column for each coordinate that is not pinned."""
    rows = np.zeros((framework.bar_count, framework.joint_count, dimension))
    for row, (a, b) in zip(rows, framework.bars, strict=True):
        along = (positions[b] - positions[a])[:dimension]
        length = np.linalg.norm(along)
        row[b] = along / length if length > 0 else 0.0
        row[a] = -row[b]
    free = np.delete(rows, framework.pinned, axis=1)
    return free.reshape(len(free), dimension * free.shape[1])


def rank_of(matrix):
    return int(np.linalg.matrix_rank(matrix, tol=1e-9)) if matrix.size else 0


def redundant_in(matrix):
    """Bars without which the rank stays."""
    whole = rank_of(matrix)
    return [rank_of(np.delete(matrix, k, axis=0)) == whole for k in range(len(matrix))]


def freedoms(found):
    return (
        found.degrees_of_freedom,
        found.generic_degrees_of_freedom,
        found.counted_degrees_of_freedom,
    )


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_examples_have_the_rank_and_the_redundant_bars_of_numpy(name):
    example = EXAMPLES[name]
    found = pliant.rigidity(pliant.Graph(example.framework, example.positions))
    matrix = matrix_of(example.framework, example.positions, 3)
    assert found.rank == rank_of(matrix)
    assert found.bar_redundant.tolist() == redundant_in(matrix)
    assert found.self_stresses == len(matrix) - rank_of(matrix)
    random = np.random.default_rng(3).normal(size=example.positions.shape)
    assert found.generic_rank == rank_of(matrix_of(example.framework, random, 3))
    if example.facts.rank is not None:
        assert found.rank == example.facts.rank
    if example.facts.rigid_motions is not None:
        assert found.motions_of_the_whole == example.facts.rigid_motions


# At the positions, at almost all, by counting: closed forms, and PyRigi's tests for the double
# banana and the circuit (frameworkDB.py, test_infinitesimal.py).
@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("double_banana_generic", (1, 1, 0)),
        ("three_connected_R3_circuit_generic", (1, 1, 0)),
        ("bricard_octahedron_line_symmetric", (1, 0, 0)),
        ("cyclohexane_boat", (1, 0, 0)),
        ("cyclohexane_chair", (0, 0, 0)),
        ("second_order_rigid_connelly_whiteley", (2, 0, 0)),
        ("straight_path_3", (2, 1, 1)),
        ("K_4_6_generic", (0, 0, 0)),
        ("stewart_gough_no_legs", (6, 6, 6)),
    ],
)
def test_where_positions_graph_and_count_differ(name, expected):
    example = EXAMPLES[name]
    assert freedoms(pliant.rigidity(pliant.Graph(example.framework, example.positions))) == expected


@pytest.mark.parametrize(
    ("name", "dimension", "expected", "of_the_whole"),
    [
        ("four_bar", 2, (1, 1, 1), 0),
        ("peaucellier", 2, (1, 1, 1), 0),
        ("slider_crank", 2, (1, 1, 1), 0),
        ("double_banana", 3, (1, 1, 0), 6),
        ("bricard_octahedron", 3, (1, 0, 0), 6),
    ],
)
def test_mechanisms_by_their_files(name, dimension, expected, of_the_whole):
    path = MECHANISMS / f"{name}.xml"
    found = pliant.rigidity(path)
    assert (found.dimension, freedoms(found)) == (dimension, expected)
    assert found.motions_of_the_whole == of_the_whole
    graph = pliant.read_graph_xml(path)
    assert found.rank == rank_of(matrix_of(graph.framework, graph.positions, dimension))
    assert freedoms(pliant.rigidity(graph)) == expected


@pytest.mark.parametrize(
    ("pinned", "of_the_whole"), [([], 6), ([0], 3), ([0, 1], 1), ([0, 1, 2], 0), ([0, 1, 2, 3], 0)]
)
def test_pins_leave_some_motions_of_the_whole(pinned, of_the_whole):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    bars = [(a, b) for b in range(4) for a in range(b)]
    found = pliant.rigidity(pliant.Framework(bars, positions=corners, pinned=pinned))
    assert (found.degrees_of_freedom, found.motions_of_the_whole) == (0, of_the_whole)
    assert freedoms(found) == (0, 0, 0)
    between = [a in pinned and b in pinned for a, b in bars]
    assert found.bar_redundant.tolist() == between
    assert len(found.overconstrained) == sum(between)


def random_graph(seed, dimension):
    """From too few bars to far too many."""
    random = np.random.default_rng(seed)
    joints = int(random.integers(3, 12))
    graph = networkx.gnm_random_graph(joints, int(random.integers(1, 4 * joints)), seed=seed)
    pinned = random.choice(joints, int(random.integers(0, 3)), replace=False)
    positions = random.normal(size=(joints, 3))
    positions[:, dimension:] = 0
    edges = [(a, b) for a, b in graph.edges if not (a in pinned and b in pinned)]
    made = pliant.Framework(
        np.array(edges).reshape(-1, 2), positions=positions, pinned=pinned, planar=dimension == 2
    )
    return made, positions


@pytest.mark.parametrize("dimension", [2, 3])
def test_random_frameworks_by_numpy_and_by_count(dimension):
    for seed in range(150):
        framework, positions = random_graph(seed, dimension)
        found = pliant.rigidity(framework)
        matrix = matrix_of(framework, positions, dimension)
        assert found.rank == found.generic_rank == rank_of(matrix), seed
        expected = redundant_in(matrix)
        assert found.bar_redundant.tolist() == expected, seed
        assert found.bar_generic_redundant.tolist() == expected, seed
        assert found.counted_degrees_of_freedom <= found.generic_degrees_of_freedom, seed
        if dimension == 2:  # Laman
            assert found.counted_degrees_of_freedom == found.generic_degrees_of_freedom, seed


def test_a_graph_of_laman_has_no_bar_too_many_and_one_more_makes_one_part():
    """2 joints - 3 bars, each joint hung on two before it (Henneberg)."""
    random = np.random.default_rng(1)
    bars = [(0, 1)]
    for joint in range(2, 60):
        bars += [(int(other), joint) for other in random.choice(joint, 2, replace=False)]
    positions = np.c_[random.normal(size=(60, 2)), np.zeros(60)]
    minimal = pliant.rigidity(pliant.Framework(bars, positions=positions, planar=True))
    assert (minimal.rank, freedoms(minimal), minimal.redundant) == (117, (0, 0, 0), 0)
    pairs = {(a, 59) for a in range(59)} - set(bars)
    more = pliant.Framework([*bars, min(pairs)], positions=positions, planar=True)
    found = pliant.rigidity(more)
    assert (found.rank, found.self_stresses, len(found.overconstrained)) == (117, 1, 1)
    stress = np.linalg.svd(matrix_of(more, positions, 2).T)[2][-1]  # the only one
    assert found.bar_redundant.tolist() == (abs(stress) > 1e-9).tolist()


def test_large_frameworks_are_the_parts_they_consist_of():
    """Beyond the size where singular values are found, special positions are still seen."""
    names = ("bricard_octahedron_line_symmetric", "double_banana_generic", "K5")
    parts = [EXAMPLES[name] for name in names]
    positions = [np.cumsum(np.random.default_rng(2).normal(size=(300, 3)), axis=0)]
    bars = [np.c_[np.arange(299), np.arange(1, 300)]]
    for part in parts:
        bars.append(part.framework.bars.astype(int) + sum(map(len, positions)))
        positions.append(part.positions + 50.0)
    found = pliant.rigidity(pliant.Framework(np.vstack(bars), positions=np.vstack(positions)))
    ranks = [part.facts.rank for part in parts]
    assert found.rank == 299 + sum(ranks)
    assert found.generic_rank == 299 + sum(ranks) + 1  # the octahedron
    counts = [part.framework.bar_count for part in parts]
    assert np.flatnonzero(found.bar_redundant).tolist() == list(range(299, 299 + sum(counts)))
    assert sorted(map(len, found.overconstrained)) == sorted(counts)
    assert (found.parts, found.self_stresses) == (4, 3)


def test_coordinates_that_are_nearly_special_are_reported():
    """Three joints nearly on a line."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [2, 1e-6, 0]])
    found = pliant.rigidity(pliant.Framework([(0, 1), (1, 2), (0, 2)], positions=corners))
    assert found.rank == 3
    assert found.nearly_dependent.tolist() == pytest.approx([1e-6 / np.sqrt(3)], rel=0.5)


def test_a_graph_takes_no_options_and_a_framework_needs_positions():
    bare = pliant.Framework([(0, 1)], [1.0])
    with pytest.raises(pliant.InputError, match="this Framework has no positions of its own"):
        pliant.rigidity(bare)
    at = pliant.Graph(bare, [[0, 0, 0], [1, 0, 0]])
    with pytest.raises(TypeError, match="hbond_cutoff: is for molecules, not for a graph"):
        pliant.rigidity(at, hbond_cutoff=-2.0)
    with pytest.raises(pliant.InputError, match=r"in Python pliant\.read_graph_xml reads it"):
        pliant.read(MECHANISMS / "four_bar.xml")
    assert (
        repr(pliant.rigidity(at)) == "<pliant.FrameworkRigidity: 0 degrees of freedom of 2 joints>"
    )


@pytest.mark.parametrize("more", [{"pin": "id A"}, {"bars": "angles"}])
def test_a_run_of_a_graph_ignores_no_option_of_molecules(more):
    name = next(iter(more))
    with pytest.raises(TypeError, match=f"run: {name} is for a structure, or a file of one"):
        pliant.run(MECHANISMS / "four_bar.xml", steps=1, **more)
