# SPDX-License-Identifier: MIT
"""The mechanisms of data/: their degrees of freedom, and that they move as their geometry says.

Degrees of freedom come from the rank of the normalized rigidity matrix by numpy's singular values;
motions are compared with closed formulas while pliant pushes the mechanism and resolves its bars.
"""

import itertools
import re
import subprocess
import sys
from functools import cache
from math import acos, cos, pi, sin, sqrt

import expected_warnings
import numpy as np
import pytest
from real_files import MECHANISMS
from support_program import ROOT

import pliant

README = (ROOT / "data/README.md").read_text()
NAMES = sorted(path.stem for path in MECHANISMS.iterdir())
TECHNIQUES = [row.name for row in pliant.techniques() if not row.forests_only]

# joints, pinned joints, bars, rank, freedom to first order, true freedom. Those of the platforms,
# the double banana and the Bricard octahedron: PyRigi (github.com/PyRigi/PyRigi, 06cee707),
# frameworkDB.py and test_infinitesimal.py, ranks checked modulo two primes; rings of k hinged
# bodies: k - 6 if generic, so that the kaleidocycle's 1 is over-constrained; the others by counting
# a hinge as one and a slider as two.
FACTS = {
    "four_bar": (5, 2, 5, 5, 1, 1),
    "slider_crank": (8, 3, 9, 9, 1, 1),
    "peaucellier": (6, 2, 7, 7, 1, 1),
    "elliptical_trammel": (14, 4, 19, 19, 1, 1),
    "puma": (11, 2, 21, 21, 6, 6),
    "chain_7r": (15, 2, 32, 32, 7, 7),
    "stewart_gough_octahedral": (6, 0, 12, 12, 0, 0),
    "stewart_gough_6_6": (14, 0, 36, 36, 0, 0),
    "double_banana": (8, 0, 18, 17, 1, 1),
    "bricard_octahedron": (6, 0, 12, 11, 1, 1),
    "kaleidocycle": (12, 0, 30, 29, 1, 1),
}


def path_of(name):
    return MECHANISMS / f"{name}.xml"


@cache
def ids(name):
    return re.findall(r'<joint id="([^"]+)"', path_of(name).read_text())


def rank(framework, positions, skip=()):
    """Of the rows of unit length, without the columns of pinned joints and of the third axis."""
    axes = 2 if framework.is_planar else 3
    rows = np.zeros((framework.bar_count, framework.joint_count, axes))
    for k, (i, j) in enumerate(framework.bars):
        unit = (positions[j] - positions[i])[:axes] / framework.rest_lengths[k]
        rows[k, i], rows[k, j] = -unit, unit
    free = np.setdiff1d(np.arange(framework.joint_count), framework.pinned)
    kept = np.delete(rows[:, free], skip, axis=0).reshape(framework.bar_count - len(skip), -1)
    return int((np.linalg.svd(kept, compute_uv=False) > 1e-9).sum())


def freedom(framework, positions, skip=()):
    axes = 2 if framework.is_planar else 3
    free = framework.joint_count - len(framework.pinned)
    rigid = 0 if len(framework.pinned) else 6
    return axes * free - rank(framework, positions, skip) - rigid


@pytest.mark.parametrize("name", NAMES)
def test_degrees_of_freedom(name):
    graph = pliant.read_graph_xml(path_of(name))
    framework, positions = graph.framework, graph.positions
    joints, pinned, bars, its_rank, first_order, _ = FACTS[name]
    assert (framework.joint_count, len(framework.pinned)) == (joints, pinned)
    assert (framework.bar_count, framework.merged_bar_count) == (bars, 0)
    assert rank(framework, positions) == its_rank
    assert freedom(framework, positions) == first_order
    assert np.abs(relative_residuals(framework, positions)).max() < 1e-14


def test_table_of_the_readme():
    cells = r" \| (\d) \| (\d+)(?: \((\d+)\))? \| (\d+) \| (\d+) \| (\d+) \| .+ \|$"
    rows = re.findall(rf"^\| (\w+)\.xml \| .+{cells}", README, flags=re.MULTILINE)
    assert sorted(row[0] for row in rows) == sorted(FACTS) == NAMES
    for name, axes, joints, pinned, bars, stresses, free in rows:
        facts = FACTS[name]
        assert (int(joints), int(pinned or 0), int(bars)) == facts[:3]
        assert int(stresses) == facts[2] - facts[3]
        assert int(free) == facts[5] == facts[4]
        assert int(axes) == (2 if pliant.read_graph_xml(path_of(name)).framework.is_planar else 3)


