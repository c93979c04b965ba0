# SPDX-License-Identifier: MIT
"""What the check computes itself, against closed forms and slow, plain loops."""

import numpy as np
import pytest

from pliant.measure import bars as _bars

SQUARE = np.array([[0.0, 0, 0], [3, 0, 0], [3, 4, 0], [0, 4, 0]])
BARS = np.array([[0, 1], [1, 2], [2, 3], [0, 2]])


def test_lengths_of_a_rectangle():
    assert _bars.lengths(SQUARE, BARS).tolist() == [3, 4, 3, 5]


def test_residuals_are_relative_to_the_rest_length():
    rest = np.array([3.0, 5.0, 2.0, 5.0])
    residual = _bars.relative_residuals(SQUARE, BARS, rest)
    assert residual == pytest.approx([0, 0.2, 0.5, 0], abs=1e-15)
    assert _bars.worst_residual(SQUARE, BARS, rest) == 0.5


def test_what_is_no_number_stays_none():
    broken = SQUARE.copy()
    broken[3, 0] = np.nan
    assert np.isnan(_bars.worst_residual(broken, BARS, np.ones(4)))
    assert np.isnan(_bars.furthest_move(broken, SQUARE))


def test_no_bar_has_no_residual():
    assert _bars.worst_residual(SQUARE, BARS[:0], np.empty(0)) == 0.0


def test_energy_of_two_springs_by_hand():
    # 1/2 * 100 * (3 - 2)^2 + 1/2 * 10 * (4 - 5)^2 = 50 + 5
    energy, rounding = _bars.harmonic_energy(
        SQUARE, BARS[:2], np.array([2.0, 5.0]), np.array([100.0, 10.0])
    )
    assert energy == pytest.approx(55.0, rel=1e-15)
    assert 0 < rounding < 1e-12


def test_the_rounding_of_an_energy_bounds_what_exact_numbers_say():
    from fractions import Fraction

    rng = np.random.default_rng(3)
    for _ in range(50):
        positions = rng.normal(size=(2, 3))
        bar = np.array([[0, 1]])
        rest = _bars.lengths(positions, bar) * (1 + rng.normal() * 1e-8)
        energy, rounding = _bars.harmonic_energy(positions, bar, rest, np.array([1e5]))
        squared = sum(
            (Fraction(float(a)) - Fraction(float(b))) ** 2 for a, b in zip(*positions, strict=True)
        )
        # r = sqrt(squared) to 40 digits, by integers
        scale = 10**40
        length = Fraction(int_root(squared * scale**2), scale)
        exact = Fraction(1e5) / 2 * (length - Fraction(float(rest[0]))) ** 2
        assert abs(energy - float(exact)) <= rounding


