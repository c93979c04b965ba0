# SPDX-License-Identifier: MIT
"""Flipped bits and broken structures of H5MD files never end the process that reads them.

Each file is read by every reader in a process of its own, within a time and a size of memory: it is
read, or refused with an exception of ours.
"""

import contextlib

import pytest
from damaged_h5md import damages, death_of
from pliant.trajectory.opened import one_file
from pliant.trajectory.recover.recover import recover
from pliant.trajectory.universe import open_universe

import pliant

WATER = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    path = tmp_path_factory.mktemp("good") / "good.h5md"
    pliant.run(pliant.read_text(WATER, "water.xyz"), output=path, steps=8)
    return path


def with_ours(path):
    frames = one_file(path)
    for frame in range(min(len(frames), 20)):
        frames.moment(frame)
    _ = frames.parameters, frames.framework, frames.structure, frames.contacts


def with_mdanalysis(path):
    for _ in open_universe(path).trajectory[:5]:
        pass


def with_every_reader(path):
    for read in (with_ours, with_mdanalysis):
        # MDAnalysis raises what it likes when it reads frames.
        errors = Exception if read is with_mdanalysis else (pliant.Error, OSError)
        with contextlib.suppress(errors):
            read(path)


def read_damaged(whole, tmp_path, flips, breaks):
    path = tmp_path / "damaged.h5md"
    deaths = {}
    for what, damaged in damages(whole, flips, breaks):
        path.write_bytes(damaged)
        if death := death_of(lambda: with_every_reader(path)):
            deaths[what] = death
    assert deaths == {}


def test_the_whole_file_is_read(good):
    assert death_of(lambda: [with_ours(good), with_mdanalysis(good)]) == ""


def test_no_damage_kills_a_reader(good, tmp_path):
    read_damaged(good.read_bytes(), tmp_path, 10, 5)


@pytest.mark.long
@pytest.mark.timeout(7200)
def test_no_damage_of_many_kills_a_reader(good, tmp_path):
    read_damaged(good.read_bytes(), tmp_path, 10_000, 1000)


@pytest.mark.parametrize("count", [2, pytest.param(8, marks=pytest.mark.long)])
def test_no_damage_kills_recover(good, tmp_path, count):
    path, out = tmp_path / "damaged.h5md", tmp_path / "out.h5md"

    def save():
        with contextlib.suppress(pliant.InputError):
            recover(path, out, overwrite=True)
            with_ours(out)

    for what, damaged in damages(good.read_bytes(), count, count):
        path.write_bytes(damaged)
        assert death_of(save) == "", what
