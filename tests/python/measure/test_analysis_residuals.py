# SPDX-License-Identifier: MIT
import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis  # noqa: F401
import pytest
from pliant.trajectory.opened import one_file

from pliant.measure import BarResiduals, bar_residuals


@pytest.fixture
def run(tmp_path, pentane, wander, write_run):
    """A run of 20 frames, exact but for frame 7, whose bar 3-4 is 1 % too long."""
    trajectory = wander(pentane, [(1, 2), (2, 3)], 20)
    bar = trajectory[7, 4] - trajectory[7, 3]
    trajectory[7, 4] += 0.01 * bar
    flags = np.arange(20) != 7
    return write_run(tmp_path / "run.h5md", pentane, trajectory, converged=flags)


def test_largest_rms_and_worst_bar_are_those_of_the_broken_frame(run, pentane):
    found = BarResiduals(MDAnalysis.Universe(run)).run().results
    assert found.max_relative[7] == pytest.approx(0.01, rel=1e-9)
    assert found.rms_relative[7] == pytest.approx(0.01 / 2, rel=1e-9)  # one of four bars
    assert found.max_length[7] == pytest.approx(0.01 * pentane.rest_lengths[3], rel=1e-9)
    assert found.worst_bar[7] == 3
    assert list(np.flatnonzero(~found.within)) == [7]
    assert found.bar_max_relative[3] == pytest.approx(0.01, rel=1e-9)
    assert found.bar_max_relative[:3].max() < 1e-13


def test_double_precision_survives_far_from_the_origin(tmp_path, pentane, write_run):
    """At 1000 Angstrom MDAnalysis' 32-bit positions are off by 6e-5: useless at 1e-6."""
    path = write_run(tmp_path / "far.h5md", pentane, [pentane.positions + 1000.0])
    universe = MDAnalysis.Universe(path)
    residuals = BarResiduals(universe).run()
    assert residuals.precision == "float64"
    assert residuals.results.max_relative[0] < 1e-12
    rounded = bar_residuals(universe.atoms.positions, residuals.bars, residuals.rest_lengths)
    assert np.abs(rounded).max() > 1e-6


def test_positions_stored_single_say_so(tmp_path, pentane, write_run):
    path = write_run(tmp_path / "single.h5md", pentane, [pentane.positions], single=True)
    residuals = BarResiduals(MDAnalysis.Universe(path)).run()
    assert residuals.precision == "float32"
    assert 1e-9 < residuals.results.max_relative[0] < 1e-6


def test_nanometres_are_read_as_angstrom(tmp_path, pentane, write_run):
    path = write_run(tmp_path / "nm.h5md", pentane, [pentane.positions / 10])
    with h5py.File(path, "a") as file:
        file["particles/trajectory/position/value"].attrs["unit"] = "nm"
    assert BarResiduals(MDAnalysis.Universe(path)).run().results.max_relative[0] < 1e-14


def test_foreign_trajectories_need_bars(pentane):
    universe = MDAnalysis.Universe.empty(5, trajectory=True)
    universe.atoms.positions = pentane.positions
    with pytest.raises(ValueError, match="holds no bars with rest lengths: give them"):
        BarResiduals(universe)
    given = BarResiduals(universe, pentane.bonds, pentane.rest_lengths * 2).run()
    assert given.precision == "float32"
    assert given.results.max_relative[0] == pytest.approx(0.5, abs=1e-6)


def test_tolerances_come_from_the_run_unless_given(run):
    universe = MDAnalysis.Universe(run)
    assert BarResiduals(universe).tolerance == 1e-6
    assert BarResiduals(universe, tolerance=0.02).run().results.within.all()
    in_angstrom = BarResiduals(universe, tolerance_length=0.1)
    assert in_angstrom.run().results.within.all()
    np.testing.assert_array_equal(in_angstrom.accepted, 0.1)


def test_a_coordinate_that_is_no_number_is_not_within_tolerance(tmp_path, pentane, write_run):
    trajectory = np.array([pentane.positions] * 3)
    trajectory[1, 2, 0] = np.nan
    path = write_run(tmp_path / "nan.h5md", pentane, trajectory)
    found = BarResiduals(MDAnalysis.Universe(path)).run().results
    assert list(found.within) == [True, False, True]
    assert np.isnan(found.max_relative[1])


@pytest.mark.parametrize(
    ("bars", "lengths", "message"),
    [
        ([[0, 5]], [1.0], "expected atom indices from 0 to 4"),
        ([[0, 1]], [1.0, 2.0], r"expected shapes \(B, 2\) and \(B,\), got \(1, 2\) and \(2,\)"),
        ([[0, 1]], [0.0], "rest_lengths: expected finite numbers > 0"),
        (np.zeros((0, 2)), [], "bars: expected at least one"),
        ([[0, 1]], None, "expected both or neither"),
    ],
)
def test_bars_that_make_no_sense_are_refused(run, bars, lengths, message):
    with pytest.raises(ValueError, match=message):
        BarResiduals(MDAnalysis.Universe(run), bars, lengths)


def test_what_is_known_of_a_run(run):
    frames = one_file(run)
    assert frames.parameters["run/technique"] == "bfs_cycle"
    assert len(frames) == 20
    assert list(np.flatnonzero(~frames.converged)) == [7]
    assert frames.bars.shape == (4, 2)
    assert set(frames.observables) >= {"sweeps", "max_residual", "stop"}
