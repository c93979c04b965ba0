# SPDX-License-Identifier: MIT
"""Framework and State: what they take, what they show, and whose memory it is."""

import gc
import weakref

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pliant

SQUARE = [[0, 1], [1, 2], [2, 3], [3, 0]]


def address(array):
    return array.__array_interface__["data"][0]


def refusal(kind, *arguments, **options):
    with pytest.raises(kind) as caught:
        pliant.Framework(*arguments, **options)
    return str(caught.value)


def test_shows_what_it_was_made_of():
    framework = pliant.Framework(SQUARE, [1, 2, 3, 4.5], 5, masses=[1, 2, 4, 8, 16], pinned=[2])
    assert framework.joint_count == 5
    assert framework.bar_count == 4
    assert framework.bars.tolist() == SQUARE
    assert framework.bars.dtype == np.uint32
    assert framework.rest_lengths.tolist() == [1, 2, 3, 4.5]
    assert framework.inverse_masses.tolist() == [1, 0.5, 0, 0.125, 0.0625]
    assert framework.pinned.tolist() == [2]
    assert framework.label(4) == "joint 4"
    assert framework.bar_label(1) == "1 - 2"
    assert repr(framework) == "<pliant.Framework: 5 joints, 4 bars, 1 pinned>"


def test_takes_rest_lengths_and_joint_count_from_positions():
    positions = np.array([[0, 0, 0], [3, 4, 0], [3, 4, 2.5], [9, 9, 9]])
    framework = pliant.Framework([[0, 1], [1, 2]], positions=positions)
    assert framework.joint_count == 4
    assert framework.rest_lengths.tolist() == [5, 2.5]


def test_joint_count_defaults_to_the_joints_that_bars_name():
    assert pliant.Framework([[0, 7]], [1]).joint_count == 8


def test_no_bars_are_no_bars():
    assert pliant.Framework([], [], 3).bars.shape == (0, 2)
    assert pliant.Framework(np.empty((0, 2), int), [], 3).bar_count == 0
    assert pliant.Framework([], []).joint_count == 0


def test_pinned_may_be_a_mask():
    framework = pliant.Framework(SQUARE, [1] * 4, pinned=np.array([True, False, False, True]))
    assert framework.pinned.tolist() == [0, 3]


def test_names_are_used_in_messages():
    assert pliant.Framework([[0, 1]], [1], names=["hinge", "tip"]).bar_label(0) == ("hinge - tip")


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (([[1, 1]], [1]), {}, "bar 0 joins joint 1 to itself"),
        (([[0, -1]], [1], 2), {}, "bars[0] joins joints 0 and -1 but there are 2 joints"),
        (([[0, 2]], [1], 2), {}, "bars[0] joins joints 0 and 2 but there are 2 joints"),
        (([[0, 1, 2]], [1]), {}, "bars: expected shape (K, 2), found (1, 3)"),
        (([[0, 1]], [[1]]), {}, "rest_lengths: expected shape (K,), found (1, 1)"),
        (([[0, 1]], [1, 2]), {}, "framework: 1 bars but 2 rest lengths"),
        (
            ([[0, 1]], [np.nan]),
            {},
            "bar 0 - 1 has rest length nan: must be from 1e-150 to 1e150 Angstrom",
        ),
        (
            ([[0, 1], [1, 0]], [1, 2]),
            {},
            "bar 0 - 1 is given twice, with rest lengths 1 and 2 Angstrom",
        ),
        (([[0, 1]], [1]), {"masses": [1]}, "framework: 2 joints but 1 masses"),
        (
            ([[0, 1]], [1]),
            {"masses": [1, 0]},
            "mass of joint 1 is 0: must be from 1e-150 to 1e150 u",
        ),
        (([[0, 1]], [1]), {"pinned": [2]}, "pinned: joint 2 of 2 does not exist"),
        (([[0, 1]], [1]), {"pinned": [True]}, "pinned: expected shape (2,), found (1,)"),
        (([[0, 1]], [1], -1), {}, "joint_count = -1: must be from 0"),
        (([[0, 1]], [1], 3), {"positions": np.zeros((2, 3))}, "positions: 2 for 3 joints"),
        (([[0, 1]], [1]), {"names": ["a"]}, "framework: 2 joints but 1 atom names"),
        (
            ([[0, 1]],),
            {"positions": np.zeros((2, 2))},
            "positions: expected shape (N, 3), found (2, 2)",
        ),
    ],
)
def test_refuses_bad_values(arguments, options, message):
    assert refusal(pliant.InputError, *arguments, **options) == message


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ([[0, 1.5]], [1]),
            "bars: expected an array of integers, found an array of float64 with shape (1, 2)",
        ),
        (([[0, 1], [2]], [1]), "bars: expected an array of integers, found an object of type list"),
        (
            ([[0, 1]], ["long"]),
            "rest_lengths: expected an array of real numbers, found an array of <U4 "
            "with shape (1,)",
        ),
        (([[0, 1]],), "Framework: either rest_lengths or positions must be given"),
    ],
)
def test_refuses_what_is_no_array_of_numbers(arguments, message):
    assert refusal(TypeError, *arguments) == message


