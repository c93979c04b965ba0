# SPDX-License-Identifier: MIT
"""pliant.check on good, tampered and impossible trajectories, with the real OpenMM."""

import numpy as np
import pytest
from cut_by_box import BOXES, cut_pdb
from made_trajectories import Made, molecule_run, moved
from pliant.checks.force_field.minimise import start_of
from pliant.trajectory.chosen_frames import choose_frames
from real_files import PEPTIDE

import pliant

CAFFEINE = "CN1C=NC2=C1C(=O)N(C(=O)N2C)C"
FEW = {"displacements": (0.05,), "frames": 5}


def found(report, name):
    return next(finding for finding in report.findings if finding.name == name)


def method(report, name):
    return next(m for m in report.methods if m.name == name)


@pytest.fixture(scope="module")
def caffeine():
    return molecule_run(CAFFEINE)


@pytest.fixture
def written(caffeine, tmp_path):
    return caffeine.write(tmp_path / "caffeine.h5md")


def test_a_good_trajectory_passes_everything(written):
    report = pliant.check(written, **FEW)
    assert report.passed
    assert {f.status for f in report.findings} == {"passed"}
    assert found(report, "frames_stay").figures["furthest_move"] == 0.0
    assert found(report, "broken_copies_move").figures["repaired"] == 5
    assert found(report, "energies_agree").figures["relative_difference"] < 1e-12


def test_frames_are_spread_and_hold_the_worst():
    assert choose_frames(100, 5).tolist() == [0, 25, 50, 74, 99]
    assert choose_frames(100, 5, always=60).tolist() == [0, 25, 60, 74, 99]
    assert choose_frames(3, 20).tolist() == [0, 1, 2]
    assert choose_frames(1000, "all").size == 1000
    assert choose_frames(7, 1, always=5).tolist() == [5]


def tampered(caffeine, by):
    """One atom of frame 7 moved, nothing else changed: what is recorded is what was."""
    positions = caffeine.positions.copy()
    positions[7, 3, 1] += by
    return Made(
        positions,
        caffeine.bars,
        caffeine.rest_lengths,
        caffeine.bonds,
        caffeine.elements,
        max_residual=caffeine.residual(),
    )


@pytest.mark.parametrize("by", [0.5, 1e-5])
def test_one_atom_moved_is_found(caffeine, tmp_path, by):
    path = tampered(caffeine, by).write(tmp_path / "tampered.h5md")
    report = pliant.check(path, displacements=(0.05,), frames="all")
    assert not report.passed
    record = found(report, "record")
    assert record.status == "failed"
    assert record.figures["broken"] == record.figures["recorded_differently"] == 1
    assert record.notes[0].startswith("1 frames are called converged and are not: step 7 (bar "), (
        record.notes
    )
    assert found(report, "frames_stay").status == "failed"
    assert "OpenMM moves 1 frames, the first is step 7" in found(report, "frames_stay").notes
    assert found(report, "energies_vanish").status == "failed"


def test_the_worst_frame_as_measured_is_always_shown_to_openmm(caffeine, tmp_path):
    path = tampered(caffeine, 0.5).write(tmp_path / "tampered.h5md")
    report = pliant.check(path, displacements=(0.05,), frames=2)
    assert report.sample.frames.tolist() == [0, 7]
    assert found(report, "frames_stay").figures["moved_too_far"] == 1


def test_a_wrong_rest_length_is_found(caffeine, tmp_path):
    rest = caffeine.rest_lengths.copy()
    rest[4] *= 1 + 1e-5
    made = Made(caffeine.positions, caffeine.bars, rest, caffeine.bonds, caffeine.elements)
    report = pliant.check(made.write(tmp_path / "rest.h5md"), **FEW)
    assert found(report, "record").status == "failed"
    assert found(report, "frames_stay").status == "failed"
    assert found(report, "energies_agree").status == "passed"


