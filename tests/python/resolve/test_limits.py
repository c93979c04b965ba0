# SPDX-License-Identifier: MIT
"""Limits and sterics from Python: what frameworks take and show, measured again by numpy."""

import warnings

import numpy as np
import pytest

import pliant

CHAIN = [[0, 1], [1, 2], [2, 3], [3, 4]]
LIMITS = [
    (0, 4, 0.0, 3.0),
    (0, 3, 2.0, np.inf, "hydrogen_bond"),
    (1, 4, 1.0, 2.5, "torsion", -12.5),
    (0, 2, 1.2, 1.9, "hydrophobic", 2.0, 3),
]
FIVE_CARBONS = "5\n\n" + "".join(f"C {1.5 * k} {0.3 * (k % 2)} {0.2 * k}\n" for k in range(5))
BARS = """pliant-bars 1
bars bonds
bar 0 4 4.0
limit 0 3 2 3.5
sterics C C 2.2
own 1 4 3.0
bonds_apart 1
"""


def framework_with_limits(limits=LIMITS):
    return pliant.Framework(CHAIN, [1.0] * 4, 5, limits=limits)


def excess(limits, positions):
    """How far each limit is outside its interval, by numpy."""
    lengths = np.linalg.norm(positions[limits["a"]] - positions[limits["b"]], axis=1)
    return np.maximum(lengths - limits["most"], limits["least"] - lengths).clip(0)


def refusal(kind, limits):
    with pytest.raises(kind) as caught:
        framework_with_limits(limits)
    return str(caught.value)


def test_limits_are_shown_as_given():
    limits = framework_with_limits().limits
    assert limits["a"].tolist() == [0, 0, 1, 0]
    assert limits["b"].tolist() == [4, 3, 4, 2]
    assert limits["least"].tolist() == [0, 2, 1, 1.2]
    assert limits["most"].tolist() == [3, np.inf, 2.5, 1.9]
    assert limits["kind"].tolist() == ["given", "hydrogen_bond", "torsion", "hydrophobic"]
    assert limits["energy"].tolist() == [0, 0, -12.5, 2]
    assert limits["group"].tolist() == [-1, -1, -1, 3]
    assert (framework_with_limits(limits).limits == limits).all()


def test_a_framework_without_limits_has_none():
    framework = pliant.Framework(CHAIN, [1.0] * 4)
    assert framework.limits.shape == (0,)
    assert not framework.has_sterics


def test_bad_limits_are_refused():
    assert "limits[1]: expected (a, b, least, most)" in refusal(TypeError, [LIMITS[0], (0, 1)])
    assert "no number or name: 'x'" in refusal(TypeError, [(0, 2, "x", 1.0)])
    assert "limits[0]" in refusal(TypeError, [7])
    assert "known: given, hydrogen_bond" in refusal(pliant.OptionError, [(0, 2, 0, 1, "rope")])
    assert "has a bar already" in refusal(pliant.InputError, [(0, 1, 0, 1)])
    assert "above most" in refusal(pliant.InputError, [(0, 2, 2, 1)])
    assert "there are 5 joints" in refusal(pliant.InputError, [(0, -1, 0, 1)])


def test_measure_finds_the_worst_limit_as_numpy_does():
    framework = framework_with_limits()
    draw = np.random.default_rng(5)
    for _ in range(50):
        positions = draw.normal(size=(5, 3))
        found = pliant.measure_bars(framework, positions)
        outside = excess(framework.limits, positions)
        assert found.max_limit == pytest.approx(outside.max(), rel=1e-14, abs=1e-300)
        assert found.worst_limit == outside.argmax()


def overlaps(positions):
    """Of BARS: pairs that no bar joins, by their least distances less their distances."""
    near = {(i, i + 1) for i in range(4)} | {(0, 4)}
    pairs = [(i, j) for i in range(5) for j in range(i + 1, 5) if (i, j) not in near]
    least = [3.0 if pair == (1, 4) else 2.2 for pair in pairs]
    lengths = [np.linalg.norm(positions[i] - positions[j]) for i, j in pairs]
    return dict(zip(pairs, np.array(least) - lengths, strict=True))


@pytest.fixture
def stated(tmp_path):
    """Five carbons and the framework that a bars file states of them."""
    path = tmp_path / "bars.txt"
    path.write_text(BARS)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        structure = pliant.read_text(FIVE_CARBONS, "five.xyz")
    return structure, structure.framework(bars=path)


