# SPDX-License-Identifier: MIT
"""What pliant analyse takes of memory: nothing that grows with the square of the atoms, or with
the frames."""

import subprocess
import sys
import tracemalloc

import MDAnalysis
import numpy as np
import pytest
from pliant.measure.domains import distance_fluctuations
from pliant.measure.stages.parts import Units
from pliant.report.page.scene import _nearest
from scipy.spatial import cKDTree

ATOMS = 9632
#: MB that 140 frames more may take
MORE_FRAMES = 45

# VmHWM is of the program alone; what getrusage tells includes the process that started it.
PEAK = """
import contextlib, io, re, sys
from pliant.report.command import main
def peak():
    return int(re.search(r"VmHWM:\\s+(\\d+) kB", open("/proc/self/status").read())[1]) / 1024
with contextlib.redirect_stdout(io.StringIO()):
    assert main([sys.argv[1], "-o", sys.argv[3]]) == 0
    before = peak()
    assert main([sys.argv[2], "-o", sys.argv[4]]) == 0
print(peak() - before)
"""


def write_two_frames(path, count):
    """Carbon atoms on a lattice, in one residue: each of them is a unit of the report."""
    places = np.argwhere(np.ones((22, 22, 20)))[:count] * 1.6
    move = np.random.default_rng(1).normal(scale=0.2, size=(2, count, 3))
    with open(path, "w") as file:
        for model in range(2):
            file.write(f"MODEL     {model + 1:4d}\n")
            for k, (x, y, z) in enumerate(places + move[model], 1):
                file.write(
                    f"HETATM{k:5d}  C   LIG A   1    {x:8.3f}{y:8.3f}{z:8.3f}"
                    "  1.00  0.00           C\n"
                )
            file.write("ENDMDL\n")


def write_frames(path, frames, count):
    """Atoms that move slowly and tremble, as MDAnalysis writes them."""
    rng = np.random.default_rng(2)
    places = np.argwhere(np.ones((22, 22, 20)))[:count] * 1.6
    moves = rng.normal(size=(2, count, 3))
    universe = MDAnalysis.Universe.empty(count, trajectory=True)
    with MDAnalysis.Writer(
        str(path), count, n_frames=frames, timeunit="ps", lengthunit="Angstrom"
    ) as writer:
        for k in range(frames):
            slow = np.sin(k / 40) * moves[0] + np.cos(k / 25) * moves[1]
            universe.atoms.positions = places + slow + rng.normal(scale=0.1, size=(count, 3))
            writer.write(universe.atoms)
        writer.h5md_file.close()  # which it leaves open


@pytest.mark.skipif(sys.platform != "linux", reason="asks /proc")
def test_two_frames_of_many_atoms(tmp_path):
    """A table of all pairs of them would be 740 MB."""
    small, large = tmp_path / "small.pdb", tmp_path / "large.pdb"
    write_two_frames(small, 100)
    write_two_frames(large, ATOMS)
    words = [small, large, tmp_path / "a", tmp_path / "b"]
    ended = subprocess.run(
        [sys.executable, "-c", PEAK, *words], capture_output=True, text=True, check=True
    )
    assert float(ended.stdout) < 100


@pytest.mark.long
@pytest.mark.skipif(sys.platform != "linux", reason="asks /proc")
def test_many_frames(tmp_path):
    """Their positions are 18 MB as the analyses want them, each of which would hold them."""
    paths = {}
    for frames in (10, 150):
        paths[frames] = tmp_path / f"{frames}.h5md"
        write_frames(paths[frames], frames, 5000)
    words = [paths[10], paths[150], tmp_path / "a", tmp_path / "b"]
    ended = subprocess.run(
        [sys.executable, "-c", PEAK, *words], capture_output=True, text=True, check=True
    )
    assert float(ended.stdout) < MORE_FRAMES


def peak_of(work):
    """MB that Python held at most."""
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1] / 1e6
    finally:
        tracemalloc.stop()


def test_the_nearest_of_many():
    points, others = np.random.default_rng(2).normal(size=(2, 2000, 3))
    assert (_nearest(points, others) == cKDTree(others).query(points)[1]).all()
    assert peak_of(lambda: _nearest(points, others)) < 20  # all pairs: 96


def test_sites_are_the_centres_of_their_atoms():
    unit = np.array([0, 0, 1, 2, 2, 2])
    none = np.arange(3)
    units = Units("residue", list("abc"), none, none, none, np.arange(6), unit, none >= 0)
    positions = np.random.default_rng(3).normal(size=(4, 6, 3))
    expected = [[frame[unit == k].mean(axis=0) for k in range(3)] for frame in positions]
    assert units.sites(positions) == pytest.approx(np.array(expected), abs=1e-15)


def test_fluctuations_of_distances_hold_few_tables_of_pairs():
    positions = np.random.default_rng(4).normal(size=(8, 500, 3))
    assert peak_of(lambda: distance_fluctuations(positions)) < 35  # of 3 x 3 a pair: 58
