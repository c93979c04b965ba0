# SPDX-License-Identifier: MIT
"""pliant run --rock, --pull and --pair-distance: what they say, record and refuse."""

import json

import h5py
import pytest
from h5md_contents import assert_same_runs
from real_files import PEPTIDE

MODEL = ["run", PEPTIDE, "--model", "protein"]


def test_pulls_and_pairs_are_reported_with_what_came_of_them(pliant):
    words = ["--pull", "resid 20", "0,-1,0.5", "--pair-distance", "resid 3", "resid 18", "20..22"]
    ended = pliant(*MODEL, *words, "-o", "o.h5md")
    assert ended.code == 0, ended.err
    assert "auto: froda (limits beside rigid units: torsions that know them)" in ended.out
    assert "pulled          resid 20: 1.12 A away at first, 0.0" in ended.out
    assert "pair distance   resid 3 - resid 18: 25.40 A at first, 2" in ended.out
    assert ", 20 to 22 A asked for\n" in ended.out


def test_what_does_not_arrive_ends_with_3(pliant, tmp_path):
    ended = pliant(
        *MODEL, "--pair-distance", "resid 1", "resid 2", 20, "--steps", 20, "--json", "-o", "o.h5md"
    )
    assert ended.code == 3
    pair = json.loads(ended.out)["pair_distances"][0]
    assert not pair["is_reached"] and pair["least"] == pair["most"] == 20.0
    assert pair["reached"] < 12.0
    with h5py.File(tmp_path / "o.h5md") as file:
        assert file["parameters/run/perturb"][()] == b"pair_distance"
        assert file["parameters/guide/pair_distance"][()] == b"resid 1 | resid 2 | 20"


def test_rocking_goes_on_with_the_bits_of_one_run(pliant, tmp_path):
    words = ["--rock", 2, "--amplitude", 0.8, "--pull", "resid 1", "1,1,0"]
    pliant(*MODEL, *words, "-o", "whole.h5md", "--steps", 10)
    pliant(*MODEL, *words, "-o", "part.h5md", "--steps", 4)
    ended = pliant("run", "--continue", "part.h5md", "--steps", 10)
    assert (ended.code, ended.err) == (0, "")
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")
    ended = pliant("run", "--continue", "part.h5md", "--steps", 12, "--rock", 3)
    assert ended.code == 2
    assert "--rock: is 2 in the run of part.h5md, not 3; a run goes on as it began" in ended.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--pull", "resid 99", "1,0,0"], '--pull: "resid 99" selects no atom'),
        (["--pull", "resid 1", "1,0"],
         '--pull: expected a vector X,Y,Z in Angstrom, found "1,0"'),
        (["--pull", "resid 1", "1,0,x"],
         '--pull: expected a vector X,Y,Z in Angstrom, found "1,0,x"'),
        (["--pair-distance", "resid 1", "resid 2", "-3"],
         '--pair-distance: expected a distance such as 25, or 20..30, in Angstrom, found "-3"'),
        (["--pair-distance", "resid 1", "resid 2", "30..20"],
         '--pair-distance: expected a distance such as 25, or 20..30, in Angstrom, found "30..20"'),
        (["--amplitude", 2], "--amplitude: goes with --rock"),
        (["--rock", 1, "--perturb", "force"],
         "--perturb: goes with neither --rock, --pull nor --pair-distance"),
        (["--rock", 1, "--walkers", 2],
         "--walkers: all would go the same way with --rock, --pull or --pair-distance"),
        (["--rock", 60], "mode = 60: must be from 1 to "),
        (["--pull", "resid 1", "1,0,0", "--displacement", 0],
         "displacement = 0: must be above 0 to pull by it"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_makes_no_sense_is_refused(pliant, tmp_path, words, said):
    ended = pliant(*MODEL, *words, "-o", "o.h5md")
    assert ended.code == 2
    assert said in ended.err
    assert not (tmp_path / "o.h5md").exists()
