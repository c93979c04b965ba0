# SPDX-License-Identifier: MIT
"""A run is the same bits however the command was compiled: optimized or not at all.

The tests of every change hold the part that steps a framework on to this, in tests/same_bits.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from h5md_contents import contents
from real_files import ROOT

OPTIMIZED = Path(sys.executable).parent / "pliant"
PLAIN = Path(os.environ.get("PLIANT_DEBUG_COMMAND", ROOT / "build/debug/apps/pliant"))
SETTINGS = [
    ["--technique", "bfs_cycle"],
    ["--technique", "blocks", "--perturb", "displacement", "--displacement", "0.1"],
    ["--technique", "bfs_random", "--perturb", "force_all", "--mass-weighted"],
    ["--bars", "angles", "--tolerance", "1e-3", "--max-sweeps", "500"],
]
STATES = "parameters/checkpoint/state"
MOLECULES = ["caffeine", "cyclohexane_chair", "peptide_20"]


def datasets(path: Path) -> dict[str, np.ndarray]:
    """Every dataset of an H5MD file as bytes, by name."""
    found = contents(path)
    if STATES in found:  # a sample has none
        found[STATES] = last_state(found[STATES])
    return {name: np.asarray(value).tobytes() for name, value in found.items()}


def last_state(states: np.ndarray) -> np.ndarray:
    """Without its number and digest: how many came before depends on how long the run took."""
    last = states[np.argmax(states[:, 0])]
    return np.concatenate((last[1:3], last[5:]))


def run(command: Path, folder: Path, molecule: Path, settings: list[str]) -> dict[str, np.ndarray]:
    """The datasets of a short run by one build of the command."""
    output = ["--output", "out.h5md", "--topology", "none", "--quiet"]
    done = subprocess.run(
        [command, "run", molecule, *output, "--steps", "100", "--seed", "5", *settings],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    assert done.returncode in (0, 3), done.stderr
    return datasets(folder / "out.h5md")


@pytest.mark.long
@pytest.mark.skipif(not PLAIN.exists(), reason="./dev test --all builds build/debug")
@pytest.mark.parametrize("settings", SETTINGS, ids=" ".join)
@pytest.mark.parametrize("name", MOLECULES)
def test_debug_and_release_builds_write_the_same_bits(name, settings, tmp_path):
    (molecule,) = (ROOT / "data/molecules").glob(f"{name}.*")
    results = []
    for command in (OPTIMIZED, PLAIN):
        folder = tmp_path / str(len(results))
        folder.mkdir()
        results.append(run(command, folder, molecule, settings))
    optimized, plain = results
    assert optimized.keys() == plain.keys()
    assert [key for key in plain if plain[key] != optimized[key]] == []