def relative_residuals(framework, positions):
    i, j = framework.bars.T
    lengths = np.linalg.norm(positions[..., j, :] - positions[..., i, :], axis=-1)
    return (lengths - framework.rest_lengths) / framework.rest_lengths


class Motion:
    """Frames of a run, and joints by name."""

    def __init__(self, name, steps=500, tolerance=1e-12, seed=2, **options):
        self.names = ids(name)
        self.graph = pliant.read_graph_xml(path_of(name))
        self.framework = self.graph.framework
        frames = [self.graph.positions.copy()]
        with expected_warnings.of_fit(self.framework, options.get("technique", "auto")):
            options |= {"steps": steps, "tolerance": tolerance, "seed": seed, "max_sweeps": 200_000}
            look = [lambda frame: frames.append(frame.positions.copy())]
            self.summary = pliant.run(
                self.framework, self.graph.positions, observers=look, **options
            )
        self.frames = np.array(frames)
        assert np.abs(relative_residuals(self.framework, self.frames)).max() <= tolerance

    def of(self, name):
        """(F, 3) positions of a joint."""
        return self.frames[:, self.names.index(name)]

    def plane(self, name):
        """(F,) complex x + iy, of a linkage of the plane."""
        assert (self.of(name)[:, 2] == 0).all()
        return self.of(name)[:, 0] + 1j * self.of(name)[:, 1]

    def dihedral(self, names):
        """(F,) radians."""
        a, b, c, d = (self.of(name) for name in names)
        axis = (c - b) / np.linalg.norm(c - b, axis=1, keepdims=True)
        left, right = np.cross(b - a, axis), np.cross(axis, d - c)
        return np.unwrap(
            np.arctan2((np.cross(left, right) * axis).sum(axis=1), (left * right).sum(axis=1))
        )


@cache
def motion(name):
    # Pushes so hard that a linkage may pass a dead point: sweeps stay on their side of it.
    return Motion(name, damping=1.0, force=80.0, technique="bfs_cycle")


def test_the_output_of_peaucelliers_cell_stays_on_a_straight_line():
    output = motion("peaucellier").plane("S")
    assert np.abs(output.real - 5.0).max() < 1e-9
    assert np.ptp(output.imag) > 1.0


def test_the_tracer_of_the_trammel_stays_on_its_ellipse():
    one = motion("elliptical_trammel")
    tracer = one.plane("T")
    assert np.abs((tracer.real / 2) ** 2 + (tracer.imag / 6) ** 2 - 1).max() < 1e-9
    assert np.abs(one.plane("A").imag).max() < 1e-9
    assert np.abs(one.plane("B").real).max() < 1e-9
    assert np.ptp(np.angle(one.plane("A") - one.plane("B"))) > 0.3


def test_the_slider_stands_where_crank_and_rod_put_it():
    one = motion("slider_crank")
    crank, slider = one.plane("A"), one.plane("S")
    assert np.abs(slider - (crank.real + np.sqrt(16 - crank.imag**2))).max() < 1e-9
    assert np.ptp(slider.real) > 0.3


def test_the_four_bar_linkage_keeps_its_loop_equation():
    """Freudenstein, Trans. ASME 77 (1955) 853; and the coupler point from crank and coupler."""
    one = motion("four_bar")
    crank, rocker = one.plane("A"), one.plane("B") - 4
    a, b, c, d = 1.5, 3.5, 3.0, 4.0
    theta, psi = np.angle(crank), np.angle(rocker)
    loop = d / a * np.cos(psi) - d / c * np.cos(theta) - np.cos(theta - psi)
    assert np.abs(loop + (a**2 - b**2 + c**2 + d**2) / (2 * a * c)).max() < 1e-9
    corner = acos((2.5**2 + b**2 - 2.0**2) / (2 * 2.5 * b))
    arm = (one.plane("B") - crank) / b * 2.5 * complex(cos(corner), sin(corner))
    assert np.abs(one.plane("C") - crank - arm).max() < 1e-9
    assert np.ptp(np.unwrap(theta)) > pi


def test_the_bricard_octahedron_flexes_and_stays_symmetric():
    """A half turn changes opposite joints: the distances of the three pairs tell the shape."""
    one = motion("bricard_octahedron")
    assert np.ptp(one.dihedral(["B", "A", "C", "a"])) > 0.5
    pairs = [np.linalg.norm(one.of(x) - one.of(x.lower()), axis=1) for x in "ABC"]
    assert all(np.ptp(pair) > 0.1 for pair in pairs)
    middles = np.array([(one.of(x) + one.of(x.lower())) / 2 for x in "ABC"])
    spans = np.linalg.svd(middles.transpose(1, 0, 2) - middles.mean(axis=0)[:, None])[1]
    assert spans[:, 1].max() < 1e-6, "the middles of the pairs stay on one line"


