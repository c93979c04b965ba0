# SPDX-License-Identifier: MIT
"""The promise of the main job, checked by h5py and numpy from the files alone."""

import json
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest
import real_files

COMMAND = Path(sys.executable).parent / "pliant"
MOLECULES = sorted(
    path
    for path in real_files.MOLECULES.iterdir()
    if path.suffix in {".pdb", ".xyz", ".sdf", ".mol", ".cif"}
)
TOLERANCE = 1e-6


def pliant_json(*arguments):
    done = subprocess.run(
        [COMMAND, *map(str, arguments), "--json"], capture_output=True, text=True, check=False
    )
    assert done.returncode in (0, 3), done.stderr
    return json.loads(done.stdout)


def techniques_for(cycles):
    rows = pliant_json("lab", "techniques")["techniques"]
    return [row["name"] for row in rows if row["applies_to"] == "any" or cycles == 0]


def relative_residuals(path):
    """Largest |length - rest| / rest of each frame, and whether the frame says it converged."""
    with h5py.File(path) as file:
        positions = file["particles/trajectory/position/value"][:]
        bars = file["connectivity/bars"][:]
        rests = file["parameters/framework/rest_length"][:]
        converged = file["observables/converged/value"][:].astype(bool)
    lengths = np.linalg.norm(positions[:, bars[:, 1]] - positions[:, bars[:, 0]], axis=-1)
    return (np.abs(lengths - rests) / rests).max(axis=1), converged


@pytest.mark.parametrize("molecule", MOLECULES, ids=lambda path: path.stem)
def test_every_bar_of_every_frame_is_whole_or_the_frame_says_so(molecule, tmp_path):
    facts = pliant_json("info", molecule)
    for technique in techniques_for(facts["cycles"]):
        output = tmp_path / f"{technique}.h5md"
        words = "--weighting 0.5 --steps 200 --topology none".split()
        words += ["--technique", technique, "--tolerance", TOLERANCE]
        summary = pliant_json("run", molecule, "-o", output, *words)
        residuals, converged = relative_residuals(output)
        assert len(residuals) == 201
        assert (residuals[converged] <= TOLERANCE * (1 + 1e-9)).all(), technique
        assert (residuals[~converged] > TOLERANCE * (1 - 1e-9)).all(), technique
        assert summary["unconverged_steps"] == (~converged).sum(), technique
        assert converged.mean() > 0.9, technique
