# SPDX-License-Identifier: MIT
"""pliant study: one command, one folder, one page, a sentence an answer."""

import json
import re
from dataclasses import replace
from html import escape
from pathlib import Path
from types import SimpleNamespace

import pytest
from pliant.base.verdict import verdict_of_all
from pliant.checks.findings import Finding
from pliant.checks.force_field import verdicts as verdicts_of_md
from pliant.report.check.check_report import CheckReport
from pliant.report.study.studied import LABELS
from pliant.report.study.suite import STAGES
from real_files import MOLECULES, PEPTIDE

import pliant

MDAnalysis = pytest.importorskip("MDAnalysis")
additions = pytest.importorskip("pliant.report.study.sections").additions
scene = pytest.importorskip("pliant.report.page.scene").scene
report_of = pytest.importorskip("pliant.report.write").report_of
UnitFlexibility = pytest.importorskip("pliant.report.sections.flexible").UnitFlexibility
main = pytest.importorskip("pliant.report.study.command").main

pytestmark = pytest.mark.usefixtures("no_drawing")

WATER = "HETATM 9001  O   HOH A 901      60.000  60.000  60.000  1.00  0.00           O\n"


def answers(out):
    """{label: answer} of what the command prints."""
    return {line[:14].strip(): line[14:] for line in out.splitlines()}


def verdicts(study):
    return report_of(study.report.analysis, additions(study)).verdicts


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


def test_the_bar_has_room_for_all_stages():
    measured = pytest.importorskip("pliant.report.sections.table").STAGES
    others = (
        "sampling",
        "reading",
        "fit",
        "path",
        "representatives",
        "MD starts",
        "figures and page",
    )
    assert len(measured) + len(others) == STAGES


def test_the_answers_are_at_the_head_of_the_page(studied):
    page = studied.page.read_text()
    head = page.index('<section class="answers card">')
    assert page.index('<section class="verdict card') < head
    assert page.index("pliant study") < head
    for what, answer in studied.answers.items():
        label = LABELS.get(what, what)
        assert what in ("verdict", "page", "files") or f"<h3>{label}</h3>" in page, answer
    for key in re.findall(r'<canvas data-colour="(\w+)"', page):
        assert key in scene(studied.report.analysis)["units"]
    assert '<a href="representatives.pdb">' in page


def test_checks_that_are_no_reason_for_doubt_are_folded_away(studied):
    shown, folded = studied.page.read_text().split("<summary>What was checked</summary>")
    for one in verdicts(studied).values():
        where = folded if one.kind in ("good", "open") else shown
        assert f"<b>{escape(one.sentence)}</b>" in where


def test_what_is_flexible_and_what_was_left_out_is_said(studied):
    said = studied.answers
    assert list(said) == [
        *("verdict", "how far", "flexible", "together", "other shapes", "MD starts"),
        *("molecule", "left out", "page", "files"),
    ]
    assert said["left out"] == "1 water."
    assert said["molecule"].startswith("20 residues")
    flexibility = studied.report.analysis[UnitFlexibility].found
    assert f" RMSF {flexibility.rmsf.max():.1f}," in said["flexible"]
    assert re.search(r"precision \d+ %; accuracy, how near", said["flexible"])
    assert said["how far"].startswith("How far it moves is not known. Around the start a residue")
    assert "an input: which parts move more than others is the result" in said["flexible"]
    assert said["MD starts"] == "Not tested: --no-check."


def test_the_verdict_comes_first_and_is_one(studied):
    values = studied.as_json()
    assert list(values)[:2] == ["verdict", "verdict_text"]
    judged = studied.report.verdict
    assert judged.sentence == studied.answers["verdict"] == values["verdict_text"]
    analysis = values["analysis"]
    assert analysis["verdict_text"] == analysis["judgement_text"] == judged.sentence
    assert f"<strong>{judged.sentence}</strong>" in studied.page.read_text()
    assert "Not checked: MD starts" in judged.sentence + judged.details


