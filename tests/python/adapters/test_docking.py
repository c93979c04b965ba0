# SPDX-License-Identifier: MIT
"""pliant convert --to vina: receptors have the atoms of each frame, laid on the site."""

import warnings
from pathlib import Path

import MDAnalysis
import numpy as np
import pytest
from expected_warnings import read_without_elements
from MDAnalysis.analysis.align import rotation_matrix
from pliant.adapters.convert.command import main
from pliant.adapters.convert.docking import site_of

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
PEPTIDE = Path(MDA.PDB_small).parent / "adk_open_10res.pdb"
SITE = "resid 4-7"


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    path = tmp_path_factory.mktemp("docking") / "run.h5md"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)  # it is held tightly
        pliant.sample(read_without_elements(PEPTIDE), frames=4, seed=3, output=path)
    return path


def rows_of(path):
    """Residue number and AutoDock's type of each atom of a PDBQT file, and positions."""
    lines = [one for one in Path(path).read_text().splitlines() if one.startswith("ATOM")]
    rows = [(int(one[22:26]), one[77:].strip()) for one in lines]
    return rows, np.array([[float(one[k : k + 8]) for k in (30, 38, 46)] for one in lines])


def test_a_site_is_of_whole_residues_or_near_to_a_ligand(recorded):
    structure = pliant.Trajectory(recorded).structure
    universe = pliant.to_mdanalysis(structure)
    theirs = universe.select_atoms(f"not element H and {SITE}").ix
    for words in (SITE, "resid 4-7 and name CA"):
        assert site_of(structure, words).tolist() == theirs.tolist()
    with pytest.raises(pliant.OptionError, match='--site "resname XYZ": no residue of a protein'):
        site_of(structure, "resname XYZ")


def test_receptors_have_the_atoms_of_their_frames(recorded, tmp_path):
    pytest.importorskip("meeko")
    done = pliant.convert(recorded, tmp_path / "dock", to="vina", site=SITE, every=2)
    assert (done.frames, done.notes) == (2, [])
    (tmp_path / "dock/frame-0002.pdbqt").unlink()
    with pytest.raises(pliant.FileError, match=r"frame-0000.pdbqt: exists; --overwrite replaces"):
        pliant.convert(recorded, tmp_path / "dock", to="vina", site=SITE, every=2)
    pliant.convert(recorded, tmp_path / "dock", to="vina", site=SITE, every=2, overwrite=True)
    trajectory = pliant.Trajectory(recorded)
    structure = trajectory.structure
    site = site_of(structure, SITE)
    fitted = structure.positions[site]
    is_heavy = structure.symbols != "H"
    for number in (0, 2):
        rows, found = rows_of(tmp_path / f"dock/frame-{number:04d}.pdbqt")
        frame = trajectory[number]
        centre = frame[site].mean(axis=0)
        rotation, _ = rotation_matrix(frame[site] - centre, fitted - fitted.mean(axis=0))
        expected = (frame - centre) @ rotation.T + fitted.mean(axis=0)
        apart = np.linalg.norm(found[:, None] - expected, axis=2)
        is_end = np.array([residue == 1 for residue, _ in rows])  # Meeko adds its hydrogens
        assert apart[~is_end].min(axis=1).max() < 1e-3
        assert apart[:, is_heavy].min(axis=0).max() < 1e-3
        assert {kind for _, kind in rows} >= {"C", "OA", "N", "HD"}
    box = dict(one.split(" = ") for one in (tmp_path / "dock/box.txt").read_text().splitlines())
    low, high = fitted.min(axis=0), fitted.max(axis=0)
    for k, axis in enumerate("xyz"):
        assert float(box[f"center_{axis}"]) == pytest.approx((low + high)[k] / 2, abs=1e-3)
        assert float(box[f"size_{axis}"]) == pytest.approx((high - low)[k], abs=1e-3)


def test_what_meeko_does_not_know_is_left_out_or_refused(recorded, tmp_path, capsys):
    pytest.importorskip("meeko")
    pliant.convert(recorded, tmp_path / "whole.pdb", every=9)
    universe = MDAnalysis.Universe(tmp_path / "whole.pdb")
    universe.residues[1].resname = "XYZ"
    kept = universe.select_atoms("not (resid 5 and name CD CE NZ HD* HE* HZ* CG* HG*)")
    kept.write(tmp_path / "other.pdb")
    assert main([str(tmp_path / "other.pdb"), "-o", str(tmp_path / "dock"), "--to", "vina",
                 "--site", "resid 7-9"]) == 0  # fmt: skip
    said = capsys.readouterr().out
    assert "left out: XYZ" in said
    assert main([str(tmp_path / "other.pdb"), "-o", str(tmp_path / "none"), "--to", "vina",
                 "--site", "resid 5"]) == 1  # fmt: skip
    assert "Meeko has no template for" in capsys.readouterr().err
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--to", "vina"), "--to vina: expected --site, the residues that ligands are docked at"),
        (("--site", "resid 4"), "--site: goes with --representatives or --to vina"),
        (
            ("--to", "vina", "--site", "resid 4", "--platform", "CPU"),
            "--charges, --ligand, --platform: go with --to openmm, gromacs, amber",
        ),
    ],
)
def test_options_that_do_not_go_together(recorded, tmp_path, capsys, words, told):
    assert main([str(recorded), "-o", str(tmp_path / "out.pdb"), *words]) == 2
    assert told in capsys.readouterr().err


def test_representatives_differ_at_the_site(recorded, tmp_path):
    """Those that stand for all of four frames, by the RMSD of the site's atoms."""
    pliant.convert(recorded, tmp_path / "one.h5md", representatives=1, site=SITE)
    trajectory = pliant.Trajectory(recorded)
    site = site_of(trajectory.structure, SITE)
    places = [trajectory[k][site] for k in range(len(trajectory))]
    rmsd = [
        [rotation_matrix(a - a.mean(axis=0), b - b.mean(axis=0))[1] for a in places] for b in places
    ]
    wanted = int(np.sum(rmsd, axis=0).argmin())
    assert np.array_equal(pliant.Trajectory(tmp_path / "one.h5md")[0], trajectory[wanted])
