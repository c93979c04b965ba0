# SPDX-License-Identifier: MIT
"""The installed package does its main jobs; measured by NumPy, h5py and MDAnalysis."""

from __future__ import annotations

import importlib
import os
import shutil
import subprocess
import sys
import sysconfig
import warnings
from pathlib import Path

import h5py
import numpy as np
import numpy.typing as npt
import pytest

import pliant

#: ethanol, tetrahedral to some hundredths of an Angstrom
ETHANOL = """9
ethanol
C   0.000   0.000   0.000
C   1.520   0.000   0.000
O   2.040   1.330   0.000
H   2.995   1.270   0.000
H  -0.385   1.020   0.000
H  -0.385  -0.510   0.885
H  -0.385  -0.510  -0.885
H   1.880  -0.525   0.885
H   1.880  -0.525  -0.885
"""


@pytest.fixture
def ethanol(tmp_path: Path) -> Path:
    """A file of a small molecule."""
    path = tmp_path / "ethanol.xyz"
    path.write_text(ETHANOL)
    return path


def lengths(
    positions: npt.NDArray[np.float64], pairs: npt.NDArray[np.integer]
) -> npt.NDArray[np.float64]:
    """Distances of pairs of rows."""
    length: npt.NDArray[np.float64] = np.linalg.norm(
        positions[pairs[:, 0]] - positions[pairs[:, 1]], axis=1
    )
    return length


def test_a_broken_framework_is_made_whole() -> None:
    """Every technique of the table, on a ring, measured here."""
    ring = next(one for one in pliant.examples() if one.name == "ring_6")
    bars, rest = ring.framework.bars, ring.framework.rest_lengths
    for technique in pliant.techniques():
        if technique.forests_only:
            continue
        positions = ring.positions + np.random.default_rng(1).normal(0, 0.05, ring.positions.shape)
        summary = pliant.resolve(ring.framework, positions, technique.name, tolerance=1e-8)
        off = np.abs(lengths(positions, bars) - rest) / rest
        assert summary.converged and off.max() <= 1.001e-8, technique.name


def test_a_run_is_recorded_with_every_bar_whole(ethanol: Path, tmp_path: Path) -> None:
    """All frames of the file are within the tolerance, by h5py and NumPy."""
    pliant.run(ethanol, output=tmp_path / "out.h5md", steps=20, seed=1)
    with h5py.File(tmp_path / "out.h5md") as file:
        frames = file["particles/trajectory/position/value"][:]
        bars = file["connectivity/bars"][:]
    assert frames.shape == (21, 9, 3)
    assert len(bars) == 8
    rest = lengths(frames[0], bars)
    assert max(np.abs(lengths(frame, bars) / rest - 1).max() for frame in frames) < 2.1e-6
    assert np.abs(frames[20] - frames[0]).max() > 0.01


def test_the_same_seed_gives_the_same_bits(ethanol: Path) -> None:
    """And another one does not."""
    ends = [pliant.run(ethanol, steps=30, seed=seed).state.positions for seed in (1, 1, 2)]
    assert np.array_equal(ends[0], ends[1])
    assert not np.array_equal(ends[0], ends[2])


def test_conformers_keep_lengths_and_angles(ethanol: Path) -> None:
    """Bonds and 1-3 distances of each conformer are those of the file."""
    structure = pliant.read(ethanol)
    ensemble = pliant.sample(structure, 10, seed=1)
    start = structure.positions
    near = np.array([(0, 1), (1, 2), (2, 3), (0, 2), (1, 3), (0, 4), (1, 4), (7, 8)])
    for frame in ensemble.positions:
        assert np.abs(lengths(frame, near) - lengths(start, near)).max() < 1e-6
    assert np.ptp([np.linalg.norm(frame[0] - frame[3]) for frame in ensemble.positions]) > 0.1


def test_bad_input_names_file_and_line(tmp_path: Path) -> None:
    """One message, and no file left behind."""
    path = tmp_path / "bad.xyz"
    path.write_text("2\n\nC 0 0 0\nC 1 x 0\n")
    with pytest.raises(pliant.InputError, match=r"bad\.xyz:4: "):
        pliant.run(path, output=tmp_path / "out.h5md")
    assert os.listdir(tmp_path) == ["bad.xyz"]


def command() -> str:
    """The command of this installation; skips the test where it was left out."""
    folder = Path(sysconfig.get_path("scripts"))
    found = shutil.which("pliant", path=f"{folder}{os.pathsep}{Path(sys.executable).parent}")
    return found or pytest.skip("the command pliant is not installed")


def test_the_command_runs(ethanol: Path, tmp_path: Path) -> None:
    """C++ and Python subcommands."""
    for arguments in (["--version"], ["info", str(ethanol)], ["convert", "--help"]):
        environment = os.environ | {"PATH": f"{Path(command()).parent}:{os.environ['PATH']}"}
        done = subprocess.run(
            [command(), *arguments], capture_output=True, text=True, check=False, env=environment
        )
        assert done.returncode == 0, done.stderr
        assert done.stdout


def test_mdanalysis_opens_a_trajectory_alone(ethanol: Path, tmp_path: Path) -> None:
    """Names, elements and bonds come from the file, by ``pliant.mdanalysis``."""
    mda = pytest.importorskip("MDAnalysis")
    importlib.import_module("pliant.mdanalysis")
    pliant.run(ethanol, output=tmp_path / "out.h5md", steps=5)
    for options in ({}, {"topology_format": "H5MD"}):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            universe = mda.Universe(str(tmp_path / "out.h5md"), **options)
        assert list(universe.atoms.elements) == list("CCOHHHHHH")
        assert (len(universe.bonds), len(universe.trajectory)) == (8, 6)


def test_an_analysis_of_mdanalysis_runs(ethanol: Path, tmp_path: Path) -> None:
    """Residuals of all bars, by our class for MDAnalysis."""
    mda = pytest.importorskip("MDAnalysis")
    pytest.importorskip("scipy")
    importlib.import_module("pliant.mdanalysis")
    from pliant.measure.residuals import BarResiduals

    path = str(tmp_path / "out.h5md")
    pliant.run(ethanol, output=path, steps=5)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        residuals = BarResiduals(mda.Universe(path))
        residuals.run()
    assert residuals.results.max_relative.max() < 2e-6
