# SPDX-License-Identifier: MIT
"""pliant run says of a technique that it does not fit before it runs."""

import json
from pathlib import Path

ASPIRIN = Path(__file__).parents[3] / "data" / "molecules" / "aspirin.sdf"
SAID = (
    "technique = random: goes from bar to bar, which does not converge or is slow where bars form "
    "rigid units (angles); use auto, which takes units"
)


def test_a_doubtful_technique_is_announced_before_the_run(pliant):
    ended = pliant("run", ASPIRIN, "--bars", "angles", "--technique", "random", "--dry-run")
    assert ended.code == 0
    assert f"warning: {SAID}\n" in ended.err


def test_it_is_among_the_warnings_of_the_run(pliant):
    words = ("--bars", "angles", "--technique", "random", "--steps", "2", "--max-sweeps", "5")
    ended = pliant("run", ASPIRIN, *words, "-o", "out.h5md", "--json")
    assert ended.code == 3
    assert json.loads(ended.out)["warnings"].count(SAID) == 1


def test_a_technique_that_fits_is_not(pliant):
    ended = pliant("run", ASPIRIN, "--bars", "angles", "--technique", "units", "--dry-run")
    assert "rigid units" not in ended.err
    ended = pliant("run", ASPIRIN, "--technique", "random", "--dry-run")
    assert "rigid units" not in ended.err
