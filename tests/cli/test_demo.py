# SPDX-License-Identifier: MIT
"""pliant demo: a first ensemble from nothing but the package."""

import re
import subprocess
import sys

import MDAnalysis
import numpy as np

LINE = re.compile(r"  (\w{3}\d+) +(\d+\.\d+) ± (\d+\.\d+)  █*")


def test_the_ensemble_and_what_moves_are_there(pliant, tmp_path):
    ended = pliant("demo", "-o", tmp_path / "first", "--frames", "40")
    assert ended.code == 0, ended.err
    found = LINE.findall(ended.out)
    universe = MDAnalysis.Universe(
        tmp_path / "first/ensemble.pdb", tmp_path / "first/ensemble.h5md"
    )
    assert universe.trajectory.n_frames == 40
    residues = [f"{one.resname}{one.resid}" for one in universe.residues]
    assert [name for name, _, _ in found] == residues
    moves = np.array([float(moved) for _, moved, _ in found])
    ends, middle = moves[[0, -1]], moves[4:7]
    assert ends.min() > middle.max()  # a helix frays
    assert (tmp_path / "first/report.html").is_file()


def test_without_analysis_it_says_what_is_left_out(tmp_path):
    """As in an environment that has NumPy and h5py alone."""
    code = (
        "import sys\n"
        "class Hide:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name.partition('.')[0] in ('MDAnalysis', 'matplotlib', 'scipy', 'rich'):\n"
        "            raise ModuleNotFoundError(name, name=name)\n"
        "sys.meta_path.insert(0, Hide())\n"
        "from pliant.report.study.demo import main\n"
        f"sys.exit(main(['--frames', '4', '-o', {str(tmp_path)!r}]))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert len(LINE.findall(done.stdout)) == 20
    left_out = 'left out: the report needs MDAnalysis: pip install "pliant[analysis]"'
    assert left_out in done.stdout


def test_nothing_is_replaced_unasked(pliant, tmp_path):
    (tmp_path / "ensemble.h5md").write_text("mine")
    ended = pliant("demo", "-o", tmp_path)
    assert ended.code == 1
    assert f"{tmp_path}/ensemble.h5md: is there already; --overwrite replaces it" in ended.err
    assert (tmp_path / "ensemble.h5md").read_text() == "mine"
