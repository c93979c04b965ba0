# SPDX-License-Identifier: MIT
"""Samples that version 0.3.0 wrote go on: it recorded the contact energy as a temperature (kJ/mol).

``tests/golden/version_0_3_0`` was made by that version::

    pliant sample data/molecules/cyclic_hexapeptide.pdb -o diluted.h5md --frames 3 --seed 5 \\
      --sampler dilute --temperature 40 --amplitude 0.4 --topology none      (then gzipped)

What follows frame 2 is from the same command with ``--frames 9``.
"""

import gzip
import hashlib
from pathlib import Path

import h5py
import pytest

FILES = Path(__file__).parents[1] / "golden" / "version_0_3_0"
POSITIONS = "8a537655a4b65e8e8f25c8f8b734ac7b20b8e8ba11d27eb6f691f05ccba91e27"  # of nine frames
STATES = [[2, 2], [2, 0], [2, 2], [0, 2], [2, 0], [2, 2], [2, 2], [0, 2], [0, 2]]


@pytest.fixture
def recorded(tmp_path):
    path = tmp_path / "diluted.h5md"
    path.write_bytes(gzip.decompress((FILES / "diluted.h5md.gz").read_bytes()))
    with h5py.File(path) as file:
        assert file["parameters/sample/temperature"][()] == 40.0
    return path


def test_a_sample_with_a_temperature_goes_on_to_the_same_bits(pliant, recorded):
    ended = pliant("sample", "--continue", recorded, "--frames", 9, "--quiet")
    assert (ended.code, ended.err) == (0, "")
    with h5py.File(recorded) as file:
        positions = file["particles/trajectory/position/value"][:]
        assert file["connectivity/contact_states/value"][:].tolist() == STATES
    assert hashlib.sha256(positions.tobytes()).hexdigest() == POSITIONS


def test_its_energy_is_compared_in_the_unit_of_today(pliant, recorded):
    words = ("sample", "--continue", recorded, "--quiet", "--contact-energy")
    assert pliant(*words, repr(40 / 4.184)).code == 0
    ended = pliant(*words, 9)
    assert ended.code == 2
    assert "--contact-energy: is 9.560229445506693 in the run of" in ended.err