def test_measure_finds_the_worst_overlap_as_numpy_does(stated):
    _, framework = stated
    assert framework.has_sterics
    draw = np.random.default_rng(6)
    for _ in range(50):
        positions = draw.normal(size=(5, 3), scale=2)
        found = pliant.measure_bars(framework, positions)
        expected = overlaps(positions)
        worst = max(expected, key=expected.get)
        assert found.max_overlap == pytest.approx(max(expected[worst], 0), rel=1e-14, abs=1e-300)
        if expected[worst] > 0:
            assert tuple(sorted(found.worst_overlap)) == worst


def test_within_goes_by_the_tolerances_of_limits_and_overlaps(stated):
    positions = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0]])
    framework = pliant.Framework(CHAIN, [1.0] * 4, limits=[(0, 4, 0, 3.9)])
    assert pliant.measure_bars(framework, positions).max_limit == pytest.approx(0.1)
    assert not pliant.measure_bars(framework, positions).within
    assert pliant.measure_bars(framework, positions, tolerance_limit=0.11).within
    _, framework = stated
    found = pliant.measure_bars(framework, positions, tolerance=10, tolerance_limit=10)
    assert found.max_overlap == pytest.approx(0.2)
    assert not found.within
    assert pliant.measure_bars(
        framework, positions, tolerance=10, tolerance_limit=10, tolerance_overlap=0.21
    ).within


@pytest.mark.parametrize("name", ["tolerance_limit", "tolerance_overlap"])
def test_tolerances_have_a_range(name):
    framework = framework_with_limits()
    with pytest.raises(pliant.OptionError, match=name):
        pliant.Resolver(framework, **{name: 0.0})
    with pytest.raises(pliant.OptionError, match=name):
        pliant.run(framework, np.zeros((5, 3)), **{name: -1.0})


def test_sterics_from_python_are_those_of_the_bars_file(stated):
    structure, from_file = stated
    sterics = pliant.Sterics([0] * 5, [[2.2]], own=[(1, 4, 3.0)], excluded_bonds=1)
    framework = pliant.Framework(
        [[0, 1], [1, 2], [2, 3], [3, 4], [0, 4]],
        [*np.linalg.norm(np.diff(structure.positions, axis=0), axis=1), 4.0],
        sterics=sterics,
    )
    assert framework.has_sterics
    shown = framework.sterics
    assert shown.kinds.tolist() == [0] * 5
    assert shown.least.tolist() == [[2.2]]
    assert shown.own == [(1, 4, 3.0)]
    assert shown.excluded_bonds == 1
    draw = np.random.default_rng(7)
    for _ in range(20):
        positions = draw.normal(size=(5, 3), scale=2)
        found, expected = (pliant.measure_bars(f, positions) for f in (framework, from_file))
        assert found.max_overlap == expected.max_overlap
        assert found.worst_overlap == expected.worst_overlap


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0, 1], [[1.0]]), "joint 1 is of kind 1 of 1"),
        (([0, 1], [[1.0, 2.0], [1.0, 1.0]]), "have two least distances, 2 and 1"),
        (([0], [1.0]), "expected a square table"),
        (([-1], [[1.0]]), "-1 is not from 0 to 65535"),
    ],
)
def test_bad_sterics_are_refused(arguments, message):
    with pytest.raises(pliant.InputError, match=message):
        pliant.Sterics(*arguments)


def test_a_state_switches_limits_off_and_on():
    framework = framework_with_limits([(0, 4, 0.0, 1.5)])
    start = np.array([[0.0, 0, 0], [0.9, 0.4, 0], [1.6, 1.1, 0], [0.8, 1.7, 0], [0.2, 0.9, 0.3]])
    pliant.resolve(framework, start, "bfs_cycle", tolerance=1e-10)
    motion = pliant.Motion(framework, start, push="displacement", displacement=0.5)

    def worst_of(steps):
        worst = 0.0
        for _ in range(steps):
            motion.step()
            worst = max(worst, excess(framework.limits, motion.state.positions).max())
        return worst

    assert motion.state.limits_off.tolist() == []
    assert worst_of(20) <= 1e-2
    motion.state.limits_off = [True]
    assert worst_of(20) > 0.1
    motion.state.limits_off = [False]
    assert worst_of(20) <= 1e-2
    with pytest.raises(TypeError, match="limits_off"):
        motion.state.limits_off = [0.5]
    motion.state.limits_off = [True, False]
    with pytest.raises(pliant.OptionError, match="limits_off: 2 for 1 limits"):
        motion.step()
