# SPDX-License-Identifier: MIT
"""Conformers beside others': RMSD against RDKit, planted faults, sets, failures, the command."""

import csv
import dataclasses
import gzip
import json

import numpy as np
import pytest
from hanging import clock_that_waits_for

import pliant

Chem = pytest.importorskip("rdkit.Chem")
pytest.importorskip("openmm")
pytest.importorskip("MDAnalysisTests")
pytest.importorskip("prody")

from pliant.checks.openmm.child import Job, run_jobs  # noqa: E402
from pliant.lab.bench.command import main  # noqa: E402
from pliant.lab.conformers import contenders, measure, summary  # noqa: E402
from pliant.lab.conformers.crystal_ligands import LIGANDS, crystal_ligands  # noqa: E402
from pliant.lab.conformers.faults import energies, faults_of  # noqa: E402
from pliant.lab.conformers.known import KnownSet, read_known, start_of  # noqa: E402
from pliant.lab.conformers.rows import Made, Table  # noqa: E402
from pliant.lab.conformers.symmetric_rmsd import nearest, symmetry_maps  # noqa: E402
from rdkit.Chem import AllChem, rdMolAlign  # noqa: E402

SYMMETRIC = (
    "CC(C)(C)c1ccc(cc1)S(=O)(=O)NCCC(=O)[O-]",
    "CC(C)CC(N)C(=O)O",
    "OP(=O)(O)OCCc1ccccc1",
    "C[NH+]=C(N)NCCC[N+](=O)[O-]",
)
STEREO = "C[C@H](O)/C=C/C(=O)NCC[S@](=O)C"


def embedded(smiles, count=1, seed=3):
    molecule = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMultipleConfs(molecule, count, randomSeed=seed)
    return molecule


def frames_of(molecule):
    return np.array([one.GetPositions() for one in molecule.GetConformers()])


@pytest.mark.parametrize("smiles", SYMMETRIC)
def test_rmsd_is_the_best_of_all_symmetries_as_rdkit_finds_it(smiles):
    molecule = embedded(smiles, 6)
    frames = frames_of(molecule)
    plain = Chem.RemoveHs(molecule)
    found = nearest(molecule, frames)
    for k in range(6):
        expected = rdMolAlign.GetBestRMS(Chem.Mol(plain), plain, k, 0)
        assert found[k] == pytest.approx(expected, abs=1e-5)
    assert len(symmetry_maps(molecule)) > 1


def test_a_mirror_image_is_not_superposed():
    molecule = embedded("C[C@H](N)C(=O)O")
    assert nearest(molecule, frames_of(molecule) * (1, 1, -1))[0] > 0.3


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        (STEREO.replace("C[C@H]", "C[C@@H]"), "handedness"),
        (STEREO.replace("[S@]", "[S@@]"), "handedness"),
        (STEREO.replace("/C(=O)", "\\C(=O)"), "double_bonds"),
    ],
)
def test_stereo_that_has_changed_is_found(changed, fault):
    molecule = embedded(STEREO)
    other = embedded(changed)
    frames = np.concatenate([frames_of(molecule), frames_of(other)])
    found = faults_of(molecule, frames)
    for name in ("handedness", "double_bonds"):
        assert getattr(found, name).tolist() == [False, name == fault]


def test_an_amide_that_has_turned_is_found():
    from rdkit.Chem import rdMolTransforms

    molecule = embedded("CCC(=O)NCC")
    before = frames_of(molecule)
    rdMolTransforms.SetDihedralDeg(molecule.GetConformer(), 1, 2, 4, 5, 0.0)
    cis = frames_of(molecule)
    rdMolTransforms.SetDihedralDeg(molecule.GetConformer(), 1, 2, 4, 5, 180.0)
    found = faults_of(molecule, np.concatenate([before, cis]))
    assert found.amides.tolist() == [False, True]


def test_atoms_in_each_other_are_found_only_four_bonds_apart():
    molecule = embedded("CCCCCC")
    frames = np.repeat(frames_of(molecule), 3, axis=0)
    frames[1, 5] = frames[1, 0] + (2.5, 0, 0)
    frames[2, 3] = frames[2, 0] + (2.5, 0, 0)
    frames[2, 4:6] = frames[2, 0] + 9.0
    assert faults_of(molecule, frames).contacts.tolist() == [False, True, False]


