# SPDX-License-Identifier: MIT
"""--precision: recorded positions are rounded, and nothing else is."""

import json

import h5py
import numpy as np
import pytest
from real_files import PEPTIDE

POSITION = "particles/trajectory/position/value"


def recorded(path):
    with h5py.File(path) as file:
        observables = {k: v["value"][:] for k, v in file["observables"].items()}
        return file[POSITION][:], dict(file[POSITION].attrs), observables


@pytest.fixture
def runs(pliant, tmp_path):
    """The same run as it is, and rounded."""
    words = ("run", PEPTIDE, "--model", "bonds", "--perturb", "displacement", "--steps", 30)
    for name, more in (("plain", ()), ("rounded", ("--precision", "1e-3"))):
        assert pliant(*words, "-o", f"{name}.h5md", *more).code == 0
    return recorded(tmp_path / "plain.h5md"), recorded(tmp_path / "rounded.h5md")


def test_positions_are_off_by_half_of_it_at_most(runs):
    (plain, _, _), (rounded, attributes, _) = runs
    unit = attributes["rounded_to"]
    assert unit == 2.0**-10  # the largest power of two that is not above 1e-3
    assert np.all(rounded / unit == np.round(rounded / unit))
    assert 0.4 * unit < np.abs(rounded - plain).max() <= 0.5 * unit


def test_what_is_reported_of_frames_is_of_before_the_rounding(runs):
    (_, _, plain), (_, _, rounded) = runs
    for name in plain:
        assert np.array_equal(plain[name], rounded[name]), name


def test_it_takes_less_room(runs, tmp_path):
    sizes = [(tmp_path / f"{name}.h5md").stat().st_size for name in ("plain", "rounded")]
    assert sizes[1] < 0.75 * sizes[0]


@pytest.mark.long
def test_the_report_and_the_check_allow_for_it(pliant, runs, tmp_path):
    ended = pliant("analyse", "rounded.h5md", "--json")
    verdict = json.loads(ended.out)["verdicts"]["bars"]
    assert verdict["text"] == "Every bar of every frame is within tolerance."
    text = pliant("analyse", "rounded.h5md").err
    assert "note: bars are judged after rounding of coordinates to 0.001 Angstrom\n" in text
    assert "rounding" not in pliant("analyse", "plain.h5md").err
    # A frame that is not whole by more than rounding can do is found all the same.
    with h5py.File(tmp_path / "rounded.h5md", "r+") as file:
        file[POSITION][7, 40] += 0.02
    ended = pliant("analyse", "rounded.h5md", "--json", "-o", "again")
    assert "1 of 31 frames have a bar beyond" in json.loads(ended.out)["verdicts"]["bars"]["text"]


@pytest.mark.parametrize(("value", "code"), [("-1", 2), ("1.5", 2), ("nan", 2), ("0", 0)])
def test_what_precision_can_be(pliant, ethanol, value, code):
    ended = pliant("run", ethanol, f"--precision={value}", "--steps", 2)
    assert ended.code == code
    assert "--precision" in ended.err if code else True


def test_it_goes_with_h5md(pliant, ethanol):
    ended = pliant("run", ethanol, "--precision", "1e-3", "-o", "x.pdb", "--steps", 2)
    assert ended.code == 2
    assert ended.err.endswith("--precision: goes with H5MD, not with the PDB file x.pdb\n")
