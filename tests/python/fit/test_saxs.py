# SPDX-License-Identifier: MIT
"""Frames and weights chosen by a SAXS curve: what made a curve must come out again."""

import json
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from pliant._core import PathOptions
from pliant.jobs.fit.command import main
from pliant.jobs.fit.molecule import Molecule
from pliant.jobs.fit.saxs.choice import Search
from pliant.jobs.fit.saxs.curve import Curve
from pliant.jobs.fit.saxs.profiles import Profiles, Water, Weighed, diameters, interpolation
from scipy.optimize import nnls

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"
FRAMES = 100
WATER = Water(1.01, 1.2)
Q = np.linspace(0.01, 0.35, 150)

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def profiles_of(path, frames):
    molecule = Molecule(str(path), 0, PathOptions())
    molecule.frames = np.asarray(molecule.model.positions)[None]
    if frames:
        molecule.sampled(FRAMES)
    ones = np.ones(len(Q))
    return Profiles(molecule.model.structure, molecule.frames, Curve(Q, ones, ones))


@pytest.fixture(scope="module")
def profiles():
    """Of the frames that a fit with the same seed has."""
    return profiles_of(OPEN, True)


def measured(path, intensity, noise=0.015, unit=1.0):
    """A file of a curve with a share of noise, more at large q."""
    sigma = noise * intensity * (1 + (Q / 0.15) ** 2)
    drawn = np.random.default_rng(0).standard_normal(len(Q))
    np.savetxt(path, np.stack([Q * unit, intensity + sigma * drawn, sigma], axis=1))
    return str(path)


def mixture(profiles):
    """Of a compact frame and an extended one, .35 to .65; their Rg."""
    radii = profiles.radii_of_gyration(WATER)
    order = np.argsort(radii)
    both = order[2], order[-3]
    curves = profiles.intensities(profiles.partials, WATER)
    return 0.35 * curves[both[0]] + 0.65 * curves[both[1]], radii[list(both)]


def test_a_curve_of_start_chooses_start(profiles, tmp_path):
    curve = profiles.intensities(profiles.partials[0], WATER)
    fit = pliant.fit(OPEN, saxs=measured(tmp_path / "c.dat", curve), frames=FRAMES)
    assert [one.frame for one in fit.members] == [0]
    assert fit.agrees
    assert 0.7 < fit.chi2 < 1.3
    assert "START explains the curve" in fit.verdict()
    assert fit.positions[0] == pytest.approx(np.asarray(fit.model.positions), abs=1e-6)
    assert fit.rg_curve[0] == pytest.approx(fit.rg_start, abs=4 * fit.rg_curve[1])
    assert fit.channels == pytest.approx(0.34 * 62 / np.pi, rel=0.05)


def test_two_states_come_out_with_their_weights(profiles, tmp_path):
    curve, radii = mixture(profiles)
    path = measured(tmp_path / "c.dat", 3e-4 * curve, 0.004)
    fit = pliant.fit(OPEN, saxs=path, frames=FRAMES, ensemble=True)
    assert fit.agrees
    assert len(fit) == 2
    assert fit.members[0].weight == pytest.approx(0.65, abs=0.05)
    assert fit.members[1].weight == pytest.approx(0.35, abs=0.05)
    assert [one.rg for one in fit.members] == pytest.approx(radii[::-1], abs=0.5)
    assert fit.chi2 < 1.3 < fit.chi2_single < fit.chi2_start
    assert fit.chi2_left_out[1] < fit.chi2_left_out[0]
    assert "2 frames together explain the curve" in fit.verdict()


def test_one_frame_does_not_explain_two_states(profiles, tmp_path, capsys):
    path = measured(tmp_path / "c.dat", mixture(profiles)[0], 0.004)
    out = tmp_path / "o.h5md"
    words = [str(OPEN), "--saxs", path, "-o", str(out), "--frames", str(FRAMES)]
    assert main(words) == 3
    text = capsys.readouterr().out
    assert "The curve is not explained" in text
    assert "--ensemble" in text
    assert len(pliant.Trajectory(out)) == 1


