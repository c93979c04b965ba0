# SPDX-License-Identifier: MIT
"""Random numbers against numpy's Philox, bit for bit.

numpy's generator counts up before it makes a block; its counter and key are little end first, as
ours. So the block of counter c is what numpy gives after c - 1 (in 256 bits).
"""

import itertools

import numpy as np
import pytest
import support_program

EDGES = [0, 1, 2**32 - 1, 2**32, 2**63, 2**64 - 2, 2**64 - 1]
FULL = 2**256


def words_of(number, count):
    return [(number >> (64 * k)) & (2**64 - 1) for k in range(count)]


def numpy_block(counter, key):
    """The 256 bits that numpy.random.Philox gives for a counter and a key."""
    number = sum(word << (64 * k) for k, word in enumerate(counter))
    before = np.array(words_of((number - 1) % FULL, 4), dtype=np.uint64)
    generator = np.random.Philox(counter=before, key=np.array(key, dtype=np.uint64))
    return generator.random_raw(4).tolist()


def ours(mode, questions):
    lines = support_program.answers("pliant_print_random", [mode], questions)
    return [line.split() for line in lines]


def counters_and_keys():
    draws = np.random.default_rng(20240607)
    words = draws.integers(0, 2**64, size=(2000, 6), dtype=np.uint64).tolist()
    for edge in EDGES:
        words += [[edge if k == place else 0 for k in range(6)] for place in range(6)]
        words.append([edge] * 6)
    return words


def test_blocks_are_numpys_for_any_counter_and_key():
    questions = counters_and_keys()
    answers = ours("philox", [" ".join(map(str, words)) for words in questions])
    for words, block in zip(questions, answers, strict=True):
        assert list(map(int, block)) == numpy_block(words[:4], words[4:]), words


def keys():
    draws = np.random.default_rng(7)
    domains = [1, 2, 3, 4, 5, 6]
    for number in range(60):
        seed, walker, step, joint = draws.integers(0, 2**64, size=4, dtype=np.uint64).tolist()
        yield seed, domains[number % 6], walker % 1000, step % 10**6, joint % 10**5
    yield 0, 1, 0, 0, 0
    yield 2**64 - 1, 6, 2**64 - 1, 2**64 - 1, 2**64 - 1


def numpy_draws(key, count):
    """(step, joint, walker, block) are the counter, (seed, domain) the key; four draws a block."""
    seed, domain, walker, step, joint = key
    blocks = [
        numpy_block([step, joint, walker, block], [seed, domain])
        for block in range((count + 3) // 4)
    ]
    return list(itertools.chain.from_iterable(blocks))[:count]


def numpy_direction(key):
    """Marsaglia 1972 on numpy's draws."""
    bits = iter(numpy_draws(key, 400))
    while True:
        u, v = (2.0 * ((next(bits) >> 11) * 2.0**-53) - 1.0 for _ in range(2))
        s = u * u + v * v
        if s < 1.0:
            root = 2.0 * np.sqrt(1.0 - s)
            return [u * root, v * root, 1.0 - 2.0 * s]


def test_directions_follow_from_numpys_draws_bit_for_bit():
    answers = ours("direction", [" ".join(map(str, key)) for key in keys()])
    for key, direction in zip(keys(), answers, strict=True):
        assert [float.fromhex(x) for x in direction] == numpy_direction(key), key
        assert np.linalg.norm([float.fromhex(x) for x in direction]) == pytest.approx(1, abs=1e-15)