def test_a_frame_that_says_it_did_not_converge_is_held_to_nothing(caffeine, tmp_path):
    made = tampered(caffeine, 0.5)
    made.max_residual = None
    made.converged = np.arange(len(made.positions)) != 7
    report = pliant.check(made.write(tmp_path / "honest.h5md"), displacements=(0.05,))
    assert report.passed
    assert found(report, "record").figures["not_converged"] == 1
    note = found(report, "record").notes[0]
    assert note.startswith("1 of 12 frames say that they did not converge (the first is step 7, ")
    assert found(report, "frames_stay").notes == [
        "of 1 frames that say they did not converge OpenMM moves 1"
    ]


def test_when_no_frame_converged_nothing_is_called_passed(caffeine, tmp_path):
    made = Made(
        caffeine.positions + np.random.default_rng(0).normal(size=caffeine.positions.shape),
        caffeine.bars,
        caffeine.rest_lengths,
        caffeine.bonds,
        caffeine.elements,
        converged=np.zeros(len(caffeine.positions), bool),
    )
    report = pliant.check(made.write(tmp_path / "none.h5md"), **FEW)
    assert found(report, "frames_stay").status == "skipped"
    assert found(report, "energies_vanish").status == "skipped"
    assert found(report, "energies_agree").status == "passed"
    assert report.passed


def test_a_frame_without_numbers_fails_and_is_named(caffeine, tmp_path):
    made = tampered(caffeine, np.nan)
    report = pliant.check(made.write(tmp_path / "nan.h5md"), **FEW)
    assert not report.passed
    assert found(report, "record").figures["broken"] == 1
    assert 7 not in report.sample.frames


def test_a_wrong_recorded_residual_fails(caffeine, tmp_path):
    made = Made(
        caffeine.positions,
        caffeine.bars,
        caffeine.rest_lengths,
        caffeine.bonds,
        caffeine.elements,
        max_residual=caffeine.residual() * np.where(np.arange(12) == 4, 0.5, 1),
    )
    report = pliant.check(made.write(tmp_path / "given.h5md"), **FEW)
    record = found(report, "record")
    assert (record.status, record.figures["recorded_differently"]) == ("failed", 1)
    assert "1 frames do not have the residual that is recorded: step 4 (" in record.notes[0]


def test_single_precision_is_allowed_for_and_tampering_still_found(caffeine, tmp_path):
    report = pliant.check(caffeine.write(tmp_path / "single.h5md", "f4"), **FEW)
    assert report.passed, report.findings
    assert "positions are stored as 32-bit floats: what that changes is allowed for" in report.notes
    path = tampered(caffeine, 1e-4).write(tmp_path / "tampered.h5md", "f4")
    assert not pliant.check(path, **FEW).passed


def test_a_tolerance_in_angstrom(caffeine, tmp_path):
    made = molecule_run(CAFFEINE)
    made.tolerance, made.tolerance_length = 1e-12, 2e-6
    report = pliant.check(made.write(tmp_path / "length.h5md"), **FEW)
    assert report.passed, report.findings
    assert found(report, "record").allowed == "2e-06 A"


def test_angle_bars_openmm_keeps_whole_frames_and_cannot_repair(tmp_path):
    made = molecule_run(
        "CC(=O)NC(C)C(=O)NC", kind_of_bars="angles", tolerance=1e-4, displacement=0.003
    )
    path = made.write(tmp_path / "angles.h5md")
    with pytest.warns(pliant.PliantWarning, match="goes from bar to bar"):
        report = pliant.check(path, displacements=(0.1,), frames=5)
    assert found(report, "frames_stay").status == "passed"
    assert found(report, "energies_agree").status == "passed"
    applied = method(report, "OpenMM, applyConstraints").results[0]
    assert applied.whole == 0
    assert applied.outcome in ("5 of 5 not finite", "5 of 5 diverged")
    assert method(report, "Pliant, default").results[0].whole == 5
    assert report.passed


