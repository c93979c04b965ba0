# SPDX-License-Identifier: MIT
"""Every number of a report on a real ensemble, recomputed by MDAnalysis or numpy."""

import csv
import html
import re
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from MDAnalysis.analysis import align, dihedrals, rms
from MDAnalysis.lib.distances import calc_angles, capped_distance
from pliant.measure.ramachandran import FAVOURED, OUTLIER, judged
from pliant.report.sections.contacts import ContactFrequencies
from pliant.report.sections.domains import Correlations
from pliant.report.sections.exports import b_factors
from pliant.report.sections.flexible import UnitFlexibility
from pliant.report.sections.motions import Components
from pliant.report.sections.stereochemistry import Shapes
from real_files import PEPTIDE

pytestmark = pytest.mark.usefixtures("no_drawing")

ENDS = ("resid 1 and name CA", "resid 20 and name CA")


def command(*words):
    """Runs the installed command."""
    program = Path(sys.executable).with_name("pliant")
    subprocess.run([program, *map(str, words)], check=True, capture_output=True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("numbers")


@pytest.fixture(scope="module")
def report(folder):
    """A report of 200 frames of a peptide of 20 residues."""
    command("sample", PEPTIDE, "-o", folder / "peptide.h5md", "--quiet")
    return pliant.analyse(folder / "peptide.h5md", folder / "out", distances=[ENDS], dpi=50)


@pytest.fixture(scope="module")
def universe(report, folder):
    """The frames of the file, in memory, as MDAnalysis reads them."""
    found = MDAnalysis.Universe(folder / "peptide.h5md", topology_format="H5MD")
    found.transfer_to_memory()
    return found


@pytest.fixture(scope="module")
def places(universe, folder):
    """(F, 20, 3) CA atoms on their average, superposed by MDAnalysis alone."""
    trace = MDAnalysis.Merge(universe.select_atoms("name CA"))
    array = universe.trajectory.get_array()[:, universe.select_atoms("name CA").ix]
    trace.load_new(array.copy(), order="fac")
    average = MDAnalysis.Merge(trace.atoms)
    for _ in range(12):
        average.atoms.positions = trace.trajectory.get_array().mean(axis=0)
        align.AlignTraj(trace, average, in_memory=True).run()
    return trace.trajectory.get_array().astype(float)


def rows(folder, name):
    with open(folder / "out" / f"{name}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def column(folder, table, name):
    return np.array([float(row[name]) for row in rows(folder, table)])


def test_rmsf_of_residues_is_that_of_mdanalysis(folder, universe, places):
    trace = MDAnalysis.Merge(universe.select_atoms("name CA")).load_new(places, order="fac")
    theirs = rms.RMSF(trace.atoms).run().results.rmsf
    ours = column(folder, "flexibility", "rmsf_angstrom")
    np.testing.assert_allclose(ours, theirs, atol=2e-4)
    assert [row["number"] for row in rows(folder, "flexibility")] == [
        str(k) for k in universe.select_atoms("name CA").resids
    ]


def test_errors_are_those_of_blocks_of_a_hundred(folder, places):
    parts = np.sqrt(places.reshape(2, 100, -1, 3).var(axis=1).sum(axis=2))
    for k, name in enumerate(("first_half_angstrom", "second_half_angstrom")):
        np.testing.assert_allclose(column(folder, "flexibility", name), parts[k], atol=2e-4)
    error = column(folder, "flexibility", "error_angstrom")
    relative = np.abs(parts[0] - parts[1]) / 2 / parts.mean(axis=0)
    # of the mean of two: pooled over residues, and 2.36 / 2 for Student's t of seven degrees
    assert error.mean() == pytest.approx(
        1.18 * np.sqrt(np.mean(relative**2)) * parts.mean(), rel=0.3
    )


def test_correlations_are_those_of_numpy(report, places):
    moved = places - places.mean(axis=0)
    dots = np.einsum("fia,fja->ij", moved, moved)
    expected = dots / np.sqrt(np.outer(np.diag(dots), np.diag(dots)))
    np.testing.assert_allclose(report.analysis[Correlations].matrix, expected, atol=1e-3)


def test_rmsd_and_size_are_those_of_mdanalysis(folder, universe):
    start = MDAnalysis.Universe(folder / "peptide.pdb")
    theirs = rms.RMSD(universe, start, select="name CA", groupselections=["all"]).run()
    np.testing.assert_allclose(
        column(folder, "frames", "rmsd_angstrom"), theirs.results.rmsd[:, 2], atol=1e-4
    )
    np.testing.assert_allclose(
        column(folder, "frames", "rmsd_all_angstrom"), theirs.results.rmsd[:, 3], atol=1e-4
    )
    sizes = [universe.atoms.radius_of_gyration() for _ in universe.trajectory]
    np.testing.assert_allclose(
        column(folder, "frames", "radius_of_gyration_angstrom"), sizes, atol=1e-4
    )


def test_distances_are_those_of_mdanalysis(folder, report, universe):
    first, last = (universe.select_atoms(end) for end in ENDS)
    theirs = [
        float(np.linalg.norm(first.positions[0] - last.positions[0])) for _ in universe.trajectory
    ]
    name = f"distance {ENDS[0]} to {ENDS[1]} (angstrom)"
    np.testing.assert_allclose(column(folder, "frames", name), theirs, atol=1e-4)
    (distance,) = report.as_json()["distances"]
    assert distance["mean"] == pytest.approx(np.mean(theirs), abs=1e-4)
    assert distance["sd"] == pytest.approx(np.std(theirs), abs=1e-4)


def test_components_are_those_of_numpy(report, places):
    values = np.linalg.eigvalsh(np.cov(places.reshape(len(places), -1).T))[::-1]
    found = report.analysis[Components].found
    np.testing.assert_allclose(found.eigenvalues[:10], values[:10], rtol=1e-3)
    np.testing.assert_allclose(found.explained[:10], values[:10] / values.sum(), rtol=1e-3)


def test_backbone_angles_are_those_of_mdanalysis(folder, universe):
    inner = universe.select_atoms("resid 2:19 and not resname GLY PRO")
    angles = dihedrals.Ramachandran(inner).run().results.angles
    found = judged(angles[..., 0], angles[..., 1])
    looked_at = column(folder, "stereochemistry", "frame").astype(int)
    for name, region in (("outliers", OUTLIER), ("favoured", FAVOURED)):
        expected = np.mean(found == region, axis=1)[looked_at]
        np.testing.assert_allclose(
            column(folder, "stereochemistry", f"ramachandran_{name}"), expected, atol=1e-9
        )


def test_changes_of_angles_are_those_of_mdanalysis(folder, report, universe):
    start = MDAnalysis.Universe(folder / "peptide.pdb").atoms.positions
    triples = report.analysis[Shapes].measured.corners.angles
    graph = {frozenset(bond) for bond in universe.bonds.indices.tolist()}
    assert {frozenset(pair) for pair in triples[:, :2].tolist()} <= graph
    assert {frozenset(pair) for pair in triples[:, 1:].tolist()} <= graph

    def angles(positions):
        return np.degrees(calc_angles(*(positions[triples[:, k]] for k in range(3))))

    changes = column(folder, "stereochemistry", "largest_angle_change_degrees")
    looked_at = column(folder, "stereochemistry", "frame").astype(int)
    for k in (0, 50, 99):
        universe.trajectory[looked_at[k]]
        expected = np.abs(angles(universe.atoms.positions) - angles(start)).max()
        assert changes[k] == pytest.approx(expected, abs=5e-3)


def test_contacts_are_those_of_mdanalysis(folder, report, universe):
    heavy = universe.select_atoms("not element H")
    looked_at = column(folder, "stereochemistry", "frame").astype(int)
    counts = {}
    for frame in looked_at:
        universe.trajectory[frame]
        pairs = capped_distance(heavy.positions, heavy.positions, 4.5, return_distances=False)
        ends = heavy.resindices[pairs]
        for a, b in {(a, b) for a, b in ends.tolist() if b - a > 3}:
            counts[a, b] = counts.get((a, b), 0) + 1
    found = report.analysis[ContactFrequencies]
    shares = dict(zip(map(tuple, found.pairs.tolist()), found.share, strict=True))
    assert {pair for pair, share in shares.items() if share > 0} == set(counts)
    for pair, count in counts.items():
        assert shares[pair] == pytest.approx(count / len(looked_at), abs=0.011)


def test_b_factors_and_frames_in_pdb_files(folder, universe):
    rmsf = column(folder, "flexibility", "rmsf_angstrom")
    coloured = MDAnalysis.Universe(folder / "out" / "bfactors.pdb")
    expected = 8 * np.pi**2 / 3 * rmsf**2
    np.testing.assert_allclose(b_factors(rmsf), expected)
    written = [residue.atoms.tempfactors for residue in coloured.residues]
    for values, one in zip(written, expected, strict=True):
        np.testing.assert_allclose(values, min(one, 999.99), atol=0.01)
    played = MDAnalysis.Universe(folder / "out" / "ensemble.pdb")
    assert len(played.trajectory) == 25
    head = (folder / "out" / "ensemble.pdb").read_text().split("MODEL")[0]
    sentence = head.split("frames")[1].replace("REMARK  99", "")
    numbers = [int(word) for word in re.findall(r"\d+", sentence)]
    for k in (0, 24):
        played.trajectory[k]
        universe.trajectory[numbers[k]]
        distance = rms.rmsd(played.atoms.positions, universe.atoms.positions, superposition=True)
        assert distance < 2e-3


def test_the_page_says_what_the_tables_hold(folder, report):
    text = html.unescape((folder / "out" / "report.html").read_text(encoding="utf-8"))
    rmsf = column(folder, "flexibility", "rmsf_angstrom")
    assert f"{rmsf.max():.3f}" in text
    assert f"{rmsf.mean():.2f} Å reached" in text
    assert "1.40 Å requested" in text
    as_json = report.as_json()
    assert as_json["frames_are"] == "ensemble"
    assert f"correlate at {as_json['halves_correlation']:.3f}" in text
    shares = [float(row["explained"]) for row in rows(folder, "pca")]
    for share in shares[:5]:
        assert f"{100 * share:.1f} %" in text


def test_prody_reads_the_modes(folder, report):
    prody = pytest.importorskip("prody")
    modes, atoms = prody.parseNMD(str(folder / "out" / "modes.nmd"))
    found = report.analysis[Components].found
    assert atoms.numAtoms() == 20
    assert modes.numModes() == 10
    # the square of a mode's scale is taken for the inverse of its eigenvalue, as of normal modes
    np.testing.assert_allclose(1 / modes.getEigvals(), found.eigenvalues[:10], rtol=1e-3)
    np.testing.assert_allclose(modes.getEigvecs().T, found.components[:10], atol=2e-5)
    np.testing.assert_allclose(atoms.getCoords(), found.average, atol=6e-4)


def test_the_modes_are_lines_that_any_program_reads(folder, report):
    lines = dict(
        line.split(" ", 1)
        for line in (folder / "out" / "modes.nmd").read_text().splitlines()
        if not line.startswith("mode ")
    )
    assert lines["atomnames"].split() == ["CA"] * 20
    assert lines["resids"].split() == [str(k) for k in range(1, 21)]
    assert len(lines["coordinates"].split()) == 60
    assert len(lines["bfactors"].split()) == 20


def test_a_run_is_no_ensemble_and_no_tick_is_green_where_a_question_fails(tmp_path):
    """Bars alone leave angles free: each is whole, and the molecule is not."""
    command("run", PEPTIDE, "-o", tmp_path / "bars.h5md", "--steps", 150, "--quiet")
    found = pliant.analyse(tmp_path / "bars.h5md", tmp_path / "out", dpi=50).as_json()
    assert found["frames_are"] == "path"
    assert found["verdicts"]["what it is"] == {
        "kind": "mixed",
        "text": "A path of pushes, not an ensemble.",
    }
    assert found["verdicts"]["convergence"]["kind"] == "mixed"
    assert found["verdicts"]["bars"]["kind"] == "good"
    assert found["verdicts"]["stereochemistry"]["kind"] == "bad"
    assert found["judgement"] == found["verdict"] == "bad"
    assert "Stereochemistry is broken" in found["verdict_text"]
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    body = page[page.index("<body>") :]
    assert 'class="one bad"' in body
    assert "one good" not in body
    assert "card good" not in body


def test_frames_that_are_all_alike_are_said_to_be(tmp_path):
    """Modes of a network bend caffeine, and its angles do not let them."""
    command("sample", PEPTIDE.with_name("caffeine.sdf"), "-o", tmp_path / "x.h5md", "--quiet")
    found = pliant.analyse(tmp_path / "x.h5md", tmp_path / "out", dpi=50).as_json()
    assert found["verdicts"]["convergence"] == {"kind": "mixed", "text": "Nothing moves."}
    assert found["judgement"] == "mixed"
    assert found["skipped"]["PCA"] == "nothing moves"
    assert not (tmp_path / "out" / "correlations.csv").exists()


def test_contacts_and_redraws_of_frames_are_those_of_the_file(folder, report):
    with h5py.File(folder / "peptide.h5md") as file:
        for name in ("redraws", "contacts_held", "contacts_broken", "contacts_off"):
            recorded = file[f"observables/{name}/value"][:]
            assert np.array_equal(column(folder, "frames", name), recorded), name
        again = np.count_nonzero(file["observables/redraws/value"][:])
    text = report.as_json()["verdicts"]["draws"]["text"]
    drawn = "No frame had to be redrawn."
    assert text == (f"{again} of 200 frames had to be redrawn." if again else drawn)


@pytest.mark.parametrize(("frames", "kind"), [([3, 11], "good"), (range(20, 40), "mixed")])
def test_frames_drawn_again_are_named(folder, report, tmp_path, frames, kind):
    """As the file says it, and not of files that say nothing."""
    path = tmp_path / "again.h5md"
    shutil.copy(folder / "peptide.h5md", path)
    with h5py.File(path, "r+") as file:
        redraws = np.zeros(200, dtype=np.int64)
        redraws[list(frames)] = 2
        file["observables/redraws/value"][:] = redraws
    found = pliant.analyse(path, tmp_path / "out", dpi=50)
    verdict = found.as_json()["verdicts"]["draws"]
    assert verdict == {"kind": kind, "text": f"{len(frames)} of 200 frames had to be redrawn."}
    page = html.unescape((tmp_path / "out" / "report.html").read_text(encoding="utf-8"))
    named = ", ".join(map(str, list(frames)[:10]))
    assert f"The first attempts at frames {named}" in page
    assert "each took up to 3 attempts" in page


def test_nothing_is_said_of_draws_where_the_file_says_nothing(folder, report, tmp_path):
    path = tmp_path / "silent.h5md"
    shutil.copy(folder / "peptide.h5md", path)
    with h5py.File(path, "r+") as file:
        del file["observables/redraws"]
    found = pliant.analyse(path, tmp_path / "out", dpi=50)
    assert "draws" not in found.as_json()["verdicts"]


@pytest.mark.long
def test_two_errors_hold_what_a_long_run_finds(tmp_path):
    """20 short ensembles beside one 20 times as long, from other random numbers."""
    for name, seed in (("long", 1), ("short", 2)):
        words = ["--frames", 4000, "--seed", seed, "--quiet"]
        command("sample", PEPTIDE, "-o", tmp_path / f"{name}.h5md", *words)
    expected = pliant.analyse(tmp_path / "long.h5md").analysis[UnitFlexibility].found.rmsf
    inside = []
    for first in range(0, 4000, 200):
        part = pliant.analyse(tmp_path / "short.h5md", start=first, stop=first + 200)
        found = part.analysis[UnitFlexibility].found
        inside.append(np.abs(found.rmsf - expected) <= 2 * found.error)
    assert 0.90 <= np.mean(inside) <= 0.98


def test_conformers_were_asked_for_no_amplitude(tmp_path):
    command("sample", PEPTIDE.with_name("aspirin.sdf"), "-o", tmp_path / "aspirin.h5md", "--quiet")
    pliant.analyse(tmp_path / "aspirin.h5md", tmp_path / "out", dpi=50)
    text = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Frames are independent" in text
    assert "mplitude" not in text.split("<script")[0].split("Options of the run")[0]
