# SPDX-License-Identifier: MIT
"""Other shapes of an ensemble: which frames they are, what turned, which pockets opened."""

import csv
import json

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from pliant._core import PlausibleShapes, softness
from pliant.measure.domains.rigid_turns import rigid_turns
from pliant.measure.pockets.pocket_grid import find_pockets
from pliant.measure.shapes.known_pairs import KNOWN, quartiles_of_like
from pliant.measure.shapes.other_shapes import other_shapes
from pliant.measure.shapes.shapes import (
    LEAST_RMSD,
    MOST_SHAPES,
    REACH,
    find_shapes,
    stand_for_others,
)
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.measure.stages.opened import opened
from pliant.measure.stages.reference import reference_of
from pliant.report.command import main
from pliant.report.representatives import representatives
from pliant.report.sections.other_shapes import OTHER_SHAPES
from pliant.trajectory.frame_store import FrameStore
from turned_molecule import Molecule, rotated, shell

from pliant import analyse

DATA = pytest.importorskip("MDAnalysisTests.datafiles")

SITES = 60
HINGE = 36  #: the first site of the piece that turns
NEAR = 30
#: degrees -> frames of that shape
TURNED = {45.0: 5, 90.0: 4, 150.0: 2}


def two_domains():
    """CA atoms of two columns, a chain that goes round and round in each, one above the other."""
    square = 3.8 * np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    return np.concatenate([square + np.array([0.0, 0.0, 3.8 * k]) for k in range(SITES // 4)])


def turned(positions, degrees, axis=(1.0, 0.3, 0.0)):
    moved = positions.copy()
    pivot = positions[HINGE - 1 : HINGE + 1].mean(axis=0)
    moved[HINGE:] = rotated(positions[HINGE:] - pivot, axis, degrees) + pivot
    return moved


def made_frames():
    """Frames around the start, those of TURNED, one alone; which are around; which turned."""
    random, start = np.random.default_rng(1), two_domains()
    degrees = [0.0] * NEAR + [d for d, count in TURNED.items() for _ in range(count)] + [-100.0]
    frames = np.array([turned(start, d) for d in degrees])
    frames += random.normal(0.0, 0.4, frames.shape)
    for frame in frames:  # each lies somewhere else
        frame[:] = rotated(frame, random.standard_normal(3), random.uniform(0, 180)) + 5.0
    return start, frames, np.arange(len(degrees)) < NEAR, np.array(degrees)


def shapes_of(frames, start, near):
    return find_shapes(FrameStore.of(frames), start, near, PlausibleShapes(start))


def test_shapes_are_the_groups_that_were_made():
    start, frames, near, degrees = made_frames()
    found = shapes_of(frames, start, near)
    assert found.limit == LEAST_RMSD
    assert [sorted(set(degrees[own])) for own in found.members] == [[150.0], [90.0], [45.0]]
    assert [len(own) for own in found.members] == [2, 4, 5]
    assert degrees[found.alone].tolist() == [-100.0]
    for frame, own, distance in zip(
        found.representatives, found.members, found.distances, strict=True
    ):
        assert frame in own
        assert distance.max() < 1.0


def test_a_wider_cloud_around_the_start_hides_what_lies_within_it():
    start, frames, near, degrees = made_frames()
    near = near | (degrees == 90.0)
    found = shapes_of(frames, start, near)
    assert found.limit == found.rmsd[near].max()
    assert {*degrees[np.concatenate(found.members)]} <= {150.0, -100.0}
    alone = shapes_of(frames[near], start, np.ones(near.sum(), dtype=bool))
    assert len(alone.members) == len(alone.alone) == 0


def test_of_many_shapes_the_most_are_shown_and_the_others_said():
    coils = np.random.default_rng(2).normal(0.0, 3.0, (14, SITES, 3)).cumsum(axis=1)
    start, frames = two_domains(), np.repeat(coils, 2, axis=0)
    found = shapes_of(frames, start, np.zeros(len(frames), dtype=bool))
    assert 2 <= len(found.members) <= MOST_SHAPES
    assert sum(map(len, found.members)) + len(found.alone) == len(found.compared)
    assert all(distance.max() < REACH for distance in found.distances)


def test_each_next_frame_adds_most_to_how_well_all_are_stood_for():
    random = np.random.default_rng(4)
    points, scores = random.uniform(0, 30, (60, 2)), random.normal(0.0, 1.0, 60)
    distances = np.linalg.norm(points[:, None] - points, axis=2)
    chosen = stand_for_others(distances, scores, 6)
    near = np.maximum(1 - distances / REACH, 0)

    def stood_for(frames):
        return near[frames].max(axis=0, initial=0.0) @ np.exp(scores)

    for k, frame in enumerate(chosen):
        before = chosen[:k]
        free = [f for f in range(60) if (distances[before, f] >= LEAST_RMSD).all()]
        best = max(stood_for([*before, f]) for f in free)
        assert stood_for([*before, frame]) == pytest.approx(best)
    assert sorted(stand_for_others(distances, scores, 60, apart=0.0)) == list(range(60))


def superposed_rmsd(one, other):
    a, b = (points - points.mean(axis=0) for points in (one, other))
    u, s, v = np.linalg.svd(a.T @ b)
    s[2] *= np.sign(np.linalg.det(u @ v))
    return np.sqrt(max((a**2).sum() + (b**2).sum() - 2 * s.sum(), 0.0) / len(a))


def test_plausible_is_what_known_pairs_have_in_common():
    """The score by its formula; the expected distance by the line through the table of pairs."""
    start = two_domains()
    slope, at_1 = np.polyfit(*np.log(KNOWN.T), 1)
    assert (round(at_1, 2), round(slope, 2)) == (2.07, 0.56)
    found = PlausibleShapes(start)
    assert found.expected == pytest.approx(np.exp(2.07 + 0.56 * np.log(softness(start))))
    gyration = np.sqrt(start.var(axis=0).sum())
    assert found.openness == pytest.approx(np.tanh((gyration / SITES ** (1 / 3) - 2.97) / 0.15))
    frames = np.array([turned(start, degrees) for degrees in (10.0, 60.0, 120.0)])
    off = [np.log(superposed_rmsd(start, frame) / found.expected) for frame in frames]
    wider = [np.sqrt(frame.var(axis=0).sum()) / gyration - 1 for frame in frames]
    expected = [-1.6 * a * a - 20.0 * b * found.openness for a, b in zip(off, wider, strict=True)]
    np.testing.assert_allclose(found.scores(frames), expected, rtol=1e-9)
    assert np.isfinite(found.scores(start[None])).all()


@pytest.mark.parametrize("degrees", [5.0, 60.0, 150.0, 179.0])
def test_angles_hinges_and_axes_are_those_of_the_turn(degrees):
    axis = np.array([1.0, 0.3, 0.0]) / np.linalg.norm([1.0, 0.3, 0.0])
    start = two_domains()
    end = rotated(turned(start, degrees, axis), (0.3, 0.2, 0.9), 70.0)
    found = rigid_turns(start, end, np.zeros(SITES))
    assert found.piece.tolist() == [0] * HINGE + [1] * (SITES - HINGE)
    np.testing.assert_allclose(found.angles, [0.0, degrees], atol=1e-5)
    assert found.hinges.tolist() == [[HINGE - 1, HINGE]]
    assert found.within < 1e-9
    assert abs(found.axes[1] @ axis) == pytest.approx(1.0, abs=1e-9)
    np.testing.assert_allclose(found.end[:HINGE], start[:HINGE], atol=1e-9)


def test_what_bends_all_over_has_no_piece_that_turned():
    start = two_domains()
    end = start + np.random.default_rng(3).normal(0.0, 3.0, start.shape)
    found = rigid_turns(start, end, np.zeros(SITES))
    assert found.angles.tolist() == [0.0]
    assert len(found.hinges) == 0


def test_adenylate_kinase_closes_its_lid_and_its_nmp_domain():
    """Residues 118 to 160 and 30 to 59 (C. Mueller et al., Structure 4 (1996) 147)."""
    start, end = (
        MDAnalysis.Universe(file).select_atoms("name CA").positions.astype(float)
        for file in (DATA.PDB_small, DATA.PDB_closed)
    )
    found = rigid_turns(start, end, np.zeros(len(start)))
    assert len(found.angles) == 3
    lid, nmp = (np.flatnonzero(found.piece == k) + 1 for k in (1, 2))
    assert np.abs([lid[0] - 118, lid[-1] - 160]).max() <= 6
    assert abs(nmp[0] - 30) <= 3
    assert 59 <= nmp[-1] <= 73  # the helix from 61 to 72 bends
    assert 40 < found.angles[2] < found.angles[1] < 60
    assert found.within < 1.5


def pockets_of(atoms, radii):
    return find_pockets(atoms[None], radii)[0]


@pytest.mark.parametrize("radius", [5.0, 6.0, 8.0, 10.0])
def test_the_room_in_a_hollow_sphere_is_that_of_a_sphere(radius):
    atoms = shell(radius, 1500) + 0.3
    found = pockets_of(atoms, np.full(len(atoms), 1.7))
    volume = len(found.pocket) * found.volume
    assert found.pocket.max() == 0
    assert volume == pytest.approx(4 / 3 * np.pi * (radius - 1.7) ** 3, rel=0.06)


def test_neither_a_ball_nor_a_wide_bowl_has_pockets_and_two_cavities_are_two():
    ball = np.argwhere(np.ones((7, 7, 7))) * 1.5
    assert len(pockets_of(ball, np.full(len(ball), 1.7)).pocket) == 0
    atoms = shell(14.0, 2500)
    bowl = atoms[atoms[:, 2] < 0]
    assert len(pockets_of(bowl, np.full(len(bowl), 1.7)).pocket) == 0
    both = np.concatenate([shell(5.0, 800), shell(6.0, 1000) + np.array([0.0, 0.0, 12.5])])
    found = pockets_of(both, np.full(len(both), 1.7))
    assert set(found.pocket) == {0, 1}
    assert (found.atom[found.pocket == 0] >= 800).all()  # the larger comes first
    assert (found.atom[found.pocket == 1] < 800).all()


def test_softness_of_four_atoms_in_a_square():
    """Of four atoms in a square each two are neighbours, and share the other two."""
    square = 7.0 * np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.0)])
    # Springs of 2 between all: three eigenvalues 4 x 2.
    assert softness(square) == pytest.approx(1 / 8)