def checked(**failed):
    """A check of an ensemble in which some findings failed."""
    findings = [
        Finding("record", "bars of all frames, measured anew", "passed"),
        Finding("starts_moved", "MD starts: shift of alpha carbons in 100 steps", "passed"),
    ]
    for one in findings:
        if one.name in failed:
            one.status, one.measured, one.allowed = "failed", failed[one.name], "0.40 A"
    return findings


@pytest.mark.parametrize(
    ("failed", "kind", "words"),
    [
        ({}, "good", "MD starts (3 of 20 frames tested)"),
        (
            {"starts_moved": "0.48 A"},
            "mixed",
            "Do not start MD from these frames: shift of alpha carbons in 100 steps: 0.48 A "
            "(0.40 A allowed). 3 of 20 frames tested.",
        ),
        ({"record": "0.1"}, "bad", "Do not use these frames as they are. Checks failed: bars of"),
    ],
)
def test_what_openmm_finds_is_part_of_the_verdict(studied, failed, kind, words, monkeypatch):
    findings = checked(**failed)
    monkeypatch.setattr(verdicts_of_md, "findings_of", lambda report: findings[1:])
    force_field = SimpleNamespace(
        left_out={}, ligands=[], usable=[1, 2, 3], why_not="", without="", subject=""
    )
    recording = range(20)
    check = CheckReport(recording, None, None, findings, [], "", 0.0, force_field=force_field)
    found = replace(studied, check=check)
    made = verdicts(found)
    judged = verdict_of_all(
        one for one in made.values() if one.kind != "mixed" or "MD" in one.sentence
    )
    assert judged.kind == kind
    assert words in judged.sentence
    assert "starts_moved" not in judged.sentence
    assert check.verdict.kind == kind


def test_what_the_structure_lacks_is_in_the_verdict(studied):
    facts = {**studied.sampled.facts, "missing": ["1 chain break: A 5 to 9"], "warnings": ["so"]}
    found = replace(studied, sampled=replace(studied.sampled, facts=facts))
    made = verdicts(found)["input"]
    assert made.kind == "mixed"
    assert made.sentence == "The structure is incomplete: 1 chain break: A 5 to 9."


def test_a_path_that_did_not_arrive_is_in_the_verdict(studied):
    path = SimpleNamespace(arrived=False, reached=2.1, frames=[SimpleNamespace(to_end=6.9)])
    made = verdicts(replace(studied, path=path, end="end.pdb"))["path"]
    assert (made.kind, made.sentence) == (
        "mixed",
        "No path to end.pdb was found: 2.1 Å of 6.9 Å are left.",
    )


def test_the_files_that_are_named_are_there_and_the_scripts_load_them(studied):
    folder = studied.folder
    named = re.findall(r"[\w.]+\.(?:pdb|h5md|pml|cxc)", studied.answers["files"].split(": ", 1)[1])
    assert {"ensemble.h5md", "representatives.pdb", "show.pml"} <= set(named)
    for name in named:
        assert (folder / name).exists(), name
    pymol, chimerax = ((folder / f"show.{end}").read_text() for end in ("pml", "cxc"))
    for loaded in re.findall(r"^load (\S+),", pymol, re.M) + re.findall(
        r"^open (\S+)", chimerax, re.M
    ):
        assert (folder / loaded).exists(), loaded
    assert "load representatives.pdb, representatives" in pymol
    assert "open representatives.pdb id 2" in chimerax
    objects = set(re.findall(r"^load \S+, (\S+)", pymol, re.M))
    for prefix in re.findall(r"^(?:enable|zoom|disable) (\w+)_?\*?", pymol, re.M):
        assert any(one.startswith(prefix.rstrip("_")) for one in objects | {"all"}), prefix


