# SPDX-License-Identifier: MIT
"""GROMACS in the race: the quickest setting that meets a tolerance, and no claim beyond it."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from pliant.lab.bench import gromacs_race as race
from pliant.lab.bench.gromacs_race import Series, Tried, climb, rows_of, worth_timing
from pliant.lab.bench.target import read_target
from pliant.lab.bench.work_precision import prepare
from pliant.lab.bench.work_precision_picture import draw_on
from pliant.lab.bench.work_precision_rows import label
from pliant.lab.peers.gromacs import Program, Run, Setting, lincs_settings, programs
from real_files import CAFFEINE

PROGRAM = Program("gmx", "single", "0", "")
BARS = 25


def diagram(bars="bonds", tolerances=(1e-2, 1e-4, 1e-8)):
    return prepare(read_target(CAFFEINE, bars), bars, 0.1, 0, tolerances)


def tried(residual, seconds, timed=True, setting=None):
    """A setting that leaves a residual, with what a step took when first tried and then."""
    setting = setting or Setting("lincs", iterations=len(str(residual)))
    return Tried(setting, "", [residual], seconds, [seconds] if timed else [])


def test_a_ladder_ends_where_more_work_gains_nothing():
    leaves = iter([1e-2, 1e-4, 8e-5, 1e-9])
    climbed = list(climb(lincs_settings(4), lambda s: tried(next(leaves), 1, setting=s), 1e-8))
    assert [t.residual for t in climbed] == [1e-2, 1e-4, 8e-5]


def test_a_ladder_ends_where_all_is_met_and_where_something_failed():
    leaves = iter([1e-2, 1e-9, 1e-12])
    climbed = list(climb(lincs_settings(4), lambda s: tried(next(leaves), 1, setting=s), 1e-8))
    assert [t.residual for t in climbed] == [1e-2, 1e-9]
    assert len(list(climb(lincs_settings(4), lambda s: Tried(s, "died"), 1e-8))) == 1


def test_shake_is_asked_no_more_once_it_missed_its_tolerance():
    ladder = [Setting("shake", tolerance=10.0**-k) for k in range(2, 9)]
    floor = 4e-6

    def first(setting):
        return tried(max(setting.tolerance, floor), 1, setting=setting)

    assert [t.residual for t in climb(ladder, first, 1e-8)] == [1e-2, 1e-3, 1e-4, 1e-5, floor]


def test_what_is_quickest_to_a_tolerance_is_timed():
    slow, quick, exact, crude = tried(1e-5, 3), tried(1e-5, 1), tried(1e-9, 5), tried(1, 0.1)
    series = Series(PROGRAM, "lincs", [slow, quick, exact, crude, Tried(Setting("lincs"), "died")])
    assert worth_timing(series, (1e-4, 1e-8)) == [quick, slow, exact]


def test_a_row_has_the_quickest_that_meets_it():
    series = Series(PROGRAM, "lincs", [tried(1e-5, 3e-6), tried(2e-5, 1e-6), tried(1e-3, 5e-7)])
    loose, middle, tight = rows_of(series, diagram())
    assert (loose.outcome, middle.outcome) == ("whole", "whole")
    assert loose.ns_per_bar == pytest.approx(500 / BARS) and loose.max_residual == 1e-3
    assert middle.ns_per_bar == pytest.approx(1000 / BARS) and middle.max_residual == 2e-5
    assert tight.outcome == "not converged" and tight.max_residual == 1e-5
    assert middle.method == "gromacs_lincs_single"
    assert label(middle.method, None) == "GROMACS LINCS, single"


def test_what_falls_short_is_reported_and_asked_no_more():
    series = Series(PROGRAM, "lincs", [tried(1e-3, 1e-6)])
    rows = rows_of(series, diagram(tolerances=(1e-2, 1e-4, 1e-6)))
    assert [row.outcome for row in rows] == ["whole", "not converged", "stopped"]
    assert rows[2].note == "not converged at 1e-04" and math.isnan(rows[2].ns_per_bar)


def test_what_failed_is_reported_with_the_reason():
    series = Series(PROGRAM, "lincs", [Tried(Setting("lincs"), "Too many LINCS warnings (9)")])
    found = diagram()
    rows = rows_of(series, found)
    assert [row.outcome for row in rows] == ["failed", "stopped", "stopped"]
    assert rows[0].note == "Too many LINCS warnings (9)"
    assert "GROMACS LINCS in single precision, failed: Too many LINCS warnings (9)" in found.notes


def test_what_is_no_number_is_lost():
    series = Series(PROGRAM, "shake")
    series.tried = [Tried(Setting("shake"), "", [math.nan, 1e-3], 1e-6)]
    assert rows_of(series, diagram())[0].outcome == "not finite"


def test_frames_of_all_runs_count_and_a_failure_stays():
    target = read_target(CAFFEINE)
    one = Tried(Setting("lincs"))
    one.add(Run(frames=[target.positions, target.positions + 1.0]), target)
    one.add(Run("died"), target)
    assert len(one.residuals) == 2 and one.residual < 1e-12 and one.failure == "died"


def test_where_gromacs_is_missing_one_line_says_so(monkeypatch):
    monkeypatch.setattr(race, "programs", list)
    found = diagram()
    race.race_gromacs(found, 1)
    assert found.rows == []
    assert "GROMACS takes no part: there is neither gmx_d nor gmx on PATH" in found.notes


@pytest.fixture(scope="module")
def measured():
    if not programs():
        pytest.skip("GROMACS (gmx_d, gmx) is not installed")

    def measure(bars):
        found = diagram(bars, (1e-2, 1e-4, 1e-8))
        race.race_gromacs(found, 1, run_seconds=0.02)
        return found

    return measure


@pytest.mark.parametrize("precisions", [("double", "single"), ("single",)])
def test_the_picture_shows_the_best_precision_that_took_part(precisions):
    found = diagram()
    for precision in precisions:
        for algorithm in ("lincs", "shake"):
            program = Program("gmx", precision, "0", "")
            found.rows += rows_of(Series(program, algorithm, [tried(1e-3, 1e-6)]), found)
    axes = Figure().subplots()
    draw_on(axes, found)
    named = {text.get_text() for text in axes.get_legend().get_texts()}
    expected = {f"GROMACS {name}, {precisions[0]}" for name in ("LINCS", "SHAKE")}
    assert named == {"every other technique", *expected}


@pytest.mark.long
def test_bonds_are_whole_to_what_was_asked(measured):
    found = measured("bonds")
    assert len(found.rows) == 2 * 3 * len(found.gromacs)
    for row in found.rows:
        single = row.method.endswith("single")
        if row.tolerance >= 1e-4:
            assert row.outcome == "whole", row
        if row.outcome == "whole":
            assert 0 < row.max_residual <= 1.02 * row.tolerance
            assert 1 < row.ns_per_bar < 1e6 and row.repeats == 1 and row.note
        if row.tolerance == 1e-8:
            assert (row.outcome == "not converged") == single
    worst = [row.max_residual for row in found.rows if row.method == "gromacs_shake_single"]
    assert not worst or np.isclose(worst[0], 1e-2, rtol=0.2)  # no more than was asked for


@pytest.mark.long
def test_angles_are_beyond_lincs_and_this_is_reported(measured):
    for row in measured("angles").rows:
        assert row.outcome != "whole", row
