# SPDX-License-Identifier: MIT
"""Mean, mode and standard deviation of tables whose answer is known, and their bootstrap."""

import statistics

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pliant.lab.experiment.statistics import (
    Evidence,
    Sample,
    interval,
    number,
    resampling,
    shown,
    statistics_of,
)


def stats(rows, replicates=200):
    rows = np.asarray(rows)
    graphs = np.indices(rows.shape)[0]
    counts = resampling(len(rows), replicates, seed=1)
    return statistics_of(Sample(rows.reshape(-1), graphs.reshape(-1), counts))


@settings(deadline=None)
@given(st.lists(st.lists(st.integers(1, 50), min_size=3, max_size=3), min_size=2, max_size=6))
def test_the_sample_itself_against_the_standard_library(rows):
    found = stats(rows, replicates=3)
    flat = sorted(value for row in rows for value in row)
    assert found.mean[0] == pytest.approx(statistics.mean(flat), rel=1e-12)
    assert found.sd[0] == pytest.approx(statistics.stdev(flat), rel=1e-9, abs=1e-12)
    assert found.mode[0] == min(statistics.multimode(flat))


def test_equal_numbers_have_no_spread_at_all():
    found = stats([[7] * 5] * 4)
    assert set(found.mean) == {7} and set(found.sd) == {0} and set(found.mode) == {7}


def test_whole_graphs_are_resampled():
    """Two graphs of constant numbers: a replicate's mean is of 0, 1 or 2 draws of the second."""
    found = stats([[2] * 50, [4] * 50])
    assert set(found.mean) == {2, 3, 4}
    assert np.mean(found.mean == 3) == pytest.approx(0.5, abs=0.12)
    assert interval(found.mean) == (2, 4)


def test_the_interval_covers_the_truth_as_often_as_it_says():
    """Graph means drawn around 10; 95 % intervals of 20 graphs should hold it in 19 of 20."""
    draws = np.random.default_rng(0)
    covered = 0
    for _ in range(100):
        rows = np.rint(100 * (10 + draws.normal(size=(20, 1)) + draws.normal(size=(20, 5))))
        low, high = interval(stats(rows.astype(int), replicates=300).mean)
        covered += low <= 1000 <= high
    assert 85 <= covered <= 99


def test_pushes_that_broke_nothing_are_left_out(made_table):
    evidence = Evidence(made_table({("tree", "bfs_tree", 1.0): [[1, 0, 1], [0, 1, 1]]}))
    found = evidence.of("tree", "bfs_tree", 1.0)
    assert found.mean[0] == 1 and found.sd[0] == 0 and len(found.values) == 4


def test_classes_of_a_family_are_pooled(made_table):
    sweeps = {"1-cycle-bar": [[2, 2]], "1-cycle-ring": [[4, 4]]}
    evidence = Evidence(
        made_table({(name, "bfs_cycle", 0.5): rows for name, rows in sweeps.items()})
    )
    assert evidence.of("1-cycle", "bfs_cycle", 0.5).mean[0] == 3
    assert evidence.of("2-cycle", "bfs_cycle", 0.5) is None


def test_numbers_in_words():
    assert number(3) == "3" and number(3.14159) == "3.14" and number(1234.5) == "1234"
    assert shown(np.array([2.0, 1.0, 1.0, 3.0, 3.0])) == "2 [1, 3]"