def test_errors_belong_to_the_classes_that_python_programs_catch():
    assert issubclass(pliant.InputError, (pliant.Error, ValueError))
    assert issubclass(pliant.InputError, ValueError)
    assert issubclass(pliant.OptionError, ValueError)
    assert issubclass(pliant.FileError, OSError)
    for error in (pliant.InputError, pliant.OptionError, pliant.FileError):
        assert issubclass(error, pliant.Error)
        assert error.__module__ == "pliant"


def test_labels_of_what_does_not_exist():
    framework = pliant.Framework([[0, 1]], [1])
    with pytest.raises(IndexError, match=r"^joint 2 of 2 does not exist$"):
        framework.label(2)
    with pytest.raises(IndexError, match=r"^joint -1 of 2 does not exist$"):
        framework.label(-1)
    with pytest.raises(IndexError, match=r"^bar 1 of 1 does not exist$"):
        framework.bar_label(1)


def test_graph_facts_of_two_rings_and_a_tail():
    # A triangle, a bridge, a square, and a joint without bars.
    bars = [[0, 1], [1, 2], [2, 0], [2, 3], [3, 4], [4, 5], [5, 6], [6, 3]]
    framework = pliant.Framework(bars, [1] * 8, 8)
    facts = framework.graph_facts()
    assert (facts.joints, facts.bars, facts.components) == (8, 8, 2)
    assert (facts.cycles, facts.bridges, facts.blocks) == (2, 1, 2)
    assert (facts.largest_block, facts.bars_in_blocks, facts.is_forest) == (4, 7, False)
    assert framework.components().tolist() == [0] * 7 + [1]
    assert framework.bridges().tolist() == [bar == [2, 3] for bar in bars]
    blocks = framework.blocks()
    assert len(set(blocks[:3])) == len(set(blocks[4:])) == 1
    assert len(set(blocks)) == 3


def test_views_of_a_framework_are_read_only_and_keep_it_alive():
    framework = pliant.Framework([[0, 1]], [2.5])
    bars, lengths = framework.bars, framework.rest_lengths
    assert address(bars) == address(framework.bars)
    with pytest.raises(ValueError, match="read-only"):
        lengths[0] = 1
    del framework
    gc.collect()
    assert bars.tolist() == [[0, 1]]
    assert lengths.tolist() == [2.5]


def test_state_is_seen_and_changed_through_its_views():
    start = np.arange(6.0).reshape(2, 3)
    state = pliant.State(start)
    positions = state.positions
    assert positions.dtype == np.float64
    assert positions.flags.c_contiguous
    assert positions.flags.writeable
    assert address(positions) == address(state.positions)
    assert not np.shares_memory(positions, start)
    positions[1, 2] = -7
    assert state.positions[1, 2] == -7
    state.positions = start * 2
    assert positions.tolist() == (start * 2).tolist()
    assert state.previous.tolist() == start.tolist()
    assert (state.step, state.time) == (0, 0.0)


def test_views_of_a_state_keep_it_alive():
    positions = pliant.State(np.ones((1000, 3))).positions
    gc.collect()
    np.ones((1000, 3)) * 2
    assert (positions == 1).all()


def test_a_state_keeps_its_number_of_joints():
    state = pliant.State(np.zeros((2, 3)))
    with pytest.raises(pliant.InputError, match=r"^positions: 3 for 2 joints$"):
        state.positions = np.zeros((3, 3))


def test_nothing_is_leaked_by_views():
    state = pliant.State(np.zeros((2, 3)))
    for _ in range(100):
        assert state.positions.base is not None
    gone = weakref.ref(state.positions)
    assert gone() is None


@st.composite
def graphs(draw):
    count = draw(st.integers(1, 12))
    joint = st.integers(0, count - 1)
    pairs = draw(st.lists(st.tuples(joint, joint), max_size=25))
    return count, sorted({(min(a, b), max(a, b)) for a, b in pairs if a != b})


@given(graphs())
@settings(max_examples=200, deadline=None)
def test_components_bridges_and_blocks_are_those_of_networkx(graph):
    count, bars = graph
    framework = pliant.Framework(bars, np.ones(len(bars)), count)
    theirs = nx.Graph(bars)
    theirs.add_nodes_from(range(count))
    components = framework.components()
    assert len(set(components)) == nx.number_connected_components(theirs)
    for component in nx.connected_components(theirs):
        assert len({components[joint] for joint in component}) == 1
    bridges = {bar for bar, is_bridge in zip(bars, framework.bridges(), strict=True) if is_bridge}
    assert bridges == {tuple(sorted(bar)) for bar in nx.bridges(theirs)}
    blocks = {}
    for bar, block in zip(bars, framework.blocks(), strict=True):
        blocks.setdefault(block, set()).add(bar)
    expected = {
        frozenset(tuple(sorted(bar)) for bar in block)
        for block in nx.biconnected_component_edges(theirs)
    }
    assert {frozenset(block) for block in blocks.values()} == expected
    facts = framework.graph_facts()
    assert facts.cycles == len(bars) - count + facts.components
    assert facts.is_forest == nx.is_forest(theirs)
