# SPDX-License-Identifier: MIT
"""Ensembles compared residue by residue: figures beside MDAnalysis, and what is said in words."""

import gzip
import json

import MDAnalysis
import numpy as np
import pytest
from made_trajectories import Made
from MDAnalysis.analysis import pca
from MDAnalysis.analysis.align import AlignTraj, rotation_matrix
from MDAnalysis.analysis.rms import RMSF, rmsd
from pliant.measure.compared.core import core_of
from pliant.report.compare.command import main

import pliant

NAMES = "ALA ARG ASN ASP GLY LYS LEU MET SER THR VAL TRP".split()
THREE = dict(zip("ARNDGKLMSTVW", NAMES, strict=True))
SEQUENCE = "MKTAVLSGDNRWLKATVSGLMDNKRAVTSG"
COUNT = len(SEQUENCE)


def helix():
    k = np.arange(COUNT)
    return np.stack([2.3 * np.cos(1.745 * k), 2.3 * np.sin(1.745 * k), 1.5 * k], axis=1)


def motions(frames, seed, sizes, shared=None):
    """Frames along smooth random directions, which `shared` fixes, of these standard deviations."""
    rng = np.random.default_rng(seed)
    waves = np.cos(np.pi * np.outer(np.arange(12), np.arange(COUNT) + 0.5) / COUNT)[2:]
    ways = np.random.default_rng(shared or seed).normal(size=(len(sizes), len(waves), 3))
    directions = np.einsum("mwi,wk->mki", ways, waves)
    directions /= np.linalg.norm(directions, axis=(1, 2))[:, None, None] / np.sqrt(COUNT)
    amplitudes = rng.normal(size=(frames, len(sizes))) * sizes
    return helix() + np.einsum("fm,mki->fki", amplitudes, directions)


def write_ours(path, positions, sequence=SEQUENCE):
    none = np.empty((0, 2), dtype=int)
    made = Made(positions, none, np.empty(0), none, ["C"] * COUNT)
    made.names = ["CA"] * COUNT
    made.residues = [(THREE[letter], k + 1) for k, letter in enumerate(sequence)]
    return str(made.write(path))


def pdb_text(models, sequence=SEQUENCE, first=1, chain="A", kept=None):
    lines = []
    for number, positions in enumerate(models, start=1):
        lines.append(f"MODEL     {number:4d}")
        for k in range(COUNT) if kept is None else kept:
            x, y, z = positions[k]
            lines.append(
                f"ATOM  {k + 1:5d}  CA  {THREE[sequence[k]]} {chain}{k + first:4d}    "
                f"{x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           C"
            )
        lines.append("ENDMDL")
    return "\n".join([*lines, "END", ""])


SIZES = 0.4 * np.array([1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15])


@pytest.fixture
def ours(tmp_path):
    return write_ours(tmp_path / "ours.h5md", motions(80, 1, SIZES, shared=7))


@pytest.fixture
def models(tmp_path):
    path = tmp_path / "models.pdb"
    path.write_text(pdb_text(motions(60, 2, SIZES, shared=7)))
    return str(path)


def universe_of(positions):
    universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=True)
    universe.load_new(positions.astype(np.float32))
    return universe


def average(universe):
    """A universe of the average of the frames as they lie."""
    return universe_of(universe.trajectory.timeseries(order="fac").mean(axis=0)[None])


def aligned_by_mdanalysis(positions):
    """A universe of alpha carbons, superposed on their average, which is found by repeating."""
    universe = universe_of(positions)
    for _ in range(10):
        AlignTraj(universe, average(universe), in_memory=True).run()
    return universe


@pytest.fixture(scope="module")
def compared(tmp_path_factory):
    """Ours with the models."""
    folder = tmp_path_factory.mktemp("compared")
    ours = write_ours(folder / "ours.h5md", motions(80, 1, SIZES, shared=7))
    (folder / "models.pdb").write_text(pdb_text(motions(60, 2, SIZES, shared=7)))
    return pliant.compare(ours, folder / "models.pdb").residues


