# SPDX-License-Identifier: MIT
"""pliant study: one command, one folder, one page, at most nine lines."""

import json
from pathlib import Path

import pytest

import pliant

pytest.importorskip("MDAnalysis")
main = pytest.importorskip("pliant.study.command").main

MOLECULES = Path(__file__).parents[3] / "data" / "molecules"
PEPTIDE = MOLECULES / "peptide_20.pdb"
WATER = "HETATM 9001  O   HOH A 901      60.000  60.000  60.000  1.00  0.00           O\n"


def answers(out):
    """{label: answer} of what the command prints."""
    return {line[:14].strip(): line[14:] for line in out.splitlines()}


@pytest.fixture(scope="module")
def studied(tmp_path_factory):
    """Of a peptide with a water."""
    folder = tmp_path_factory.mktemp("study")
    file = folder / "wet.pdb"
    lines = [line for line in PEPTIDE.read_text().splitlines(True) if line.startswith("ATOM")]
    file.write_text("".join([*lines, WATER, "END\n"]))
    return pliant.study(file, output=folder / "out", frames=20, check=False)


def test_one_folder_has_a_page_an_ensemble_and_representatives(studied):
    names = {path.name for path in studied.folder.iterdir()}
    wanted = "report.html ensemble.h5md ensemble.pdb representatives.pdb flexibility.csv show.pml"
    assert set(wanted.split()) <= names
    assert studied.page == studied.folder / "report.html"
    assert len(studied.representatives.frames) == 20


def test_the_answers_are_at_the_head_of_the_page(studied):
    page = studied.page.read_text()
    head = page.index('<section class="answers card">')
    assert head < page.index('<section class="verdict card')
    assert page.index("pliant study") < head
    for what, answer in studied.answers.items():
        assert what in ("verdict", "page") or f"<td>{what}</td>" in page, answer
    assert '<a href="representatives.pdb">' in page


def test_what_is_flexible_and_what_was_left_out_is_said(studied):
    said = studied.answers
    assert list(said) == [
        *("molecule", "left out", "flexible", "together", "other shapes"),
        *("MD starts", "verdict", "page"),
    ]
    assert said["left out"] == "1 water"
    assert said["molecule"].startswith("20 residues")
    flexibility = studied.report.analysis[pliant.analyse.parts.UnitFlexibility].found
    assert f"{flexibility.rmsf.max():.1f} ± " in said["flexible"].split(",")[0]
    assert "the size follows from the amplitude, an input" in said["flexible"]
    assert said["MD starts"] == "not looked at: --no-check"


@pytest.mark.long
def test_the_command_prints_a_line_an_answer(studied, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main([str(PEPTIDE), "--frames", "8", "--no-check"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert len(out.splitlines()) == 8
    assert answers(out)["page"] == "peptide_20-study/report.html"
    assert main([str(PEPTIDE), "--no-check"]) == 1
    assert capsys.readouterr().err == (
        "pliant study: error: peptide_20-study/ensemble.h5md: exists; --overwrite replaces it\n"
    )


@pytest.mark.long
def test_a_path_to_another_structure_is_part_of_it(studied, tmp_path, capsys):
    model = studied.sampled.ensemble
    reader = pliant.H5mdReader(model)
    end = tmp_path / "end.pdb"
    pliant.write_topology_pdb(end, reader.structure(), positions=reader.positions(5))
    words = [str(PEPTIDE), str(end), "-o", str(tmp_path / "out"), "--frames", "8", "--no-check"]
    assert main([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["path"]["rmsd_reached"] <= found["path"]["rmsd_at_start"]
    assert Path(found["outputs"]["path"]).exists()
    assert "end.pdb" in found["answers"]["path"]
    assert "How it gets there" in (tmp_path / "out" / "report.html").read_text()


def test_conformers_of_a_small_molecule_are_studied(tmp_path, capsys):
    words = [str(MOLECULES / "aspirin.sdf"), "-o", str(tmp_path / "out"), "--frames", "30"]
    assert main(words) == 0
    said = answers(capsys.readouterr().out)
    assert "its frames are conformers" in said["molecule"]
    assert said["together"].endswith("rotatable bonds")
    assert said["other shapes"].startswith("30 conformers; 20 stand for all, within ")
    assert "MD starts" not in said and "an input" not in said["flexible"]


@pytest.mark.long
def test_openmm_looks_at_a_few_frames(tmp_path, capsys):
    pytest.importorskip("openmm")
    words = [str(PEPTIDE), "-o", str(tmp_path / "out"), "--frames", "8"]
    assert main([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["check"]["covers"] == {"frames": 8, "md_starts": 5, "left_out": {}}
    assert found["answers"]["MD starts"].endswith("; 5 of 8 frames were looked at")
    assert "Starting molecular dynamics" in (tmp_path / "out" / "report.html").read_text()


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["none.pdb"], 1, "cannot read none.pdb: No such file or directory"),
        (["none.pdb", "--frames", "2"], 2, "--frames: expected a whole number from 4, found '2'"),
        (["none.pdb", "--seed", "-1"], 2, "--seed: expected a whole number from 0, found '-1'"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(words, code, message, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    try:
        ended = main(words)
    except SystemExit as stopped:
        ended = stopped.code
    assert ended == code
    assert capsys.readouterr().err.splitlines()[0] == f"pliant study: error: {message}"
    assert list(tmp_path.iterdir()) == []


def test_a_smiles_is_studied(tmp_path, capsys):
    pytest.importorskip("rdkit")
    words = ["--smiles", "OCC(O)CO", "-o", str(tmp_path / "out"), "--frames", "20"]
    assert main(words) == 0
    assert answers(capsys.readouterr().out)["molecule"].startswith("14 atoms, a small molecule")
    assert (tmp_path / "out" / "molecule.sdf").exists()
    assert main([*words[:2], str(MOLECULES / "aspirin.sdf")]) == 2
    expected = "pliant study: error: FILE, --smiles: expected one of the two\n"
    assert capsys.readouterr().err == expected
