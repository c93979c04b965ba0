# SPDX-License-Identifier: MIT
"""Frames as the models of a PDB file, where the output's name asks for one."""

import os
import signal
import subprocess
import time

import gemmi
import numpy as np
import pytest

import pliant as package


def models_of(path):
    models = gemmi.read_structure(str(path))
    return np.array([[atom.atom.pos.tolist() for atom in model.all()] for model in models])


@pytest.mark.parametrize("name", ["out.pdb", "OUT.PDB", "out.ent"])
def test_run_writes_what_h5md_has(pliant, ethanol, tmp_path, name):
    for output in ("same.h5md", name):
        ended = pliant("run", ethanol, "--steps", 30, "--every", 3, "-o", output)
        assert ended.code == 0, ended.err
    reader = package.H5mdReader(tmp_path / "same.h5md")
    expected = np.array([reader.positions(k) for k in range(len(reader))])
    assert np.abs(models_of(tmp_path / name) - expected).max() < 5.01e-4
    # No topology beside: the file has names and bonds itself.
    assert {path.name for path in tmp_path.iterdir()} == {
        "ethanol.xyz",
        "same.h5md",
        "same.pdb",
        name,
    }
    source = package.read(tmp_path / "same.pdb")
    assert package.read(tmp_path / name, model=1).bonds.tolist() == source.bonds.tolist()


def test_sample_writes_models(pliant, ethanol, tmp_path):
    ended = pliant("sample", ethanol, "--frames", 4, "-o", "ensemble.pdb")
    assert ended.code == 0, ended.err
    assert models_of(tmp_path / "ensemble.pdb").shape == (4, 9, 3)


def test_walkers_have_a_file_each(pliant, ethanol, tmp_path):
    assert pliant("run", ethanol, "--steps", 2, "--walkers", 2, "-o", "w.pdb").code == 0
    assert [len(models_of(tmp_path / f"w-{k}.pdb")) for k in range(2)] == [3, 3]


def test_half_a_model_never_bears_the_name(command, ethanol, tmp_path):
    words = [command, "run", ethanol, "--steps", "100000000", "-o", "out.pdb", "--quiet"]
    with subprocess.Popen(words, cwd=tmp_path) as running:
        while not any(path.name.startswith(".out.pdb.") for path in tmp_path.iterdir()):
            time.sleep(0.01)
        assert not (tmp_path / "out.pdb").exists()
        running.send_signal(signal.SIGINT)
        assert running.wait() == 130
    assert sorted(os.listdir(tmp_path)) == ["ethanol.xyz", "out.pdb"]
    text = (tmp_path / "out.pdb").read_text()
    assert text.count("\nENDMDL\n") == text.count("MODEL ") > 0 and text.endswith("END\n")


def test_a_graph_is_written_too(pliant, tmp_path):
    graph = package.Graph(package.Framework([[0, 1]], [1.0]), [[0, 0, 0], [1, 0, 0]])
    (tmp_path / "bar.xml").write_text(graph.text())
    assert pliant("run", "bar.xml", "--steps", 2, "-o", "out.pdb").code == 0
    assert models_of(tmp_path / "out.pdb").shape == (3, 2, 3)
