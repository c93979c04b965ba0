# SPDX-License-Identifier: MIT
"""pliant sample, on a peptide."""

import gzip
import json
from pathlib import Path

import h5py
import numpy as np
import pytest
from real_files import HEXAPEPTIDE


def test_frames_are_written_with_what_they_were_made_with(pliant, tmp_path):
    ended = pliant(
        "sample",
        HEXAPEPTIDE,
        "-o",
        "out.h5md",
        "--frames",
        5,
        "--amplitude",
        0.4,
        "--seed",
        2,
        "--json",
    )
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    assert report["frames"] == 5
    assert report["amplitude_is_input"] is True
    assert report["worst_residual"] < 1e-10
    with h5py.File(tmp_path / "out.h5md") as file:
        positions = file["particles/trajectory/position/value"][:]
        assert positions.shape == (5, report["atoms"], 3)
        assert np.isfinite(positions).all()
        assert file["parameters/sample"].attrs.get("amplitude", None) == pytest.approx(0.4) or (
            file["parameters/sample/amplitude"][()] == pytest.approx(0.4)
        )


def test_threads_and_pieces_give_the_same_frames(pliant, tmp_path):
    common = ("--amplitude", 0.4, "--quiet", "--topology", "none")
    pliant("sample", HEXAPEPTIDE, "-o", "one.h5md", "--frames", 6, "--threads", 1, *common)
    pliant("sample", HEXAPEPTIDE, "-o", "two.h5md", "--frames", 6, "--threads", 2, *common)
    piece = {"input": str(HEXAPEPTIDE), "output": "end.h5md", "frames": 2, "first_frame": 4}
    (tmp_path / "piece.json").write_text(json.dumps(piece))
    pliant("sample", "--job", "piece.json", *common)

    def frames(name):
        with h5py.File(tmp_path / name) as file:
            return file["particles/trajectory/position/value"][:]

    assert np.array_equal(frames("one.h5md"), frames("two.h5md"))
    assert np.array_equal(frames("one.h5md")[4:], frames("end.h5md"))


def test_eight_lines_say_what_was_done(pliant, tmp_path):
    """A crystal structure with waters, alternate locations and additives of crystallisation."""
    path = pytest.importorskip("MDAnalysisTests.datafiles").PDB_full
    ended = pliant("sample", path, "-o", "out.h5md", "--frames", 3)
    lines = [*ended.err.splitlines(), *ended.out.splitlines()]
    assert len(lines) <= 8
    text = "188 waters; 16 molecules of crystallisation: 10 GOL, 4 DMS, 1 ACT, 1 BME (--keep all"
    assert next(line for line in lines if line.startswith("left out")).startswith(
        f"left out        {text}"
    )
    assert "No frame had to be redrawn. Bonds and angles" in ended.out
    assert lines[-1] == "next            pliant analyse out.h5md"
    kept = pliant("sample", path, "--keep", "GOL,DMS", "--frames", 2, "-o", "kept.h5md", "--json")
    report = json.loads(kept.out)
    assert [line.split(" (")[0] for line in report["left_out"]] == [
        "188 waters",
        "2 molecules of crystallisation: 1 ACT, 1 BME",
    ]
    with h5py.File(tmp_path / "kept.h5md") as file:
        assert file["parameters/model/keep"][()].decode() == "GOL,DMS"


def test_it_says_that_the_amplitude_is_an_input(pliant):
    ended = pliant("sample", HEXAPEPTIDE, "--frames", 2, "--amplitude", 0.4, "--verbose")
    assert "an input, not a prediction" in ended.out
    assert "how often they occur is not claimed" in ended.out


def test_what_exists_is_not_replaced(pliant, tmp_path):
    (tmp_path / "out.h5md").write_text("mine")
    ended = pliant("sample", HEXAPEPTIDE, "-o", "out.h5md")
    assert ended.code == 1
    assert ended.err == "pliant: error: out.h5md: exists; --overwrite replaces it\n"
    assert (tmp_path / "out.h5md").read_text() == "mine"