def test_energies_fall_to_that_of_rdkits_own_minimiser():
    molecule = embedded("CCOC(=O)CC")
    raw, low = energies(molecule, frames_of(molecule))
    work = Chem.Mol(molecule)
    ((_, expected),) = AllChem.MMFFOptimizeMoleculeConfs(work, mmffVariant="MMFF94s", maxIters=2000)
    assert raw[0] > low[0] == pytest.approx(expected, abs=0.05)


@pytest.fixture(scope="module")
def ligands():
    return crystal_ligands()


def test_crystal_ligands_are_those_of_the_table_with_all_atoms(ligands):
    found = ligands
    assert [one.name for one in found.molecules] == [residue for _, residue, _ in LIGANDS]
    assert found.skipped == []
    for one in found.molecules:
        atoms = zip(one.molecule.GetAtoms(), one.start.GetAtoms(), strict=True)
        assert all(a.GetAtomicNum() == b.GetAtomicNum() for a, b in atoms)
        assert nearest(one.molecule, frames_of(one.start))[0] > 0.3, "started from the known one"
        assert not faults_of(one.molecule, frames_of(one.start)).handedness.any()


@pytest.fixture
def library(tmp_path):
    """Two molecules, a drawing, one without hydrogens, a salt, and a broken record."""
    good = [embedded("CCOC(=O)[C@H](C)N"), embedded("C1CCCCCCCC1")]
    flat = Chem.MolFromSmiles("CCO")
    AllChem.Compute2DCoords(flat)
    bare, salt = Chem.RemoveHs(embedded("CCO")), embedded("CC(=O)[O-].[Na+]")
    blocks = [Chem.MolToMolBlock(one) for one in (good[0], flat, bare, salt, good[1])]
    path = tmp_path / "library.sdf.gz"
    with gzip.open(path, "wt") as file:
        file.write("$$$$\n".join([*blocks, "no molecule\n", ""]))
    return path


def test_records_that_cannot_be_used_are_named(library):
    found = read_known(library)
    places = [one.name for one in found.molecules]
    assert places == ["molecule (library.sdf.gz, record 1)", "molecule (library.sdf.gz, record 5)"]
    assert found.skipped == [
        "library.sdf.gz, record 2: it has no positions in space",
        "library.sdf.gz, record 3: hydrogens are missing",
        "library.sdf.gz, record 4: it is of several parts",
        "library.sdf.gz, record 6: RDKit cannot read it",
    ]
    assert [one.name[-8:] for one in read_known(library, ring=9).molecules] == ["record 5)"[-8:]]
    with pytest.raises(pliant.InputError, match="no molecule with a known conformer"):
        read_known(library, ring=12)


def test_a_start_does_not_depend_on_the_known_conformer():
    molecule = embedded(STEREO, 2)
    starts = []
    for k in range(2):
        one = Chem.Mol(molecule, confId=k)
        starts.append(frames_of(start_of(one)))
    assert np.array_equal(*starts)


def test_a_contender_that_fails_or_is_slow_is_a_row(ligands, tmp_path, monkeypatch):
    worker = tmp_path / "worker.py"
    worker.write_text(
        "import pathlib, sys, time\n"
        "from pliant.checks.openmm import worker\n"
        "def fail(job): raise RuntimeError('CONF_GEN_FAILED')\n"
        "worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]),\n"
        "            {'fail': fail, 'slow': lambda job: time.sleep(3600)})\n"
    )
    jobs = [Job("fail", {}, {}), Job("slow", {}, {}), Job("fail", {}, {})]
    outcomes, _ = run_jobs(jobs, 2.0, clock_that_waits_for(2, monkeypatch), worker)
    subject = measure.Subject(ligands.molecules[0], np.zeros((1, 1), dtype=np.int64))
    entry = contenders.CONTENDERS[0]
    rows = [measure._run(entry, 5, subject, outcome).row for outcome in outcomes]
    assert [row.failure for row in rows] == [
        "raised an exception: CONF_GEN_FAILED",
        "took more than 2 s",
        "raised an exception: CONF_GEN_FAILED",
    ]
    assert all(row.nearest is None and row.made == 0 for row in rows)