@pytest.mark.long
def test_the_command_prints_a_line_an_answer(studied, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main([str(PEPTIDE), "--frames", "8", "--no-check"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert len(out.splitlines()) == 11
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
    assert re.match(r"[\d.]+ Å to end\.pdb \(RMSD of CA\)", found["answers"]["how far"])
    assert "How it gets there" in (tmp_path / "out" / "report.html").read_text()


def test_conformers_of_a_small_molecule_are_studied(tmp_path, capsys):
    words = [str(MOLECULES / "aspirin.sdf"), "-o", str(tmp_path / "out"), "--frames", "30"]
    assert main(words) == 0
    said = answers(capsys.readouterr().out)
    assert "its frames are conformers" in said["molecule"]
    assert said["moves as one"].endswith("rotatable bonds.")
    assert said["other shapes"].startswith("30 conformers; 20 stand for all, within ")
    assert "MD starts" not in said and "an input" not in said["flexible"]


@pytest.mark.long
def test_openmm_looks_at_a_few_frames(tmp_path, capsys):
    pytest.importorskip("openmm")
    words = [str(PEPTIDE), "-o", str(tmp_path / "out"), "--frames", "8"]
    assert main([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["check"]["covers"] == {"frames": 8, "md_starts": 5, "left_out": {}}
    assert found["answers"]["MD starts"].endswith("5 of 8 frames tested.")
    assert "Starting molecular dynamics" in (tmp_path / "out" / "report.html").read_text()


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["none.pdb"], 1, "cannot read none.pdb: No such file or directory"),
        (["none.pdb", "--demo"], 2, "--demo: goes with neither FILE nor --smiles"),
        (["none.pdb", "--frames", "2"], 2, "--frames: expected a whole number from 4, found '2'"),
        (["none.pdb", "--seed", "-1"], 2, "--seed: expected a whole number from 0, found '-1'"),
        (
            ["none.pdb", "end.pdb", "--free-torsions"],
            2,
            "free_torsions: does not go with END: pliant path does not take it",
        ),
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


def test_options_of_the_molecule_go_to_the_sample(tmp_path):
    """As text, number or path where `sample` takes these, too."""
    options = {"select": "resid 1:9", "keep": "GOL,SO4", "hbond_cutoff": -2, "frame": 1}
    found = pliant.study(
        PEPTIDE, output=tmp_path / "out", frames=4, check=False, distance_bonds=False, **options
    )
    kept = pliant.H5mdReader(found.sampled.ensemble).parameters()
    names = ("input/select", "model/keep", "model/hbond_cutoff", "input/distance_bonds")
    assert [kept[name] for name in names] == ["resid 1:9", "GOL,SO4", -2.0, False]
    assert found.answers["molecule"].startswith("9 residues")
    with pytest.raises(TypeError, match=r"study: has no argument 'chek' \(did you mean 'check'"):
        pliant.study(PEPTIDE, chek=False)
    with pytest.raises(pliant.Error, match=r"none\.csv"):
        pliant.study(PEPTIDE, output=tmp_path / "o", contacts=tmp_path / "none.csv")
    assert not (tmp_path / "o").exists()


def test_stereo_that_a_smiles_leaves_open_is_said(tmp_path, capsys):
    pytest.importorskip("rdkit")
    words = ["--smiles", "CC(F)CO", "-o", str(tmp_path / "out"), "--frames", "8"]
    assert main(words) == 0
    said = "SMILES 'CC(F)CO': 1 stereo centre is not given: one isomer was made"
    assert f"warning: {said}\n" in capsys.readouterr().err
    assert main([*words, "--overwrite", "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert shown["sample"]["warnings"][0] == said


def test_a_smiles_is_studied(tmp_path, capsys):
    pytest.importorskip("rdkit")
    words = ["--smiles", "OCC(O)CO", "-o", str(tmp_path / "out"), "--frames", "20"]
    assert main(words) == 0
    assert answers(capsys.readouterr().out)["molecule"].startswith("14 atoms, a small molecule")
    assert (tmp_path / "out" / "molecule.sdf").exists()
    assert main([*words[:2], str(MOLECULES / "aspirin.sdf")]) == 2
    expected = "pliant study: error: FILE, --smiles: expected one of the two\n"
    assert capsys.readouterr().err == expected


def test_the_helix_of_the_package_is_studied(tmp_path):
    folder = tmp_path / "first"
    assert main(["--demo", "-o", str(folder), "--frames", "40", "--no-check"]) == 0
    universe = MDAnalysis.Universe(folder / "ensemble.pdb", folder / "ensemble.h5md")
    assert (universe.trajectory.n_frames, len(universe.residues)) == (40, 20)
    assert (folder / "report.html").is_file()
