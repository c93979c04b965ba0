# SPDX-License-Identifier: MIT
"""What commands do with a molecule that its periodic box cuts, as it comes from MD."""

from pathlib import Path

import h5py
import numpy as np
import pytest
from real_files import PEPTIDE

import pliant as library

cut_by_box = pytest.importorskip("cut_by_box")
tests_of_mda = pytest.importorskip("MDAnalysisTests")

#: Adenylate kinase in a dodecahedron of water of four sites, with ions; GROMACS wrote it.
IN_WATER = Path(tests_of_mda.__file__).parent / "data" / "adk_oplsaa.pdb"
WHOLE = "cut.pdb: 1 molecule cut by the periodic cell made whole (A:"

COMMANDS = {
    "contacts": ("contacts", "cut.pdb"),
    "rigidity": ("rigidity", "cut.pdb"),
    "run": ("run", "cut.pdb", "--steps", "20", "-o", "out.h5md"),
    "sample": ("sample", "cut.pdb", "--frames", "2", "-o", "out.h5md"),
    "path": ("path", "cut.pdb", PEPTIDE, "-o", "out.h5md"),
}
commands = pytest.mark.parametrize("words", COMMANDS.values(), ids=COMMANDS)


@pytest.fixture
def cut(tmp_path):
    """Writes cut.pdb; gives the text of its longest bond, "31.42"."""

    def write(**options):
        peptide = library.read(PEPTIDE)
        text = cut_by_box.cut_pdb(peptide, cut_by_box.BOXES["triclinic"], **options)
        (tmp_path / "cut.pdb").write_text(text)
        positions = library.read_text(text, "cut.pdb", perceive_bonds=False).positions
        return f"{longest(positions, peptide.bonds):.2f}"

    return write


def longest(positions, bonds):
    ends = positions[..., bonds, :]
    return np.linalg.norm(ends[..., 0, :] - ends[..., 1, :], axis=-1).max()


@commands
def test_it_is_made_whole_and_said(pliant, cut, tmp_path, words):
    assert float(cut()) > 10.0
    ended = pliant(*words)
    assert ended.code == 0, ended.err
    said = [line for line in ended.err.splitlines() if "made whole" in line]
    assert len(said) == 1 and said[0].startswith(f"note: {WHOLE}"), ended.err
    if "-o" in words:
        with h5py.File(tmp_path / "out.h5md") as file:
            frames = file["particles/trajectory/position/value"][:]
        bonds = library.H5mdReader(str(tmp_path / "out.h5md")).structure().bonds
        assert longest(frames, bonds) < 2.5


@pytest.mark.long
def test_a_protein_of_md_with_all_its_water_is_sampled(pliant, tmp_path):
    ended = pliant("sample", IN_WATER, "--frames", "2", "-o", "out.h5md", "--verbose")
    assert ended.code == 0, ended.err
    assert (
        "adk_oplsaa.pdb: 1 molecule cut by the periodic cell made whole (MET1:N to GLY214:O2): "
        "361 atoms moved by edges of the cell\n" in ended.err
    )
    assert "note: 11084 waters taken out\n" in ended.err
    assert "note: kept metals: NA+1299, NA+1300, NA+1301, NA+1302\n" in ended.err
    reader = library.H5mdReader(str(tmp_path / "out.h5md"))
    structure = reader.structure()
    assert (len(reader), len(structure)) == (2, 3345)
    for frame in range(2):
        assert longest(reader.positions(frame), structure.bonds) < 2.5


@pytest.mark.long
def test_check_makes_its_start_whole_and_says_so(pliant, cut):
    pytest.importorskip("openmm")
    cut()
    assert pliant("sample", PEPTIDE, "--frames", "2", "-o", "out.h5md").code == 0
    few = ("--frames", "2", "--starts", "1")
    ended = pliant("check", "out.h5md", "--reference", "cut.pdb", *few)
    assert ended.code == 0, ended.err
    assert f"note: {WHOLE}" in ended.err