def test_the_kaleidocycle_turns_inside_out():
    """Symmetry binds every second hinge, so that one freedom is left to six of them."""
    one = motion("kaleidocycle")
    turns = [
        one.dihedral([f"H{k}", f"H{k % 6 + 1}", f"G{k % 6 + 1}", f"H{(k + 1) % 6 + 1}"])
        for k in range(1, 7)
    ]
    assert min(np.ptp(turn) for turn in turns) > 0.3
    for first, other in itertools.product((0, 1), (2, 4)):
        assert np.abs(turns[first] - turns[first + other]).max() < 1e-9
    for k in range(1, 7):  # edges that are hinges stay at right angles to their neighbours
        one_edge, next_edge = (one.of(f"H{j}") - one.of(f"G{j}") for j in (k, k % 6 + 1))
        assert np.abs((one_edge * next_edge).sum(axis=1)).max() < 1e-9


def test_the_double_banana_turns_around_its_tips():
    one = motion("double_banana")
    assert np.abs(np.linalg.norm(one.of("N") - one.of("S"), axis=1) - 6).max() < 1e-9
    assert np.ptp(one.dihedral(["a", "N", "S", "d"])) > 1.0
    assert np.ptp(one.dihedral(["a", "N", "S", "c"])) < 1e-9


@pytest.mark.parametrize("name", ["stewart_gough_octahedral", "stewart_gough_6_6"])
def test_platforms_with_locked_legs_keep_every_distance(name):
    one = Motion(name, steps=50, damping=1.0, force=5.0)
    pairs = itertools.combinations(range(one.framework.joint_count), 2)
    for i, j in pairs:
        distance = np.linalg.norm(one.frames[:, i] - one.frames[:, j], axis=1)
        assert np.ptp(distance) < 1e-9


@pytest.mark.parametrize(("name", "hinges"), [("puma", 6), ("chain_7r", 7)])
def test_every_hinge_of_an_arm_turns(name, hinges):
    """As many independent directions of motion near the start as there are hinges."""
    one = motion(name)
    assert np.linalg.norm(np.ptp(one.of("tool"), axis=0)) > 1.0
    steps = np.array(
        [
            Motion(name, steps=1, seed=seed, force=1e-4).frames[-1] - one.frames[0]
            for seed in range(40)
        ]
    ).reshape(40, -1)
    values = np.linalg.svd(steps / np.abs(steps).max(), compute_uv=False)
    assert (values > 1e-3).sum() == hinges


def test_the_wrist_of_the_puma_is_one_point():
    one = motion("puma")
    reach = [np.linalg.norm(one.of(name) - one.of("W"), axis=1) for name in ("V", "T", "tool", "F")]
    assert max(np.ptp(distance) for distance in reach) < 1e-9
    assert np.abs(np.linalg.norm(one.of("S2") - one.of("S"), axis=1) - 1).max() < 1e-9


@pytest.mark.parametrize("technique", TECHNIQUES)
@pytest.mark.parametrize("name", NAMES)
def test_every_technique_runs_every_mechanism(name, technique):
    graph = pliant.read_graph_xml(path_of(name))
    worst, converged = [], []

    def look(frame):
        worst.append(np.abs(relative_residuals(graph.framework, frame.positions)).max())
        converged.append(frame.converged)
        assert not graph.framework.is_planar or (frame.positions[:, 2] == 0).all()
        assert (frame.positions[graph.framework.pinned] == start[graph.framework.pinned]).all()

    start = graph.positions.copy()
    with expected_warnings.of_fit(graph.framework, technique):
        options = {"technique": technique, "force": 10.0, "max_sweeps": 100_000}
        pliant.run(graph.framework, start, steps=10, observers=[look], **options)
    assert [residual <= 1e-6 for residual in worst] == converged
    assert all(converged)


def test_the_script_makes_the_files_again(tmp_path):
    subprocess.run([sys.executable, ROOT / "data/make_mechanisms.py", tmp_path], check=True)
    assert sorted(path.stem for path in tmp_path.iterdir()) == NAMES
    number = re.compile(r'"-?\d[\d.e+-]*"')
    for name in NAMES:
        new, old = ((folder / f"{name}.xml").read_text() for folder in (tmp_path, MECHANISMS))
        assert number.sub("", new) == number.sub("", old)
        both = [np.array([float(x[1:-1]) for x in number.findall(text)]) for text in (new, old)]
        assert np.abs(both[0] - both[1]).max() < 1e-14 * sqrt(len(both[0])) * 10