def int_root(value):
    import math

    return math.isqrt(value.numerator // value.denominator)


def test_a_stretched_copy_has_one_bar_too_long_by_so_much():
    rest = np.array([3.0, 4.0, 3.0, 5.0])
    copy = _bars.stretched(SQUARE, BARS, rest, bar=2, by=1e-3)
    assert _bars.lengths(copy, BARS)[2] == pytest.approx(3.003, rel=1e-14)
    assert (copy != SQUARE).any(axis=1).tolist() == [False, False, False, True]


def test_displacements_are_those_of_the_seed_and_of_the_size():
    many = np.zeros((20000, 3))
    first = _bars.displaced(many, 0.1, seed=5)
    assert np.array_equal(first, _bars.displaced(many, 0.1, seed=5))
    assert not np.array_equal(first, _bars.displaced(many, 0.1, seed=6))
    assert first.std() == pytest.approx(0.1, rel=0.02)
    assert abs(first.mean()) < 0.002


def slow_triangles(bars, count):
    around = {j: set() for j in range(count)}
    for a, b in bars:
        around[a].add(b)
        around[b].add(a)
    found = {
        tuple(sorted({a} | around[a]))
        for a in around
        if len(around[a]) == 2 and all(around[b] | {b} == around[a] | {a} for b in around[a])
    }
    return sorted(found)


@pytest.mark.parametrize(
    "bars",
    [
        [[0, 1], [1, 2], [0, 2]],
        [[0, 1], [1, 2], [0, 2], [2, 3]],  # one corner is held by a fourth bar
        [[5, 3], [3, 4], [4, 5], [0, 1], [1, 2], [2, 0]],
        [[0, 1], [1, 2], [2, 3], [3, 0]],
        [[0, 1]],
    ],
)
def test_isolated_triangles(bars):
    found = _bars.isolated_triangles(np.array(bars), 6)
    assert [tuple(t) for t in found.tolist()] == slow_triangles(bars, 6)


def test_isolated_triangles_of_random_graphs():
    rng = np.random.default_rng(1)
    for _ in range(30):
        pairs = {tuple(sorted(rng.choice(24, 2, replace=False).tolist())) for _ in range(16)}
        bars = np.array(sorted(pairs))
        found = _bars.isolated_triangles(bars, 24)
        assert [tuple(t) for t in found.tolist()] == slow_triangles(bars.tolist(), 24)


def test_bars_of_triangles_whatever_their_sequence_and_direction():
    bars = np.array([[7, 9], [2, 1], [8, 7], [0, 2], [9, 8], [1, 0]])
    triangles = _bars.isolated_triangles(bars, 10)
    own = _bars.bars_of_triangles(triangles, bars, 10)
    for corners, three in zip(triangles, own, strict=True):
        expected = [{corners[0], corners[1]}, {corners[0], corners[2]}, {corners[1], corners[2]}]
        assert [set(bars[k]) for k in three] == expected


def test_settle_moves_nothing_where_it_has_nothing():
    bound = _bars.settle_bound(SQUARE, BARS, np.ones(4), np.ones(4), np.full(4, 1e-6))
    assert bound == 0.0


def test_settle_bound_is_met_by_an_exact_solution():
    """Newton's solution of a triangle with the worst bar errors stays below the bound."""
    water = np.array([[0, 0, 0], [0.9572, 0, 0], [-0.24, 0.9266, 0]])
    bars = np.array([[0, 1], [0, 2], [1, 2]])
    masses = np.array([15.999, 1.008, 1.008])
    rest = _bars.lengths(water, bars)
    tolerance = 1e-4
    bound = _bars.settle_bound(water, bars, rest, masses, np.full(3, tolerance))
    worst = 0.0
    for signs in np.ndindex(2, 2, 2):
        wanted = rest * (1 + tolerance * (2 * np.array(signs) - 1))
        worst = max(worst, _bars.furthest_move(newton(water, bars, wanted, masses), water))
    assert 0.5 * bound < worst <= bound


def newton(positions, bars, wanted, masses):
    """Mass-weighted least move onto the wanted lengths, directions of the start (as SHAKE)."""
    x = positions.copy()
    directions = positions[bars[:, 1]] - positions[bars[:, 0]]
    for _ in range(20):
        rigidity = np.zeros((len(bars), x.size))
        shift = np.zeros((x.size, len(bars)))
        for k, (a, b) in enumerate(bars):
            along = (x[b] - x[a]) / np.linalg.norm(x[b] - x[a])
            rigidity[k, 3 * a : 3 * a + 3], rigidity[k, 3 * b : 3 * b + 3] = -along, along
            shift[3 * a : 3 * a + 3, k] = -directions[k] / masses[a]
            shift[3 * b : 3 * b + 3, k] = directions[k] / masses[b]
        error = wanted - _bars.lengths(x, bars)
        x += (shift @ np.linalg.solve(rigidity @ shift, error)).reshape(x.shape)
    return x


def test_a_flat_triangle_has_no_bound():
    flat = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    bars = np.array([[0, 1], [1, 2], [0, 2]])
    rest = np.array([1.0, 1.0, 2.0])
    assert _bars.settle_bound(flat, bars, rest, np.ones(3), np.full(3, 1e-6)) == np.inf


def test_pairs_of_bars_and_their_angles():
    triples = _bars.bar_pairs(BARS, 4)
    slow = {
        (min(p, q), j, max(p, q))
        for j in range(4)
        for near in [[b if a == j else a for a, b in BARS.tolist() if j in (a, b)]]
        for p in near
        for q in near
        if p != q
    }
    assert {(min(i, k), j, max(i, k)) for i, j, k in triples.tolist()} == slow
    assert len(triples) == len(slow)
    angles = dict(
        zip(map(tuple, triples.tolist()), _bars.angles_between(SQUARE, triples), strict=True)
    )
    by_ends = {frozenset((i, j, k)): angle for (i, j, k), angle in angles.items() if j == 1}
    assert by_ends[frozenset((0, 1, 2))] == pytest.approx(np.pi / 2, rel=1e-15)


def test_a_straight_angle_is_exact():
    line = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    triples = _bars.bar_pairs(np.array([[0, 1], [1, 2]]), 3)
    assert _bars.angles_between(line, triples).tolist() == [np.pi]
