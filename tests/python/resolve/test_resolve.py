# SPDX-License-Identifier: MIT
"""resolve(): in place, and where an independent solver written in numpy ends as well."""

import numpy as np
import pytest

import pliant

TRIANGLE = pliant.Framework([[0, 1], [1, 2], [2, 0]], [1.0, 1.0, 1.0])


def broken(count, seed=1):
    return np.random.default_rng(seed).normal(size=(count, 3))


def test_moves_the_very_array():
    positions = broken(3)
    same = positions
    summary = pliant.resolve(TRIANGLE, positions)
    assert summary.converged
    assert summary.stop is pliant.Stop.converged
    lengths = np.linalg.norm(same - np.roll(same, -1, axis=0), axis=1)
    assert np.abs(lengths - 1).max() <= 1e-6
    assert summary.max_residual == np.abs(pliant.residuals(TRIANGLE, positions)).max()


@pytest.mark.parametrize(
    ("positions", "found"),
    [
        (broken(3).astype(np.float32), "an array of float32 with shape (3, 3)"),
        (broken(3)[:, :2].copy(), "an array of float64 with shape (3, 2)"),
        (broken(6)[::2], "an array of float64 with shape (3, 3) that is not C-contiguous"),
        (broken(3).ravel(), "an array of float64 with shape (9,)"),
        (
            np.asfortranarray(broken(3)),
            "an array of float64 with shape (3, 3) that is not C-contiguous",
        ),
        (broken(3).tolist(), "an object of type list"),
        (broken(3).astype(">f8"), "an array of >f8 with shape (3, 3)"),
    ],
)
def test_refuses_an_array_that_it_would_have_to_copy(positions, found):
    with pytest.raises(TypeError) as caught:
        pliant.resolve(TRIANGLE, positions)
    assert str(caught.value) == (
        "positions: expected a C-contiguous writeable numpy array of float64 with shape (N, 3), "
        "found " + found
    )


def test_refuses_a_read_only_array():
    positions = broken(3)
    positions.flags.writeable = False
    with pytest.raises(TypeError, match="found a read-only array of float64"):
        pliant.resolve(TRIANGLE, positions)


def test_refuses_an_unaligned_array():
    memory = np.zeros(9 * 8 + 4, np.uint8)[4:]
    with pytest.raises(TypeError, match="that is not aligned"):
        pliant.resolve(TRIANGLE, memory.view(np.float64).reshape(3, 3))


def test_refuses_options_by_name():
    for options, message in [
        ({"weighting": 1.5}, "weighting = 1.5: must be from 0 to 1"),
        ({"max_sweeps": 0}, "max_sweeps = 0: must be from 1"),
        ({"tolerance": 0.0}, "tolerance = 0: must be positive and finite"),
    ]:
        with pytest.raises(pliant.OptionError) as caught:
            pliant.resolve(TRIANGLE, broken(3), **options)
        assert str(caught.value) == message
    with pytest.raises(pliant.OptionError, match=r"^positions: 2 for 3 joints$"):
        pliant.resolve(TRIANGLE, broken(2))
    with pytest.raises(IndexError, match=r"^joint 3 of 3 does not exist$"):
        pliant.resolve(TRIANGLE, broken(3), root=3)
    with pytest.raises(pliant.OptionError, match=r'did you mean "bfs_cycle"\?'):
        pliant.resolve(TRIANGLE, broken(3), "bsf_cycle")


def gauss_seidel(framework, positions, sweeps, weighting):
    """Thesis figure 2.4 in plain numpy, in the sequence that pliant.order gives."""
    x = positions.copy()
    bar, near, is_tree = pliant.order(framework)
    for _ in range(sweeps):
        for k, a, tree in zip(bar, near, is_tree, strict=True):
            i, j = framework.bars[k]
            b = j if a == i else i
            delta = x[b] - x[a]
            length = np.linalg.norm(delta)
            excess = (length - framework.rest_lengths[k]) / length * delta
            far_share = weighting if tree else 0.5
            x[a] += (1 - far_share) * excess
            x[b] -= far_share * excess
    return x


def nearest_whole_positions(framework, start):
    """The least move: dense Newton on J (x - start) + C(x) = 0 with x - start in the rows of J."""
    x = start.copy()
    i, j = framework.bars.T
    for _ in range(100):
        delta = x[j] - x[i]
        length = np.linalg.norm(delta, axis=1)
        error = length - framework.rest_lengths
        rows = np.zeros((len(i), *x.shape))
        rows[np.arange(len(i)), i] = -delta / length[:, None]
        rows[np.arange(len(i)), j] = delta / length[:, None]
        rows = rows.reshape(len(i), -1)
        wanted = error + rows @ (start - x).ravel()
        x = start - np.linalg.lstsq(rows, wanted, rcond=None)[0].reshape(x.shape)
    return x


def ring_with_tail(seed=3):
    shape = np.array(
        [[0, 0, 0], [1.5, 0, 0], [2, 1.4, 0.3], [0.7, 2.2, 0.6], [-0.5, 1.3, 0.2], [3.4, 1.8, 0.4],
         [4.1, 3.1, 0.1]]
    )  # fmt: skip  # some points a line
    bars = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [2, 5], [5, 6]]
    framework = pliant.Framework(bars, positions=shape)
    return framework, shape + np.random.default_rng(seed).normal(scale=0.1, size=shape.shape)