def test_figures_are_those_of_mdanalysis(compared):
    found = compared
    assert found.core.all() and found.ends == ""
    mine = aligned_by_mdanalysis(motions(80, 1, SIZES, shared=7))
    theirs = aligned_by_mdanalysis(np.round(motions(60, 2, SIZES, shared=7), 3))
    profiles = [RMSF(universe.atoms).run().results.rmsf for universe in (mine, theirs)]
    assert found.ours.rmsf == pytest.approx(profiles[0], abs=2e-3)
    assert found.theirs.rmsf == pytest.approx(profiles[1], abs=2e-3)
    assert found.r.value == pytest.approx(np.corrcoef(*profiles)[0, 1], abs=2e-3)
    # Ours as one body onto the average of theirs, then both PCA's.
    x, y = (average(one).atoms.positions.astype(float) for one in (mine, theirs))
    rotation = rotation_matrix(x - x.mean(axis=0), y - y.mean(axis=0))[0]
    turned = np.array([step.positions @ rotation.T for step in mine.trajectory])
    both = [pca.PCA(one).run() for one in (theirs, universe_of(turned))]
    components = [one.results.p_components[:, :10] for one in both]
    expected = pca.rmsip(components[1].T, components[0].T)
    assert found.subspaces.rmsip.value == pytest.approx(expected, abs=5e-3)
    table = np.abs(components[1].T @ components[0])
    assert found.subspaces.overlaps[:3, :3] == pytest.approx(table[:3, :3], abs=0.02)
    share = np.linalg.norm(components[1].T @ components[0], axis=0)
    assert found.subspaces.covered_theirs == pytest.approx(share, abs=0.02)


def test_the_bootstrap_error_is_the_spread_over_residues(compared):
    found = compared
    rng = np.random.default_rng(5)
    draws = rng.integers(0, COUNT, (2000, COUNT))
    values = [np.corrcoef(found.ours.rmsf[i], found.theirs.rmsf[i])[0, 1] for i in draws]
    assert found.r.error == pytest.approx(np.std(values), rel=0.2)


