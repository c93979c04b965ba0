# SPDX-License-Identifier: MIT
"""Many walkers at once: the same bits as one by one, in place on numpy memory."""

import numpy as np
import pytest

import pliant

SHAPE = np.array(
    [[0, 0, 0], [1.5, 0, 0], [2, 1.4, 0.3], [0.7, 2.2, 0.6], [-0.5, 1.3, 0.2], [3.4, 1.8, 0.4],
     [4.1, 3.1, 0.1]]
)  # fmt: skip  # some points a line
BARS = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [2, 5], [5, 6]]
FRAMEWORK = pliant.Framework(BARS, positions=SHAPE)


def broken(count, seed=3):
    return SHAPE + np.random.default_rng(seed).normal(scale=0.1, size=(count, *SHAPE.shape))


@pytest.mark.parametrize("technique", [t.name for t in pliant.techniques() if not t.forests_only])
@pytest.mark.parametrize("lanes", [False, True])
def test_each_ends_as_alone(technique, lanes):
    together = broken(11)
    alone = together.copy()
    resolver = pliant.WalkerResolver(FRAMEWORK, technique, seed=5, lanes=lanes)
    summaries = resolver.resolve(
        together, root=2, step=4, first_walker=7, reference=SHAPE, measured="rms_residual"
    )
    for k, positions in enumerate(alone):
        expected = pliant.resolve(
            FRAMEWORK, positions, technique, seed=5, walker=7 + k, root=2, step=4, reference=SHAPE
        )
        assert together[k].tobytes() == positions.tobytes()
        for name in ("stop", "sweeps", "projections", "max_residual", "rms_residual", "worst_bar"):
            assert getattr(summaries[k], name) == getattr(expected, name)


def test_every_level_of_instructions_gives_the_same_bits():
    answers = set()
    for level in pliant.lane_levels():
        positions = broken(8)
        resolver = pliant.WalkerResolver(FRAMEWORK, "blocks", level=level)
        assert resolver.level == level
        resolver.resolve(positions)
        answers.add(positions.tobytes())
    assert len(answers) == 1
    assert pliant.lane_levels()[-1] == "portable"


def test_other_memory_is_refused():
    resolver = pliant.WalkerResolver(FRAMEWORK, "blocks")
    with pytest.raises(TypeError, match=r"float64 with shape \(K, N, 3\), found an array of int64"):
        resolver.resolve(np.zeros((2, 7, 3), dtype=int))
    with pytest.raises(TypeError, match=r"found an array of float64 with shape \(7, 3\)"):
        resolver.resolve(SHAPE.copy())
    with pytest.raises(pliant.OptionError, match="positions: 5 for 7 joints"):
        resolver.resolve(np.zeros((2, 5, 3)))
    with pytest.raises(pliant.OptionError, match="lane level = v9: must be one of"):
        pliant.WalkerResolver(FRAMEWORK, "blocks", level="v9")
    with pytest.raises(pliant.OptionError, match="measured = all: must be nothing, max_residual"):
        resolver.resolve(broken(2), measured="all")


def test_no_walker_is_no_error():
    assert pliant.WalkerResolver(FRAMEWORK, "blocks").resolve(np.empty((0, 7, 3))) == []
