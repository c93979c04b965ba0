# SPDX-License-Identifier: MIT
"""The solver in WebAssembly gives the bits that the library gives: readers, models, techniques."""

from pathlib import Path

import pytest
from MDAnalysisTests import datafiles
from native_bits import opened as opened_natively
from real_files import MECHANISMS, MOLECULES
from wasm_solver import sha1

import pliant

ALL = [row.name for row in pliant.techniques() if not row.forests_only]


def assert_same_walk(solver, path, model, techniques, steps, **options):
    framework, positions = opened_natively(path, model)
    for technique in techniques:
        opened = solver.open(path, model)
        assert opened["rest"]["sha1"] == sha1(framework.rest_lengths)
        assert opened["positions"]["sha1"] == sha1(positions)
        settings = {"technique": technique, "max_sweeps": 200, "damping": 0.5, **options}
        solver.ask("settings", **settings)
        walked = solver.ask("wander", steps=steps, last=True)["frames"][-1]
        summary, state = run_native(framework, positions, steps, settings)
        assert walked["positions"]["sha1"] == sha1(state), (path.name, technique)
        assert walked["sweeps"] == summary, (path.name, technique)


def run_native(framework, positions, steps, settings):
    """Sweeps of the last step, and where it ended."""
    seen = []

    def keep(frame):
        seen[:] = [(frame.sweeps, frame.positions.copy())]

    pliant.run(framework, positions, steps=steps, every=steps, observers=[keep], **settings)
    return seen[0]


@pytest.mark.parametrize("name", ["caffeine.sdf", "peptide_20.pdb", "glucose.cif"])
def test_all_techniques(solver, name):
    assert_same_walk(solver, MOLECULES / name, "bonds", ALL, 20)


@pytest.mark.parametrize("path", sorted(MOLECULES.glob("*.*")), ids=lambda path: path.name)
def test_all_readers(solver, path):
    for model in ("angles", "molecule"):
        assert_same_walk(solver, path, model, ["auto"], 10)


@pytest.mark.filterwarnings("ignore:technique = :pliant.PliantWarning")  # sweeps, on purpose
@pytest.mark.parametrize("path", sorted(MECHANISMS.glob("*.xml")), ids=lambda path: path.name)
def test_mechanisms(solver, path):
    assert_same_walk(solver, path, "", ["auto", "bfs_cycle"], 10)


@pytest.mark.filterwarnings("ignore:technique = :pliant.PliantWarning")  # sweeps, on purpose
def test_the_model_of_a_protein(solver):
    path = MOLECULES / "peptide_20.pdb"
    assert_same_walk(solver, path, "protein", ["froda", "anderson", "bfs_cycle"], 10)


def test_every_joint_pushed_at_random(solver):
    options = {"perturb": "force_all", "force": 5.0, "seed": 7}
    assert_same_walk(
        solver, MOLECULES / "crown_18_6.cif", "bonds", ["blocks", "newton"], 10, **options
    )


@pytest.mark.long
@pytest.mark.parametrize("name", ["caffeine.sdf", "cholesterol.cif", "alanine_dipeptide.pdb"])
def test_a_thousand_steps_of_all_techniques(solver, name):
    assert_same_walk(solver, MOLECULES / name, "bonds", ALL, 1000)


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_a_protein(solver):
    path = Path(datafiles.PDB_small)
    assert_same_walk(solver, path, "bonds", ["blocks", "units", "bfs_cycle"], 1000)
    assert_same_walk(solver, path, "protein", ["auto"], 10)


BROKEN = [
    ("x.pdb", b""),
    ("x.pdb", b"ATOM      1  CA  ALA A   1      xx.000  1.000  1.000\n"),
    ("x.pdb", b"\x00\x01binary"),
    ("x.xyz", b"3\n\nC 0 0\n"),
    ("x.xyz", b"2\n\nC 0 0 0\nC 0 0 0\n"),
    ("x.sdf", b"\n\n\n  9  0\n"),
    ("x.cif", b"data_x\nloop_\n_atom_site.id\n1 2 '\n"),
    ("x.xml", b"<graph><joint id='a' x='0' y='0'/><bar a='a' b='b'/></graph>"),
    ("x.xml", b"<graph><joint"),
    ("x.txt", b"no molecule at all\n"),
    ("x.pdb", b"\x1f\x8b\x08\x00damaged"),
    ("<img src=x onerror=alert(1)>.pdb", b"HEADER\n"),
    ("\u00e4\u00f6.pdb", b"ATOM      1  CA  \xff\xfeA A   1      xx.000  1.000  1.000\n"),
]


@pytest.mark.parametrize(("name", "content"), BROKEN)
def test_what_is_wrong_with_a_file_is_reported_in_the_same_words(solver, tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(ValueError) as raised:
        solver.open(path)
    if content.startswith(b"\x1f\x8b"):
        assert str(raised.value) == (
            "x.pdb: is compressed with gzip, which this build of Pliant does not read: "
            "it was made without zlib"
        )
        return
    with pytest.raises(pliant.Error) as expected:
        opened_natively(path, "bonds")
    assert str(raised.value) == str(expected.value).replace(str(tmp_path) + "/", "")
