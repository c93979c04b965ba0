# SPDX-License-Identifier: MIT
"""No function compiled for one level of instructions can be linked into code for all processors."""

import shutil
import subprocess

import pytest
from sources import ROOT

LEVELS = {"v3": ["-mavx2"], "v4": ["-mavx2", "-mavx512f", "-mavx512dq"]}
WORDS = ["-std=c++20", "-ffp-contract=off", "-fno-strict-aliasing", "-Wno-psabi", "-c"]


@pytest.mark.parametrize("compiler", ["g++", "clang++"])
@pytest.mark.parametrize("level", ["v4", pytest.param("v3", marks=pytest.mark.long)])
@pytest.mark.parametrize("optimize", ["-O0", pytest.param("-O1", marks=pytest.mark.long)])
def test_functions_of_a_lane_level_bear_its_name(compiler, level, optimize, tmp_path):
    if not shutil.which(compiler) or not shutil.which("nm"):
        pytest.skip(f"needs {compiler} and nm")
    target = subprocess.run([compiler, "-dumpmachine"], capture_output=True, text=True).stdout
    if not target.startswith("x86_64"):
        pytest.skip("levels are of x86-64")
    words = [*WORDS, optimize, f"-DPLIANT_LANE_LEVEL=lanes_{level}", *LEVELS[level]]
    source, compiled = ROOT / "src/pliant/resolve/lanes/lane_level.cpp", tmp_path / "lane_level.o"
    subprocess.run([compiler, *words, "-I", ROOT / "src", source, "-o", compiled], check=True)
    named = subprocess.run(
        ["nm", "--demangle", "--extern-only", "--defined-only", compiled],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()
    assert named, "the kernels themselves"
    assert [line for line in named if f"lanes_{level}" not in line] == []