def test_the_first_screen_says_what_follows(ours, models, tmp_path, capsys):
    assert main([ours, models, "-o", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    first = out.split("figures, of residues")[0]
    assert "what follows" in first and "what cannot be concluded" in first
    assert "They move in the same directions: RMSIP(10) = " in first
    assert "Our amplitude was an input, not a" in " ".join(first.split())
    assert f"{models}: 30 of our 30 residues are in it" in " ".join(out.split())
    assert (tmp_path / "ours.compare-residues.png").read_bytes()[:4] == b"\x89PNG"


@pytest.mark.long
def test_json_holds_profiles_errors_and_modes(ours, models, capsys):
    assert main([ours, models, "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    residues = report["residues"]
    assert residues["kind"] == "models" and report["theirs"] == {"file": models, "frames": 60}
    assert len(residues["rmsf"]["ours"]["value"]) == COUNT
    assert len(residues["rmsf"]["theirs"]["error"]) == COUNT
    assert np.array(residues["modes"]["overlaps"]).shape == (10, 10)
    assert 0.5 < residues["modes"]["ceiling"] <= 1.0
    assert report["conclusions"] and report["modes"]["atoms"] == COUNT


def test_the_same_ensemble_lacks_nothing(ours, tmp_path):
    (tmp_path / "same.pdb").write_text(pdb_text(motions(80, 1, SIZES, shared=7)))
    found = pliant.compare(ours, tmp_path / "same.pdb").residues
    assert found.r.value == pytest.approx(1.0, abs=1e-4)
    assert found.subspaces.rmsip.value == pytest.approx(1.0, abs=1e-3)
    assert not found.more.any() and not found.less.any()
    assert found.subspaces.of_ours_alone == found.subspaces.of_theirs_alone == []
    assert found.conclusions[0].startswith("The same parts move: r = 1.00")


@pytest.mark.long
def test_what_moves_in_one_alone_is_named(tmp_path):
    rng = np.random.default_rng(3)
    mine, theirs = (helix() + rng.normal(scale=0.3, size=(n, COUNT, 3)) for n in (300, 200))
    mine[:, 9:12] += rng.normal(scale=2.0, size=(300, 1, 3))
    theirs[:, 20:23] += rng.normal(scale=2.0, size=(200, 1, 3))
    ours = write_ours(tmp_path / "ours.h5md", mine)
    (tmp_path / "theirs.pdb").write_text(pdb_text(theirs))
    found = pliant.compare(ours, tmp_path / "theirs.pdb").residues
    assert found.more_stretches[0].residues == "10-12"
    assert found.less_stretches[0].residues.startswith("21-2")
    assert "21-23" in found.subspaces.of_theirs_alone[0].residues
    assert "10-12" in found.subspaces.of_ours_alone[0].residues
    assert found.conclusions[0].startswith("It cannot be said that the same parts move: r = ")


@pytest.mark.long
def test_residues_are_matched_by_sequence_and_what_differs_is_reported(ours, tmp_path):
    other = SEQUENCE[:11] + "G" + SEQUENCE[12:]
    kept = [k for k in range(COUNT) if k not in (4, 5, 29)]
    theirs = motions(50, 2, SIZES, shared=7)
    path = tmp_path / "theirs.pdb.gz"
    path.write_bytes(gzip.compress(pdb_text(theirs, other, 101, "B", kept).encode()))
    found = pliant.compare(ours, path).residues
    assert found.notes == [
        f"{path}: 27 of our 30 residues are in it (chains - with B)",
        f"{path}: 1 residue differs, compared all the same: TRP12 is GLY112",
        f"{path}: left out, of ours alone: 5-6, 30",
    ]
    whole = tmp_path / "whole.pdb"
    whole.write_text(pdb_text(theirs))
    kept_of_whole = pliant.compare(ours, whole, select="not resid 5 6 30").residues
    assert found.theirs.rmsf == pytest.approx(kept_of_whole.theirs.rmsf, abs=1e-9)
    assert found.r.value == pytest.approx(kept_of_whole.r.value, abs=1e-9)


def test_several_files_are_one_set(ours, tmp_path):
    theirs = motions(5, 2, SIZES, shared=7)
    paths = []
    for k, positions in enumerate(theirs):
        paths.append(tmp_path / f"crystal{k}.pdb")
        kept = range(1, COUNT) if k == 2 else None
        paths[-1].write_text(pdb_text([positions], kept=kept))
    found = pliant.compare(ours, paths).residues
    assert found.kind == "structures"
    assert (found.theirs.frames, len(found.labels)) == (5, 29)
    aligned = aligned_by_mdanalysis(np.round(theirs[:, 1:], 3))
    profile = RMSF(aligned.atoms).run().results.rmsf
    assert found.theirs.rmsf == pytest.approx(profile, abs=2e-3)
    assert len(found.subspaces.theirs.vectors) == 4
    assert "of their motion lies within our first 10 modes (by chance " in found.conclusions[1]
    assert found.cautions[0].startswith("5 structures are few: ")
    assert found.cautions[-1].startswith("Which structures exist was up to those")


def test_one_structure_has_no_fluctuations(ours, tmp_path):
    path = tmp_path / "other.pdb"
    goal = motions(1, 2, SIZES, shared=7)
    path.write_text(pdb_text(goal))
    report = pliant.compare(ours, path)
    found = report.residues
    assert found.theirs is None and found.subspaces is None
    assert found.cautions == [
        "Theirs is one structure: it has no fluctuations, so r and RMSIP cannot be computed."
    ]
    mine = aligned_by_mdanalysis(motions(80, 1, SIZES, shared=7))
    middle = average(mine).atoms.positions
    distance = rmsd(np.round(goal[0], 3), middle, superposition=True)
    assert found.displacement.distance == pytest.approx(distance, abs=2e-3)
    assert 0.9 < found.displacement.overlap.value <= 1.0
    assert found.conclusions[0].startswith("Ours moves towards theirs: ")


@pytest.mark.long
@pytest.mark.parametrize(
    ("frames", "scale", "words"),
    [
        (2, 1.0, "2 models: too few for an error or a ceiling."),
        (12, 1.0, "12 models are few: their halves agree little with each other"),
        (60, 0.02, "Theirs differ by 0.0"),
    ],
)
def test_what_cannot_be_concluded_is_said(ours, tmp_path, frames, scale, words):
    theirs = helix() + scale * (motions(frames, 2, SIZES, shared=7) - helix())
    (tmp_path / "theirs.pdb").write_text(pdb_text(theirs))
    found = pliant.compare(ours, tmp_path / "theirs.pdb").residues
    assert any(line.startswith(words) for line in found.cautions)


def test_free_ends_are_no_part_of_the_fit(tmp_path):
    rng = np.random.default_rng(4)
    frames = helix() + rng.normal(scale=0.3, size=(100, COUNT, 3))
    frames[:, 26:] += rng.normal(scale=3.0, size=(100, 4, 3))
    core = core_of(frames, frames, np.array(["A"] * COUNT))
    assert np.flatnonzero(~core).tolist() == [26, 27, 28, 29]
    # A loop in the middle stays however much it moves, and so does a long end.
    frames = helix() + rng.normal(scale=0.3, size=(100, COUNT, 3))
    frames[:, 10:14] += rng.normal(scale=3.0, size=(100, 1, 3))
    assert core_of(frames, frames, np.array(["A"] * COUNT)).all()


def test_another_molecule_is_refused(ours, tmp_path, capsys):
    path = tmp_path / "other.pdb"
    path.write_text(pdb_text(motions(3, 2, SIZES), "G" * COUNT, first=500))
    assert main([ours, str(path)]) == 1
    assert capsys.readouterr().err == (
        f"pliant compare: error: {path}: only 0 of 30 residues of ours are in it, matched by "
        "sequence: is it the same molecule? pliant compare --select chooses parts of both\n"
    )


def test_a_trajectory_among_several_files_is_refused(ours, models, capsys):
    assert main([ours, models, ours]) == 1
    assert capsys.readouterr().err == (
        f"pliant compare: error: {ours}: several files are compared as a set of structures (PDB, "
        "mmCIF); expected one trajectory alone\n"
    )