def test_softness_is_that_of_a_dense_matrix():
    positions = np.random.default_rng(5).normal(0.0, 9.0, (70, 3))
    apart = np.linalg.norm(positions[:, None] - positions, axis=2)
    near = ((apart < 10.0) & (apart > 0)).astype(float)
    springs = near * (near @ near)
    values = np.linalg.eigvalsh(np.diag(springs.sum(axis=1)) - springs)
    lowest = values[values > 1e-6 * values[-1]][0]
    assert softness(positions) == pytest.approx(1 / lowest, rel=1e-9)


def test_quartiles_are_of_pairs_of_like_softness():
    known = np.stack([np.arange(100.0), 2.0 * np.arange(100.0)], axis=1)[::-1]
    found = quartiles_of_like(50.2, known)
    np.testing.assert_allclose(found, np.percentile(2.0 * np.arange(43, 59), [25, 50, 75]))
    assert quartiles_of_like(-1.0, known) is None
    assert quartiles_of_like(500.0, known) is None
    inside = 0
    for soft, off in KNOWN:
        quartiles = quartiles_of_like(soft)
        inside += quartiles is not None and quartiles[0] <= off <= quartiles[2]
    assert 0.4 < inside / len(KNOWN) < 0.7


@pytest.fixture
def ensemble(tmp_path, write_run):
    """Function (how many frames around the start alone; None: all) -> path of an H5MD file."""

    def make(count=None):
        start, frames, near, _ = made_frames()
        chain = [(k, k + 1) for k in range(SITES - 1)]
        residues = [("ALA", k + 1, "A", [k]) for k in range(SITES)]
        molecule = Molecule([6] * SITES, chain, start, ["CA"] * SITES, residues)
        path = write_run(tmp_path / "e.h5md", molecule, frames[:count], bars=False)
        with h5py.File(path, "r+") as file:
            file["observables/sampler/value"] = np.where(near, 1, 3)[:count].astype(np.uint8)
            file["parameters/sample/sampler"] = "reach"
        universe = MDAnalysis.Universe(path, topology_format="H5MD")
        universe.atoms.positions = start
        universe.atoms.write(path.with_suffix(".pdb"))
        return path

    return make


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_the_report_says_which_shapes_there_are(ensemble, tmp_path, no_drawing):
    path, folder = ensemble(), tmp_path / "report"
    report = analyse(path, folder)
    found = rows_of(folder / "shapes.csv")
    assert [row["frames"] for row in found] == ["2", "4", "5"]
    assert [round(float(row["largest_turn_degrees"]), -1) for row in found] == [150, 90, 40]
    for row in found:
        first = int(row["turned"].split()[0].removeprefix("ALA"))
        assert abs(first - 37) <= 2
        assert row["turned"].endswith(f"° about ALA{first - 1}/ALA{first}")
        assert row["turned"].startswith(f"ALA{first} to ALA60 by ")
    shape = [row["shape"] for row in rows_of(folder / "frames.csv")]
    assert shape == ["0"] * NEAR + ["3"] * 5 + ["2"] * 4 + ["1"] * 2 + [""]
    values = report.as_json()
    assert len(values["shapes"][0]["turned"][0]["hinges"]) == 1
    assert values["frames_alone"] == 1
    assert values["flexibility_mean"] < 1.0  # of the frames around the start: 0.4 Å in x, y and z
    assert "no pockets of shapes: side chains are missing" in values["notes"]
    text = values["verdicts"]["other shapes"]["text"]
    assert text.startswith("3 other shapes, ")
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert "What else it could look like" in page
    assert "is not a population" in page
    chosen = representatives(path, shapes=True, output=tmp_path / "one_each.pdb")
    assert chosen.frames.tolist() == [int(row["frame"]) for row in found]
    assert (tmp_path / "one_each.pdb").read_bytes() == (folder / "shapes.pdb").read_bytes()
    assert len(MDAnalysis.Universe(folder / "shapes.pdb").trajectory) == 3