def test_the_curve_of_another_structure_is_not_that_of_start(tmp_path, capsys):
    closed = profiles_of(CLOSED, False)
    curve = closed.intensities(closed.partials[0], WATER)
    path = measured(tmp_path / "c.dat", curve + 0.02 * curve[0], unit=10)
    words = [str(OPEN), "--saxs", path, "-o", str(tmp_path / "o.pdb"), "--frames", str(FRAMES)]
    main([*words, "--background", "--json"])
    report = json.loads(capsys.readouterr().out)
    assert report["chi2_start"] > 20
    assert report["chi2"] < 0.2 * report["chi2_start"]
    assert report["frames"][0]["rmsd"] > 3
    assert len(report["curve"]["fitted"]) == len(Q)
    main([*words[:3], "-o", str(tmp_path / "p.pdb"), *words[5:], "--json"])
    assert json.loads(capsys.readouterr().out)["chi2"] > 1.2 * report["chi2"]


def test_sets_are_those_of_non_negative_least_squares():
    random = np.random.default_rng(3)
    curves = random.random((12, 30)) + np.linspace(0, 3, 30)
    goal = curves[[2, 7, 9]].T @ [0.5, 0.2, 0.3] + 0.01 * random.normal(size=30)
    for size, found in enumerate(Search(curves, goal).sets(3), 1):
        best = min(
            nnls(curves[list(some)].T, goal)[1] ** 2 for some in combinations(range(12), size)
        )
        assert goal @ goal - found.gains[0] == pytest.approx(best, rel=1e-6)
        rest = goal - found.weights[0] @ curves[found.frames[0]]
        assert rest @ rest == pytest.approx(best, rel=1e-6)
        assert (found.weights > 0).all()


def test_water_that_made_a_curve_is_found(profiles):
    intensity = 7 * profiles.intensities(profiles.partials[0], WATER) + 40
    profiles.curve = Curve(Q, intensity, 0.01 * intensity)
    weighed = Weighed(profiles, background=True)
    fit = weighed.water_of(profiles.partials[:1])
    assert fit.waters[0].expansion == pytest.approx(WATER.expansion, abs=0.002)
    assert fit.waters[0].layer == pytest.approx(WATER.layer, abs=0.05)
    assert fit.misfits[0] < 0.1


def test_curves_between_points_of_the_grid():
    grid = np.linspace(0, 0.4, 60)
    q = np.linspace(0, 0.4, 333)
    for longest in (20.0, 70.0):
        found = np.sinc(grid * longest / np.pi) @ interpolation(grid, q)
        assert np.abs(found - np.sinc(q * longest / np.pi)).max() < 3e-5


def test_diameters():
    points = np.random.default_rng(0).normal(size=(3, 200, 3))
    exact = [np.linalg.norm(x[:, None] - x, axis=2).max() for x in points]
    assert diameters(points) == pytest.approx(exact, rel=0.05)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ([], "give distances, a map, or both; or saxs"),
        (["--saxs", "a.dat", "--distances", "b.csv"], "give distances, a map, or both; or saxs"),
        (["--distances", "b.csv", "--ensemble"], "ensemble, background: are for saxs"),
        (["--saxs", "a.dat", "--keep", "2"], "keep = 2: is not for saxs"),
    ],
)
def test_options_of_the_other_kind_are_refused(tmp_path, capsys, words, expected):
    assert main([str(OPEN), *words, "-o", str(tmp_path / "o.pdb")]) == 2
    assert expected in capsys.readouterr().err


def test_an_error_of_a_file_is_one_line(tmp_path, capsys):
    path = tmp_path / "c.dat"
    path.write_text("0.01 5 0\n")
    assert main([str(OPEN), "--saxs", str(path), "-o", str(tmp_path / "o.pdb")]) == 1
    lines = [line for line in capsys.readouterr().err.splitlines() if "error:" in line]
    assert len(lines) == 1
    assert f"{path}:1: sigma: expected a number above 0, found '0'" in lines[0]


@pytest.mark.long
def test_the_same_seed_gives_the_same_bits(profiles, tmp_path):
    path = measured(tmp_path / "c.dat", mixture(profiles)[0])
    one, other = (pliant.fit(OPEN, saxs=path, frames=50, ensemble=True) for _ in range(2))
    assert np.array_equal(one.positions, other.positions)
    assert {**one.as_json(), "seconds": 0} == {**other.as_json(), "seconds": 0}
