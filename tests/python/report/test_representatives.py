# SPDX-License-Identifier: MIT
"""Representatives: the frames it chooses, and what it says when it cannot."""

import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from MDAnalysis.analysis import rms
from pliant.adapters.convert import command as convert
from pliant.measure.shapes.medoids import k_medoids
from pliant.measure.stages.names import residue_labels
from pliant.report.representatives import representatives
from pliant.trajectory.superposition import pairwise_rmsd

import pliant

pytestmark = pytest.mark.usefixtures("no_drawing")


@pytest.fixture
def run(tmp_path, peptide, wander, write_run):
    trajectory = wander(peptide, peptide.rotatable, 40, degrees=25.0)
    return write_run(tmp_path / "run.h5md", peptide, trajectory)


def test_distances_are_those_of_mdanalysis():
    positions = np.random.default_rng(1).standard_normal((12, 9, 3))
    found = pairwise_rmsd(positions)
    for i in range(12):
        for j in range(12):
            theirs = rms.rmsd(positions[i], positions[j], superposition=True)
            assert found[i, j] == pytest.approx(theirs, abs=1e-6)
    mirrored = np.array([positions[0], positions[0] * [1, 1, -1]])
    assert pairwise_rmsd(mirrored)[0, 1] > 0.1  # no reflection counts as a rotation


def test_groups_that_are_far_apart_have_one_each():
    random = np.random.default_rng(2)
    places = np.concatenate([random.normal(c, 0.1, 10 + c) for c in (0, 10, 20, 30)])
    found = k_medoids(np.abs(places[:, None] - places), 4)
    assert sorted(np.round(places[found.frames], -1).tolist()) == [0, 10, 20, 30]
    sizes = np.bincount(found.owner)
    assert sizes.tolist() == [40, 30, 20, 10]
    np.testing.assert_allclose(found.distance, np.abs(places - places[found.frames[found.owner]]))


def test_no_single_change_of_a_frame_within_its_group_is_better():
    random = np.random.default_rng(3)
    points = random.standard_normal((80, 2))
    distances = np.linalg.norm(points[:, None] - points, axis=2)
    found = k_medoids(distances, 6)
    for k, medoid in enumerate(found.frames):
        group = np.flatnonzero(found.owner == k)
        best = distances[np.ix_(group, group)].sum(axis=0).min()
        assert distances[medoid, group].sum() == pytest.approx(best)
    assert found.distance.mean() < k_medoids(distances, 3).distance.mean()
    every = k_medoids(distances, 80)
    assert sorted(every.frames.tolist()) == list(range(80))
    assert every.distance.max() == 0


def test_the_models_are_the_frames_and_always_the_same(run, tmp_path):
    found = representatives(run, 5, tmp_path / "out.pdb")
    assert len(found.frames) == 5
    assert sum(found.nearest) == found.compared == 40
    assert "these frames are no independent draws: see pliant sample" in found.notes
    before = (tmp_path / "out.pdb").read_bytes()
    representatives(run, 5, tmp_path / "out.pdb", overwrite=True)
    assert (tmp_path / "out.pdb").read_bytes() == before
    written = MDAnalysis.Universe(tmp_path / "out.pdb")
    source = MDAnalysis.Universe(run, topology_format="H5MD")
    assert len(written.trajectory) == 5
    for k, number in enumerate(found.frames):
        written.trajectory[k]
        source.trajectory[number]
        assert rms.rmsd(written.atoms.positions, source.atoms.positions, superposition=True) < 2e-3
    assert b"populations are not claimed" in before


def test_residues_keep_their_insertion_codes(tmp_path):
    """As those of proteases and antibodies: 1CEQ lost its own, and no program could dock to it."""
    row = "ATOM      1  CA  GLY A  73{}   {:8.3f}   0.000   0.000  1.00  0.00           C\n"
    model = "".join(row.format(code, 3.8 * k) for k, code in enumerate(" AB "))
    model = model[: model.rfind(" A  73 ")] + model[model.rfind(" A  73 ") :].replace(" 73", " 74")
    models = "".join(f"MODEL {k:8d}\n{model}ENDMDL\n" for k in (1, 2))
    (tmp_path / "in.pdb").write_text(models + "END\n")
    representatives(tmp_path / "in.pdb", 1, tmp_path / "out.pdb", superpose="all")
    written = [
        one[22:27] for one in (tmp_path / "out.pdb").read_text().splitlines() if " CA " in one
    ]
    assert written == ["  73 ", "  73A", "  73B", "  74 "]
    labels = residue_labels(MDAnalysis.Universe(tmp_path / "out.pdb").residues)
    assert labels == ["GLY73", "GLY73A", "GLY73B", "GLY74"]


def test_convert_writes_them_in_any_format(run, tmp_path, capsys):
    assert convert.main([str(run), "-k", "5", "-o", str(tmp_path / "few.h5md")]) == 0
    assert "few.h5md: 5 frames of " in capsys.readouterr().out
    frames = representatives(run, 5).frames
    source, written = pliant.Trajectory(run), pliant.Trajectory(tmp_path / "few.h5md")
    assert len(written) == 5
    for k, number in enumerate(sorted(frames)):
        np.testing.assert_array_equal(written[k], source[number])


def test_the_report_has_them(run, tmp_path):
    report = pliant.analyse(run, tmp_path / "out", representatives=4, dpi=50)
    models = tmp_path / "out" / "representatives.pdb"
    assert report.outputs["representatives"] == str(models)
    assert len(MDAnalysis.Universe(models).trajectory) == 4
    assert "representatives.pdb" in (tmp_path / "out" / "report.html").read_text()


def test_from_python_without_a_file(run):
    found = representatives(run, 3, superpose="name CA")
    assert found.output == ""
    assert found.superposed_on == "atoms 'name CA'"
    assert found.largest_distance >= found.mean_distance > 0


def test_what_cannot_be_done(run, tmp_path):
    (tmp_path / "old.pdb").write_text("kept")
    for more, message in (
        ({"count": 41}, "representatives: expected up to 40 frames, found 41"),
        ({"count": 2, "output": tmp_path / "old.pdb"}, "exists; overwrite=True replaces it"),
        ({"count": 2, "select": "name XX"}, "--select 'name XX': selects no atoms"),
        ({}, "count, shapes: expected one of the two"),
    ):
        with pytest.raises(pliant.Error, match=message):
            representatives(run, **more)
    assert (tmp_path / "old.pdb").read_text() == "kept"