@pytest.mark.parametrize("weighting", [0.0, 0.5, 0.75, 1.0])
def test_sweeps_are_those_of_an_independent_gauss_seidel(weighting):
    framework, positions = ring_with_tail()
    expected = gauss_seidel(framework, positions, 5, weighting)
    summary = pliant.resolve(
        framework, positions, "bfs_cycle", weighting, max_sweeps=5, tolerance=1e-14
    )
    assert summary.stop is pliant.Stop.max_sweeps
    assert summary.sweeps == 5
    np.testing.assert_allclose(positions, expected, rtol=0, atol=1e-13)


@pytest.mark.parametrize("technique", [t.name for t in pliant.techniques() if not t.forests_only])
def test_ends_near_the_nearest_whole_positions(technique):
    framework, positions = ring_with_tail()
    start = positions.copy()
    summary = pliant.resolve(framework, positions, technique, tolerance=1e-10)
    assert summary.converged
    assert np.abs(pliant.residuals(framework, positions)).max() <= 1e-9
    nearest = nearest_whole_positions(framework, start)
    assert np.abs(pliant.residuals(framework, nearest)).max() <= 1e-12
    moved, least = np.linalg.norm(positions - start), np.linalg.norm(nearest - start)
    # Sharing each correction half and half stays near; an outward pass carries all to the leaves.
    sweeps = technique in {ordering.name for ordering in pliant.orderings()}
    assert least <= moved <= (1.1 if sweeps else 1.5) * least


def test_a_resolver_does_what_the_function_does():
    framework, positions = ring_with_tail()
    resolver = pliant.Resolver(framework, "random", 0.75, seed=7)
    for step in range(3):
        one, other = positions.copy(), positions.copy()
        summary = resolver.resolve(one, root=2, step=step)
        again = pliant.resolve(framework, other, "random", 0.75, seed=7, root=2, step=step)
        assert one.tobytes() == other.tobytes()
        assert (summary.sweeps, summary.projections) == (again.sweeps, again.projections)


def test_a_resolver_keeps_its_framework_alive():
    resolver = pliant.Resolver(pliant.Framework([[0, 1]], [2.0]), "bfs_cycle")
    positions = np.array([[0, 0, 0], [1.0, 0, 0]])
    assert resolver.resolve(positions).converged
    assert positions.tolist() == [[-0.5, 0, 0], [1.5, 0, 0]]


def test_measure():
    framework = pliant.Framework([[0, 1], [1, 2]], [2.0, 1.0])
    found = pliant.measure_bars(framework, [[0, 0, 0], [2.5, 0, 0], [2.5, 0.5, 0]])
    assert (found.max_relative, found.worst_bar, found.max_length) == (0.5, 1, 0.5)
    assert found.rms_relative == pytest.approx(np.sqrt((0.25**2 + 0.5**2) / 2))
    assert found.finite
    assert not found.within
    at = [[0, 0, 0], [2, 0, 0], [2, 1, 0]]
    assert pliant.measure_bars(framework, at).within
    assert pliant.measure_bars(
        framework, [[0, 0, 0], [2.1, 0, 0], [2.1, 1, 0]], tolerance_length=0.2
    ).within
    with pytest.raises(pliant.InputError, match=r"^positions: 2 for 3 joints$"):
        pliant.measure_bars(framework, [[0, 0, 0], [1, 1, 1]])


def pushed_chain(count, *joints):
    """A staircase of unit bars, some joints of it moved a little."""
    places = np.cumsum(np.tile([[1.0, 0, 0], [0, 1.0, 0]], (count // 2, 1)), axis=0)
    framework = pliant.Framework([[k, k + 1] for k in range(count - 1)], positions=places)
    positions = places.copy()
    positions[list(joints)] += [0.02, 0.03, -0.05]
    return framework, positions


@pytest.mark.parametrize("technique", ["blocks", "auto"])
def test_looks_near_what_was_disturbed(technique):
    framework, positions = pushed_chain(400, 50, 200)
    pushed = positions.copy()
    resolver = pliant.Resolver(framework, technique)
    summary = resolver.resolve(positions, 50, disturbed=[50, 200])
    assert summary.converged
    assert summary.rms_residual == -1
    assert np.abs(pliant.residuals(framework, positions)).max() <= 1e-6
    changed = np.flatnonzero((positions != pushed).any(axis=1))
    assert set(changed) <= set(resolver.moved)
    assert 350 not in resolver.moved


def test_near_is_where_one_joint_was_disturbed():
    framework, positions = pushed_chain(100, 30)
    whole = positions.copy()
    resolver = pliant.Resolver(framework, "blocks")
    assert resolver.moved is None
    near = resolver.resolve(positions, 30, step=4, disturbed=[30])
    assert len(resolver.moved) > 0
    assert resolver.resolve(whole, 30, step=4).projections > near.projections
    assert resolver.moved is None


def test_names_what_is_no_joint_among_the_disturbed():
    framework, positions = pushed_chain(20, 3)
    resolver = pliant.Resolver(framework)
    with pytest.raises(pliant.InputError, match="disturbed"):
        resolver.resolve(positions, disturbed=[3, 20])
    with pytest.raises(IndexError, match="joint 20 of 20"):
        resolver.resolve(positions, 20, disturbed=[3])
