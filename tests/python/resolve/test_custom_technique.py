# SPDX-License-Identifier: MIT
"""Techniques written in Python: a function that makes one sweep."""

import gc
import weakref
from pathlib import Path

import h5py
import numpy as np
import pytest

import pliant

DATA = Path(__file__).resolve().parents[3] / "data"
RING = next(example for example in pliant.examples() if example.name == "ring_6")


def jacobi(positions, sweep, framework):
    """All bars at once: each joint moves by the mean of what its bars ask for."""
    near, far = framework.bars.T
    along = positions[far] - positions[near]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    share = 0.5 * (1 - framework.rest_lengths[:, None] / length) * along
    move, bars = np.zeros_like(positions), np.zeros(len(positions))
    for joint, by in ((near, share), (far, -share)):
        np.add.at(move, joint, by)
        np.add.at(bars, joint, 1)
    positions += move / np.maximum(bars, 1)[:, None]


def pushed(example=RING):
    positions = example.positions.copy()
    positions[1] += [0.1, 0.2, 0.3]
    return positions


def test_a_vectorised_sweep_resolves_caffeine():
    structure = pliant.read(DATA / "molecules" / "caffeine.sdf")
    structure.perceive_bonds()
    framework = structure.framework(bars="bonds")
    positions = structure.positions.copy()
    positions[3] += [0.3, 0.0, 0.1]
    seen = []

    def sweep(positions, number, shown):
        assert shown is framework
        assert positions.shape == (framework.joint_count, 3)
        assert positions.flags.writeable
        seen.append(number)
        jacobi(positions, number, shown)

    summary = pliant.resolve(framework, positions, sweep)
    assert summary.converged
    assert seen == list(range(summary.sweeps))
    assert pliant.measure_bars(framework, positions).max_relative <= 1e-6


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize(
    "call",
    [
        lambda f, x, t: pliant.resolve(f, x, t),
        lambda f, x, t: pliant.Resolver(f, technique=t).resolve(x),
        lambda f, x, t: pliant.WalkerResolver(f, technique=t).resolve(x[None]),
        lambda f, x, t: pliant.Motion(f, x, technique=t).start(),
        lambda f, x, t: pliant.run(f, x, technique=t, steps=1),
        lambda f, x, t: pliant.run_ensemble(f, x, technique=t, steps=1, threads=2),
    ],
)
def test_what_it_raises_propagates(call):
    def fail(positions, sweep, framework):
        positions += 1
        raise ZeroDivisionError("of the sweep")

    positions = pushed()
    before = positions.copy()
    with pytest.raises(ZeroDivisionError, match="of the sweep"):
        call(RING.framework, positions, fail)
    np.testing.assert_array_equal(positions, before)
    with pytest.raises(TypeError, match=r"a name in techniques|be a text or a function"):
        call(RING.framework, positions, 3)
    with pytest.raises(TypeError, match="positional argument"):
        call(RING.framework, positions, lambda positions: None)
    with pytest.raises(TypeError, match="returns None, but returned ndarray"):
        call(RING.framework, positions, lambda positions, *_: positions + 1)


def test_motion_run_and_ensemble_agree(tmp_path):
    options = {"technique": jacobi, "seed": 3}
    motion = pliant.Motion(RING.framework, RING.positions, **options)
    motion.start()
    for _ in range(20):
        assert motion.step().converged
    output = tmp_path / "out.h5md"
    summary = pliant.run(RING.framework, RING.positions, output, steps=20, **options)
    np.testing.assert_array_equal(summary.state.positions, motion.state.positions)
    walkers = pliant.run_ensemble(RING.framework, RING.positions, steps=20, threads=2, **options)
    assert all(walker.converged for walker in walkers)
    np.testing.assert_array_equal(walkers[0].state.positions, motion.state.positions)
    with h5py.File(output) as file:
        assert file["parameters/run/technique"].asstr()[()] == "custom"
        assert file["parameters/run/technique_used"].asstr()[()] == "custom"


def test_it_is_in_no_table():
    assert "custom" not in [row.name for row in pliant.techniques()]
    with pytest.raises(pliant.OptionError, match="custom"):
        pliant.resolve(RING.framework, pushed(), "custom")


def test_an_array_that_is_kept_moves_nothing():
    kept = []

    def keep(positions, sweep, framework):
        jacobi(positions, sweep, framework)
        kept.append(positions)

    positions = pushed()
    pliant.resolve(RING.framework, positions, keep)
    before = positions.copy()
    for array in kept:
        array += 1
    np.testing.assert_array_equal(positions, before)


@pytest.mark.parametrize("kind", [pliant.Resolver, pliant.WalkerResolver, pliant.Motion])
def test_what_holds_its_own_resolver_is_freed(kind):
    class Owner:
        def __init__(self):
            start = [RING.positions] if kind is pliant.Motion else []
            self.resolver = kind(RING.framework, *start, technique=self.sweep)

        def sweep(self, positions, sweep, framework):
            jacobi(positions, sweep, framework)

    gone = weakref.ref(Owner())
    gc.collect()
    assert gone() is None
