# SPDX-License-Identifier: MIT
"""The example with real OpenMM dynamics, run short: amber14 in implicit solvent beside Pliant."""

import importlib.util
import pathlib

import MDAnalysis
import numpy as np
import pytest

ROOT = pathlib.Path(__file__).parents[3]
MOLECULE = ROOT / "data" / "molecules" / "alanine_dipeptide.pdb"


@pytest.fixture(scope="module")
def example():
    path = ROOT / "python" / "examples" / "openmm_dynamics.py"
    spec = importlib.util.spec_from_file_location("openmm_dynamics", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.long
def test_dynamics_and_pliant_side_by_side(example, tmp_path, capsys):
    words = [
        str(MOLECULE),
        "-o",
        str(tmp_path),
        *"--picoseconds 1 --frames 20 --platform Reference".split(),
    ]
    assert example.main(words) == 0
    out = capsys.readouterr().out
    assert "theirs  " in out and "ALA2 phi" in out and "ALA2 psi" in out
    start, dcd = tmp_path / "alanine_dipeptide-start.pdb", tmp_path / "alanine_dipeptide-openmm.dcd"
    dynamics = MDAnalysis.Universe(str(start), str(dcd))
    assert len(dynamics.trajectory) == 20
    # It is dynamics: bonds between heavy atoms vibrate, and no atom is where it began.
    ace = dynamics.select_atoms("resname ACE and name CH3 C")
    lengths = [np.linalg.norm(np.diff(ace.positions, axis=0)) for _ in dynamics.trajectory]
    assert 0.005 < np.std(lengths) < 0.2
    for name in ("alanine_dipeptide.compare.png", "alanine_dipeptide.compare-torsions.png"):
        assert (tmp_path / name).exists()