def test_water_is_settled_to_its_float_floor(tmp_path):
    water = np.array([[0, 0, 0], [0.9572, 0, 0], [-0.2399872, 0.9266272, 0]])
    start = np.concatenate(
        [water + np.array(v) for v in ([0, 0, 0], [3.1, 0, 0.7], [0, 3.3, -0.4])]
    )
    one = np.array([[0, 1], [0, 2], [1, 2]])
    bars = np.concatenate([one, one + 3, one + 6])
    rest = np.tile([0.9572, 0.9572, np.linalg.norm(water[1] - water[2])], 3)
    frames = moved(pliant.Framework(bars, rest, 9), start, 10, tolerance=1e-9)
    made = Made(frames, bars, rest, bars, list("OHH" * 3), tolerance=1e-9)
    report = pliant.check(made.write(tmp_path / "water.h5md"), **FEW)
    assert report.passed, report.findings
    figures = found(report, "frames_stay").figures
    assert 0 < figures["furthest_move"] <= figures["allowed_move"] < 1e-6
    assert "3 isolated triangles are SETTLE's" in found(report, "frames_stay").notes[0]


# Four beads and five distances of a cholesterol model on which CCMA diverges:
# https://github.com/openmm/openmm/issues/3603 (lengths and coordinates in nm as given there).
DIAMOND_BARS = np.array([[0, 1], [0, 2], [1, 2], [3, 1], [3, 2]])
DIAMOND_REST = np.array([4.904, 6.019, 2.719, 7.237, 5.376])
DIAMOND = np.array(
    [[55.66, 77.28, 32.13], [54.94, 79.73, 36.31], [53.54, 77.88, 37.73], [52.95, 78.11, 43.07]]
)


def test_the_diamond_that_ccma_cannot_repair(tmp_path):
    framework = pliant.Framework(DIAMOND_BARS, DIAMOND_REST, 4)
    frames = moved(framework, DIAMOND, 10, tolerance=1e-6)
    made = Made(frames, DIAMOND_BARS, DIAMOND_REST, DIAMOND_BARS, ["C"] * 4)
    report = pliant.check(made.write(tmp_path / "diamond.h5md"), displacements=(0.02,), frames=5)
    assert report.passed
    bare = method(report, "OpenMM, no angles").results[0]
    assert bare.whole < bare.structures and "diverged" in bare.outcome
    assert method(report, "Pliant, default").results[0].whole == 5
    # Given the angles of the very frame CCMA manages: the comparison is at its best, too.
    assert method(report, "OpenMM, applyConstraints").results[0].whole == 5


def test_pinned_joints_stay_and_are_free_where_openmm_repairs(tmp_path):
    made = molecule_run(CAFFEINE, pinned=(0, 5))
    report = pliant.check(made.write(tmp_path / "pinned.h5md"), **FEW)
    assert report.passed
    assert report.notes[0].startswith("2 pinned joints are free wherever bars are repaired")
    made.positions[3] += 0.25  # every bar as it was, but nothing may move what is pinned
    report = pliant.check(made.write(tmp_path / "slipped.h5md"), **FEW)
    assert found(report, "record").status == "failed"
    assert "a pinned joint moved by 4.3e-01 A" in found(report, "record").notes


def test_no_bar_at_all(tmp_path):
    frames = np.array([[[0.0, 0, 0], [1, 0, 0]]] * 3)
    made = Made(frames, np.empty((0, 2), int), np.empty(0), [], ["C"] * 2)
    report = pliant.check(made.write(tmp_path / "bare.h5md"))
    assert report.passed
    assert [f.status for f in report.findings] == ["passed", *["skipped"] * 4]


def test_the_same_seed_breaks_the_same_way(written):
    reports = [pliant.check(written, seed=s, **FEW) for s in (1, 1, 2)]
    before = [r.methods[0].results[0].residual_before for r in reports]
    assert before[0] == before[1] != before[2]


@pytest.mark.parametrize("with_cell", [True, False])
def test_a_start_that_its_periodic_box_cuts(tmp_path, with_cell):
    """Is made whole, and refused if the file does not say how large the box is."""
    peptide, path = pliant.read(PEPTIDE), tmp_path / "cut.pdb"
    path.write_text(cut_pdb(peptide, BOXES["right"], with_cell=with_cell))
    if with_cell:
        ends = start_of("none.h5md", peptide, path)[peptide.bonds]
        assert np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).max() < 2.5
        return
    with (
        pytest.warns(pliant.PliantWarning, match="cut by a periodic box"),
        pytest.raises(pliant.InputError, match=r"cut\.pdb: bond A:.* cut by a periodic box; make"),
    ):
        start_of("none.h5md", peptide, path)