def test_cpu_time_is_limited_and_the_rest_goes_on(ligands, monkeypatch):
    """One conformer takes hundredths of a second, so many at least a minute."""
    monkeypatch.setattr(measure, "_WALL", 900)
    found = KnownSet(ligands.molecules[:2])
    entry = next(one for one in contenders.CONTENDERS if one.name == "ETKDGv3")
    entry = dataclasses.replace(entry, most=20_000)
    runs = measure.run_all(found, [entry], [1, 20_000], limit=1.0, strain=False)
    failures = {run.row.asked: run.row.failure for run in runs}
    assert failures == {1: "", 20_000: "over the limit of CPU time"}
    assert len(runs) == 4


def made(molecule, contender, asked, distances, seconds):
    row = Made(molecule, contender, asked, 1.0, failure="" if distances else "none")
    if distances:
        row = Made(molecule, contender, asked, 1.0, len(distances), min(distances), seconds)
    return summary.Run(row, np.array(distances))


def test_shares_differences_and_equal_times():
    runs = [
        made("a", "Pliant", 2, [0.6, 0.4], 1.0),
        made("b", "Pliant", 2, [3.0, 2.0], 1.0),
        made("c", "Pliant", 2, [], 0.0),
        made("a", "Pliant", 4, [0.6, 0.4, 0.2, 0.1], 3.0),
        made("b", "Pliant", 4, [3.0, 2.0, 1.0, 0.9], 3.0),
        made("c", "Pliant", 4, [], 0.0),
        made("a", "CONFORGE", 2, [0.9, 0.5], 2.0),
        made("b", "CONFORGE", 2, [0.9, 0.8], 2.0),
        made("c", "CONFORGE", 2, [0.3, 0.7], 2.0),
    ]
    table = Table(3)
    summary.summarise(table, runs)
    shares = {(s.at, s.contender): s for s in table.shares}
    ours = shares["2 conformers", "Pliant"]
    assert (ours.molecules, ours.failed, ours.nearest) == (3, 1, pytest.approx(1.2))
    assert ours.within == pytest.approx((1 / 3, 1 / 3, 1 / 3, 2 / 3))
    equal = shares["equal CPU, 2 s", "Pliant"]
    assert (equal.made, equal.asked, equal.seconds) == (pytest.approx(2.0), 3, pytest.approx(2.0))
    assert equal.nearest == pytest.approx((0.2 + 1.0) / 2)
    first = table.differences[0]
    assert (first.other, first.at, first.molecules) == ("CONFORGE", "2 conformers", 2)
    assert first.nearest == pytest.approx(((0.4 - 0.5) + (2.0 - 0.8)) / 2)
    assert first.error == pytest.approx(1.3 / 2)
    assert first.within == pytest.approx(-0.5)


@pytest.mark.long
def test_the_command_measures_draws_and_writes(library, tmp_path, capsys):
    table, picture = tmp_path / "c.csv", tmp_path / "c.png"
    words = ["conformers", "--data", str(library), "--max", "3,6", "--csv", str(table)]
    assert main([*words, "-o", str(picture), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    names = [one.name for one in contenders.CONTENDERS if one.is_installed]
    assert {row["contender"] for row in found["rows"]} == set(names)
    assert len(found["skipped"]) == 4
    assert len(found["left_out"]) == 3 - len(names)
    assert all(row["handedness"] == row["double_bonds"] == 0 for row in found["flaws"])
    assert {row["at"] for row in found["differences"]} >= {"3 conformers", "6 conformers"}
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 4 * len(names)
    assert all(float(row["seconds"]) > 0 and row["failure"] == "" for row in rows)
    for row in rows:
        part = float(row["start_seconds"])
        assert (0 < part < float(row["seconds"])) == (row["contender"] == "Pliant")
    assert picture.stat().st_size > 10_000


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--only", "magic"), "--only magic: must be one of Pliant, ETKDGv3, CONFORGE"),
        (("--data", "nowhere.sdf"), "nowhere.sdf: no SDF or MOL file"),
    ],
)
def test_what_does_not_exist_is_refused(words, message, capsys):
    assert main(["conformers", *words]) in (1, 2)
    assert message in capsys.readouterr().err
