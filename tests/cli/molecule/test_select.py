# SPDX-License-Identifier: MIT
"""--select: some atoms of a file, as if it held no others; and pins of what stands still."""

import json

import h5py
import numpy as np
import pytest
from real_files import MOLECULES

import pliant as library


@pytest.fixture
def mixture(tmp_path):
    """A peptide with two waters and a sulphur that the file bonds to an O of it."""
    lines = (MOLECULES / "alanine_dipeptide.pdb").read_text().splitlines()
    atoms = [line for line in lines if line.startswith(("ATOM", "HETATM"))]
    (oxygen,) = [line for line in atoms if line[12:16].strip() == "O" and "ALA" in line]
    here = np.array([float(oxygen[k : k + 8]) for k in (30, 38, 46)])
    others = [
        ("CA", "CA", (0, 0, 1.6), "S"),
        ("O", "HOH", (20, 0, 0), "O"),
        ("O", "HOH", (25, 0, 0), "O"),
    ]
    for k, (name, residue, shift, element) in enumerate(others):
        x, y, z = here + shift
        number = f"{501 + k:>5}"
        atoms.append(
            f"HETATM{number} {name:<4} {residue:>3} W{k + 1:>4}    "
            f"{x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00          {element:>2}"
        )
    atoms.append(f"CONECT{oxygen[6:11]}  501")
    path = tmp_path / "mixture.pdb"
    path.write_text("\n".join(atoms) + "\nEND\n")
    return path


def test_info_is_of_the_selected_atoms(pliant, mixture):
    whole = json.loads(pliant("info", mixture, "--json").out)
    ended = pliant("info", mixture, "--select", "not resname HOH CA")
    assert ended.code == 0
    assert ended.err == (
        f"note: select: 22 of {whole['atoms']} atoms\n"
        "warning: select: 1 bond to an atom that is left out vanishes\n"
    )
    part = json.loads(pliant("info", mixture, "--select", "not resname HOH CA", "--json").out)
    assert (whole["atoms"], part["atoms"]) == (25, 22)
    assert whole["components"] == part["components"] + 2
    assert whole["bars"] == part["bars"] + 1
    assert part["warnings"] == ["select: 1 bond to an atom that is left out vanishes"]


def test_a_run_of_the_selected_atoms_says_so(pliant, mixture, tmp_path):
    words = ["run", mixture, "--steps", 10, "--select", "not resname HOH CA"]
    assert pliant(*words, "-o", "o.h5md").code == 0
    alone = MOLECULES / "alanine_dipeptide.pdb"
    assert pliant("run", alone, "--steps", 10, "-o", "alone.h5md").code == 0
    with h5py.File(tmp_path / "o.h5md") as file, h5py.File(tmp_path / "alone.h5md") as other:
        assert file["parameters/input/select"].asstr()[()] == "not resname HOH CA"
        assert other["parameters/input/select"].asstr()[()] == ""
        found, expected = (f["particles/trajectory/position/value"][:] for f in (file, other))
    assert np.array_equal(found, expected)


def test_python_selects_the_same(mixture):
    structure = library.read(mixture)
    with pytest.warns(library.PliantWarning, match="1 bond to an atom that is left out vanishes"):
        part = structure.select("not resname HOH CA")
    assert len(part) == 22
    assert set(part.residue_names) == set(structure.residue_names) - {"HOH", "CA"}
    with pytest.raises(library.OptionError, match='selection "nucleic" names no atom'):
        structure.select("nucleic")
    with pytest.warns(library.PliantWarning):
        summary = library.run(mixture, select="not resname HOH CA", steps=3)
    assert len(summary.state.positions) == 22