def test_disulphides_close_without_a_last_move(pliant, tmp_path):
    """Three bridges tie BPTI into loops; their bonds, by numpy, are those of the file."""
    data = pytest.importorskip("MDAnalysisTests.datafiles")
    folder = Path(data.__file__).parent / "data" / "mmcif"
    (tmp_path / "bpti.cif").write_bytes(gzip.decompress((folder / "5PTI.cif.gz").read_bytes()))
    ended = pliant("sample", "bpti.cif", "-o", "out.h5md", "--frames", 8, "--json")
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    assert report["frames"] == 8
    assert report["worst_residual"] < 1e-10
    assert 0.0 < report["worst_closing"] <= 0.3
    lines = (tmp_path / "out.pdb").read_text().splitlines()
    atoms = [line for line in lines if line.startswith(("ATOM", "HETATM"))]
    sulphurs = [k for k, line in enumerate(atoms) if line[12:16].strip() == "SG"]
    with h5py.File(tmp_path / "out.h5md") as file:
        places = file["particles/trajectory/position/value"][:][:, sulphurs]
    lengths = np.linalg.norm(places[:, :, None] - places[:, None], axis=3)
    bridges = np.triu((lengths < 2.3).all(axis=0), 1)
    assert bridges.sum() == 3
    assert np.ptp(lengths[:, bridges], axis=0).max() < 1e-10


def test_one_residue_is_refused_and_loose_atoms_have_no_worst_bar(pliant, tmp_path):
    (tmp_path / "one.xyz").write_text("1\nargon\nAr 0 0 0\n")
    ended = pliant("sample", "one.xyz")
    assert ended.code == 1
    assert "one.xyz: holds one residue or atom: an ensemble needs two" in ended.err
    assert [path.name for path in tmp_path.iterdir()] == ["one.xyz"]
    (tmp_path / "two.xyz").write_text("2\nargon\nAr 0 0 0\nAr 0 0 9\n")
    ended = pliant("sample", "two.xyz", "--frames", 2, "--verbose")
    assert ended.code == 0
    assert "worst contact" in ended.out and "worst bar" not in ended.out


WIDE = "4\n\nC 0 0 {0}\nC {0} 0 0\nC 0 {0} 0\nC -{0} {0} -{0}\n"


def test_what_is_too_wide_for_whole_frames_is_refused_at_once(pliant, tmp_path):
    (tmp_path / "x.xyz").write_text(WIDE.format(10**6))
    ended = pliant("sample", "x.xyz", "-o", "out.h5md", "--sampler", "modes")
    assert (ended.code, ended.out) == (1, "")
    assert ended.err.splitlines()[-1] == (
        "pliant: error: the start: C(1) is 1.1e+06 Angstrom from the centre: expected at most 50000"
    )
    assert not (tmp_path / "out.h5md").exists()


@pytest.mark.parametrize("sampler", ["modes", "torsions"])
def test_what_is_too_far_for_whole_frames_is_refused_at_once(pliant, ethanol, tmp_path, sampler):
    head, atoms = ethanol.read_text().split("ethanol\n")
    rows = [line.split() for line in atoms.splitlines()]
    far = [f"{name} {float(x) + 1e8:.4f} {y} {z}\n" for name, x, y, z in rows]
    ethanol.write_text(f"{head}\n{''.join(far)}")
    ended = pliant("sample", ethanol.name, "-o", "out.h5md", "--sampler", sampler)
    assert (ended.code, ended.out) == (1, "")
    assert ended.err.splitlines()[-1] == (
        "pliant: error: the start: coordinates reach 1e+08 Angstrom, where doubles are 2.2e-08 "
        "apart: the tolerance of bar O(3) - H(9) cannot be met; move the molecule to the origin"
    )
    assert not (tmp_path / "out.h5md").exists()


def test_the_widest_molecule_has_whole_frames(pliant, tmp_path):
    (tmp_path / "x.xyz").write_text(WIDE.format(3 * 10**4))
    ended = pliant("sample", "x.xyz", "-o", "out.h5md", "--sampler", "modes", "--frames", 20)
    assert ended.code == 0, ended.err
    with h5py.File(tmp_path / "out.h5md") as file:
        moved = np.ptp(file["particles/trajectory/position/value"][:], axis=0)
    assert np.all((moved > 0.1) & (moved < 100.0))
