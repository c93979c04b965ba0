# SPDX-License-Identifier: MIT
"""Samples that version 0.3.0 wrote: it recorded the contact energy as a temperature (kJ/mol).

``tests/golden/version_0_3_0`` was made by that version::

    pliant sample data/molecules/cyclic_hexapeptide.pdb -o diluted.h5md --frames 3 --seed 5 \\
      --sampler dilute --temperature 40 --amplitude 0.4 --topology none      (then gzipped)

Careful steps have led to other frames since, so that these do not go on.
"""

import gzip
from pathlib import Path

import h5py
import pytest

FILES = Path(__file__).parents[1] / "golden" / "version_0_3_0"


@pytest.fixture
def recorded(tmp_path):
    path = tmp_path / "diluted.h5md"
    path.write_bytes(gzip.decompress((FILES / "diluted.h5md.gz").read_bytes()))
    with h5py.File(path) as file:
        assert file["parameters/sample/temperature"][()] == 40.0
    return path


def test_a_sample_of_other_frames_is_not_continued(pliant, recorded):
    ended = pliant("sample", "--continue", recorded, "--frames", 9, "--quiet")
    assert ended.code == 1
    assert "is not what the run gives now: it was written by another version of Pliant" in ended.err
    with h5py.File(recorded) as file:
        assert len(file["particles/trajectory/position/value"]) == 3


def test_its_energy_is_compared_in_the_unit_of_today(pliant, recorded):
    words = ("sample", "--continue", recorded, "--quiet", "--contact-energy")
    assert pliant(*words, repr(40 / 4.184)).code == 0
    ended = pliant(*words, 9)
    assert ended.code == 2
    assert "--contact-energy: is 9.560229445506693 in the run of" in ended.err
