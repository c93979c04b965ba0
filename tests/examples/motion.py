# SPDX-License-Identifier: MIT
"""A motion with two pushers and a hand at the mouse; an ensemble in two halves."""

import threading

import numpy as np

import pliant

ring = next(example for example in pliant.examples() if example.name == "ring_6")


def breeze(step, positions, previous):
    positions[0, 2] += 0.01 * (step % 2)
    return [0]  # the joints that moved


motion, hand = pliant.Motion(ring.framework, ring.positions, push="force"), pliant.Steering()
motion.add(breeze)
motion.add(hand)
threading.Thread(target=hand.pull, args=([(2, (0.0, 0.0, 40.0))],)).start()
assert all(motion.step().converged for _ in range(100))


def ends(*shard):
    ended = pliant.run_ensemble(ring.framework, ring.positions, shard, steps=50, threads=2)
    return [summary.state.positions for summary in ended]


np.testing.assert_array_equal(ends(0, 8), ends(0, 4) + ends(4, 8))
