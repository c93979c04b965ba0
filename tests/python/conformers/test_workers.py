# SPDX-License-Identifier: MIT
"""Processes that work on a library may end at any time: what they worked on is named."""

import multiprocessing
import time

import pytest

pytest.importorskip("rdkit")
from libraries import library
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import read_records
from pliant.jobs.conformers.workers import outcomes

OPTIONS = ConformerOptions(frames=20, starts=1, max=2, energy="none")


@pytest.fixture
def records(tmp_path):
    (tmp_path / "library.sdf").write_text(library(12))
    return list(read_records(tmp_path / "library.sdf"))


def test_a_process_that_ends_costs_one_molecule(records):
    found = outcomes(records, OPTIONS, 2, False)
    all_of_them = [next(found)]
    for child in multiprocessing.active_children():
        child.kill()
    all_of_them += found
    assert [one.number for one in all_of_them] == list(range(1, 13))
    failed = [one for one in all_of_them if one.reason]
    assert len(failed) <= 2
    for one in failed:
        assert one.reason == "the process that worked on it ended with code -9"
    assert sum(one.conformers > 0 for one in all_of_them) >= 10


def test_no_process_is_left_behind(records):
    found = outcomes(records, OPTIONS, 2, False)
    next(found)
    found.close()
    while multiprocessing.active_children():
        time.sleep(0.05)
