# SPDX-License-Identifier: MIT
"""GROMACS at work: it pushes as it is asked to, and whatever becomes of it is reported."""

import numpy as np
import pytest
from pliant.lab.peers import gromacs
from pliant.lab.peers.gromacs import Gromacs, Program, Setting, lincs_settings

from pliant.measure import bars as _bars

COUNT = 3000  #: joints, of which all but the first two are free


@pytest.fixture(scope="module")
def scattered():
    """Free joints of two masses, and one bar."""
    positions = np.random.default_rng(1).uniform(-20, 20, (COUNT, 3))
    positions[:2] = [[0, 0, 0], [1, 0, 0]]
    masses = np.where(np.arange(COUNT) % 2, 1.008, 32.06)
    with Gromacs(positions, masses, np.array([[0, 1]]), np.array([1.0]), push=0.1) as molecule:
        molecule.start, molecule.heavy = positions, masses > 2
        yield molecule


def pretender(tmp_path, script):
    """A program that is not GROMACS."""
    path = tmp_path / "gmx"
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return Program(str(path), "double", "0", "")


@pytest.mark.parametrize("precision", list(gromacs.NAMES))
def test_all_masses_are_pushed_alike_by_what_was_asked(scattered, precision):
    found = [program for program in gromacs.programs() if program.precision == precision]
    if not found:
        pytest.skip(f"GROMACS ({gromacs.NAMES[precision]}) is not installed")
    run = scattered.run(found[0], Setting("shake", tolerance=1e-4), 10, 1, 60.0)
    assert not run.failure and len(run.frames) == 10
    frames = np.array(run.frames)[:, 2:]
    moves, heavy = np.diff(frames[4:], axis=0), scattered.heavy[2:]
    # 5 frames of 1500 joints of 3 coordinates: a standard deviation is known to 0.5 %.
    assert np.std(moves[:, heavy]) == pytest.approx(0.1, rel=0.03)
    assert np.std(moves[:, ~heavy]) == pytest.approx(0.1, rel=0.03)
    there = scattered.start[2:] - scattered.start.mean(axis=0)
    off = frames[5:] - frames[5:].mean(axis=(0, 1)) - (there - there.mean(axis=0))
    assert np.std(off) == pytest.approx(0.1, rel=0.03)  # and stay where they were
    bar = _bars.lengths(run.frames[-1], np.array([[0, 1]]))
    assert bar == pytest.approx([1.0], rel=1.1e-4)


def test_how_it_ended_is_reported(scattered, tmp_path):
    text = "Source file: a.cpp (line 1)\n\nFatal error:\nToo many LINCS warnings (1000)"
    run = scattered.run(
        pretender(tmp_path, f"echo '{text}' >&2; exit 1"), Setting("lincs"), 9, 1, 9
    )
    assert run.failure == "Too many LINCS warnings (1000)" and run.frames == []
    run = scattered.run(pretender(tmp_path, "exit 3"), Setting("lincs"), 9, 1, 9)
    assert run.failure == "grompp ended with 3"
    run = scattered.run(pretender(tmp_path, "echo nothing > bars.log"), Setting("lincs"), 9, 1, 9)
    assert run.failure.startswith("mdrun's files cannot be read: the log has no row of times")


def test_who_takes_too_long_is_stopped(scattered, tmp_path):
    run = scattered.trial(pretender(tmp_path, "exec sleep 60"), Setting("lincs"), 0.2)
    assert run.failure == "grompp took more than 0.2 s"


def test_where_it_is_not_installed_there_is_none(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert gromacs.programs() == []
    pretender(tmp_path, "echo nonsense")
    assert gromacs.programs() == []
    pretender(tmp_path, "echo 'GROMACS version:    2030.1'; echo 'SIMD instructions:  AVX_512'")
    assert gromacs.programs() == [Program(str(tmp_path / "gmx"), "single", "2030.1", "AVX_512")]


def test_settings_of_lincs_do_more_and_more():
    iterations = [setting.iterations for setting in lincs_settings(4)]
    assert iterations == sorted(set(iterations)) and iterations[0] == 1
