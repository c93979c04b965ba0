# SPDX-License-Identifier: MIT
"""pliant study --demo: a first study, from nothing but the package."""

import MDAnalysis


def test_the_helix_is_studied(pliant, tmp_path):
    ended = pliant("study", "--demo", "-o", "first", "--frames", "40", "--no-check")
    assert ended.code == 0, ended.err
    universe = MDAnalysis.Universe(
        tmp_path / "first/ensemble.pdb", tmp_path / "first/ensemble.h5md"
    )
    assert (universe.trajectory.n_frames, len(universe.residues)) == (40, 20)
    assert (tmp_path / "first/report.html").is_file()


def test_it_takes_no_molecule_besides(pliant, ethanol, tmp_path):
    ended = pliant("study", ethanol, "--demo")
    assert (ended.code, ended.err) == (
        2,
        "pliant study: error: --demo: goes with neither FILE nor --smiles\n",
    )
    assert [path.name for path in tmp_path.iterdir()] == ["ethanol.xyz"]