@pytest.mark.long
def test_shapes_are_drawn_one_in_a_panel(ensemble, tmp_path):
    figure = tmp_path / "report" / "shapes.png"
    analyse(ensemble(), figure.parent, dpi=50)
    assert figure.stat().st_size > 5000


def test_frames_around_the_start_alone_are_said_to_be_that(ensemble, tmp_path, capsys, no_drawing):
    path, folder = ensemble(NEAR), tmp_path / "report"
    assert main([str(path), "-o", str(folder), "--json"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert values["shapes"] == []
    assert not values["shapes_looked_for"]
    said = "No other shapes were searched for: all 30 frames were drawn around the start."
    assert values["verdicts"]["other shapes"]["text"] == said
    assert not (folder / "shapes.csv").exists()
    assert "none looked for: see --sampler reach" in (folder / "report.html").read_text()
    with pytest.raises(pliant.OptionError, match="shapes: there are no other shapes"):
        representatives(path, shapes=True)


@pytest.mark.long
def test_contacts_and_pockets_of_a_protein(tmp_path):
    """Of frames that pliant makes: contacts gone are those that the file says are not held."""
    path = tmp_path / "adk.h5md"
    with pytest.warns(pliant.PliantWarning, match="no element"):
        molecule = pliant.read(DATA.PDB_small)
    pliant.sample(molecule, 60, sampler="reach", near_frames=20, seed=1, output=path)
    analysis = opened(AnalysisOptions(str(path)))
    analysis = analysis.having(reference_of(analysis))
    for part in other_shapes(analysis):
        analysis = analysis.having(part)
    shapes = OTHER_SHAPES.values(analysis)["shapes"]
    assert len(shapes) >= 2
    with h5py.File(path) as file:
        states = file["connectivity/contact_states/value"][()]
    for shape in shapes:
        assert shape["contacts_gone"] == np.count_nonzero(states[shape["frame"]])
        for pocket in shape["pockets"]:
            assert pocket["volume"] >= pocket["volume_at_start"] + 100.0
            assert len(pocket["residues"]) > 3
    assert max(turn["degrees"] for shape in shapes for turn in shape["turned"]) > 25.0


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({}, "count, shapes: expected one of the two"),
        ({"count": 2, "shapes": True}, "count, shapes: expected one of the two"),
        ({"shapes": True, "superpose": "all"}, "superpose: goes with count, not with shapes"),
    ],
)
def test_representatives_are_of_one_kind(given, message):
    with pytest.raises(pliant.OptionError, match=f"^{message}$"):
        representatives("none.h5md", **given)
