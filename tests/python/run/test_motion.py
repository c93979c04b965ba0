# SPDX-License-Identifier: MIT
"""One walker step by step, pushers from Python, steering from threads, ensembles."""

import runpy
import threading
from pathlib import Path

import numpy as np
import pytest

import pliant

RING = next(example for example in pliant.examples() if example.name == "ring_6")
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def motion_of(push="force", **options):
    return pliant.Motion(RING.framework, RING.positions, "bfs_cycle", push=push, **options)


def test_the_example_runs():
    runpy.run_path(str(EXAMPLES / "motion.py"))


@pytest.mark.parametrize("push", ["force", "force_all", "displacement"])
def test_it_steps_as_a_run_does(push):
    seen = []
    run = {"technique": "bfs_cycle", "perturb": push, "seed": 4, "walker": 2, "steps": 10}
    pliant.run(
        RING.framework,
        RING.positions,
        observers=[lambda frame: seen.append(frame.positions.copy())],
        **run,
    )
    motion = motion_of(push, seed=4, walker=2)
    frames = [motion.start().positions.copy()]
    frames += [motion.step().positions.copy() for _ in range(10)]
    np.testing.assert_array_equal(seen, frames)
    assert motion.summary.steps == motion.state.step == 10
    assert not motion.is_over


def test_the_state_is_a_copy_that_may_be_changed():
    state = pliant.State(RING.positions)
    motion = pliant.Motion(RING.framework, state, "blocks")
    motion.step()
    np.testing.assert_array_equal(state.positions, RING.positions)
    motion.state.positions[3] += 0.3
    frame = motion.step()
    assert frame.converged
    assert pliant.measure_bars(RING.framework, frame.positions).max_relative <= 1e-6


def test_a_pusher_in_python_moves_what_it_says():
    calls = []

    def lift(step, positions, previous):
        calls.append((step, positions.copy(), previous.copy()))
        positions[2, 2] += 0.05
        return [2]

    motion = motion_of([])
    motion.add(lift)
    frame = motion.step()
    assert frame.root_joint == 2
    assert frame.converged
    motion.step()
    assert [step for step, _, _ in calls] == [1, 2]
    np.testing.assert_array_equal(calls[0][1], RING.positions)
    np.testing.assert_array_equal(calls[1][1], calls[1][2])


def test_a_pusher_in_python_may_say_nothing_or_that_nothing_moved():
    def shake(step, positions, previous):
        positions += 0.01 * step

    motion = motion_of([])
    motion.add(shake)
    assert motion.step().root_joint == 0
    motion = motion_of([])
    motion.add(lambda *_: [])
    frame = motion.step()
    assert frame.root_joint is None
    np.testing.assert_array_equal(frame.positions, RING.positions)


def test_a_pusher_in_python_cannot_move_pinned_joints():
    bars = [[0, 1], [1, 2]]
    positions = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0]], dtype=float)
    framework = pliant.Framework(bars, positions=positions, pinned=[0])
    motion = pliant.Motion(framework, positions, push=[])

    def everything(step, positions, previous):
        positions += [0.0, 0.1, 0.2]

    motion.add(everything)
    np.testing.assert_array_equal(motion.step().positions[0], positions[0])


@pytest.mark.parametrize("moved", [[99], [-1], ["a"]])
def test_a_pusher_that_fails_leaves_the_state_as_it_was(moved):
    motion = motion_of("force_all")
    motion.step()
    before = motion.state.positions.copy(), motion.state.previous.copy()

    def fail(step, positions, previous):
        positions += 1
        return moved

    motion.add(fail)
    with pytest.raises((pliant.InputError, IndexError, TypeError)):
        motion.step()
    np.testing.assert_array_equal(motion.state.positions, before[0])
    np.testing.assert_array_equal(motion.state.previous, before[1])
    assert motion.state.step == 1


def test_what_is_no_pusher_is_refused():
    with pytest.raises(TypeError, match="expected a Steering or something to be called"):
        motion_of().add(3)
    with pytest.raises(pliant.OptionError, match='no pusher named "tug"'):
        motion_of("tug")


def test_a_step_within_a_step_is_refused():
    motion = motion_of([])
    itself = [motion]
    motion.add(lambda *_: itself[0].step())
    with pytest.raises(RuntimeError, match="a step is under way"):
        motion.step()
    itself.clear()  # a pusher and its motion that hold each other are never freed


def test_steering_pulls_until_released():
    motion, hand = motion_of([], damping=1.0), pliant.Steering()
    motion.add(hand)
    still = motion.step()
    np.testing.assert_array_equal(still.positions, RING.positions)
    thread = threading.Thread(target=hand.pull, args=([(1, (0, 0, 30.0)), (4, (0, 0, 30.0))],))
    thread.start()
    thread.join()
    for _ in range(5):
        assert motion.step().converged
    assert motion.state.positions[1, 2] > 0
    hand.release()
    before = motion.state.positions.copy()
    np.testing.assert_array_equal(motion.step().positions, before)
    with pytest.raises(pliant.OptionError, match="is not finite"):
        hand.pull([(0, (np.nan, 0, 0))])


GUIDED = ["replay", "rock", "pull", "pair_distance"]


def test_the_table_of_pushers():
    names = [row.name for row in pliant.pushers()]
    assert names == [row.name for row in pliant.perturbations()] + GUIDED


def ends(shard, **options):
    ended = pliant.run_ensemble(RING.framework, RING.positions, shard, steps=20, **options)
    return [summary.state.positions for summary in ended]


@pytest.mark.parametrize("technique", ["auto", "bfs_cycle"])
def test_two_halves_are_the_whole(technique):
    options = {"technique": technique, "perturb": "displacement", "seed": 8}
    whole = ends((3, 21), **options)
    halves = ends((3, 10), threads=2, **options) + ends((10, 21), **options)
    np.testing.assert_array_equal(whole, halves)
    alone = pliant.run(RING.framework, RING.positions, steps=20, walker=5, **options)
    np.testing.assert_array_equal(whole[2], alone.state.positions)


def test_observers_of_an_ensemble_keep_their_frames(tmp_path):
    kept = {}

    def observers_of(walker):
        kept[walker] = []
        recorder = pliant.H5mdRecorder(tmp_path / f"{walker}.h5md", RING.framework)
        return [kept[walker].append, recorder]

    ended = ends((0, 3), threads=2, every=10, observers_of=observers_of)
    for walker in range(3):
        assert [frame.step for frame in kept[walker]] == [0, 10, 20]
        np.testing.assert_array_equal(kept[walker][-1].positions, ended[walker])
        np.testing.assert_array_equal(kept[walker][0].positions, RING.positions)
        assert len(pliant.H5mdReader(tmp_path / f"{walker}.h5md")) == 3


def test_an_observer_that_raises_stops_its_walker_alone():
    seen = {}

    def observers_of(walker):
        def look(frame):
            seen[walker] = frame.step
            if walker == 1 and frame.step == 4:
                raise ZeroDivisionError("enough")

        return [look]

    with pytest.raises(ZeroDivisionError, match="enough"):
        ends((0, 3), observers_of=observers_of)
    assert seen == {0: 20, 1: 4, 2: 20}


def test_what_is_no_shard_is_refused():
    with pytest.raises(pliant.OptionError, match="must not end before it begins"):
        ends((3, 2))
    with pytest.raises(pliant.OptionError, match="threads = 0"):
        ends((0, 2), threads=0)
