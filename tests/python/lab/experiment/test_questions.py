# SPDX-License-Identifier: MIT
"""The pages of open questions: each answered in small, its numbers against closed forms."""

import numpy as np
import pytest
from pliant.lab.experiment import specimens
from pliant.lab.experiment.questions import bfs_cycle, n_cycles, root_adaptation
from pliant.lab.experiment.report import QUESTIONS
from pliant.lab.experiment.settings import label
from pliant.lab.experiment.statistics import number
from pliant.lab.experiment.sweep_matrix import closing_rate, spectral_radius, sweep_matrix
from pliant.lab.experiment.trials import (
    REPLICATES,
    Trial,
    Work,
    _replicates,
    mean_interval,
    pushed_graphs,
    ratio_interval,
    work_of,
)

import pliant

PNG = b"\x89PNG\r\n\x1a\n"


@pytest.mark.parametrize("module", QUESTIONS)
def test_a_page_answers_with_a_verdict_tables_and_figures(module, tmp_path):
    found = module.answer(tmp_path, 0, True)
    assert found.title == module.TITLE
    assert any(letter.isdigit() for letter in found.verdict)
    assert "nan" not in found.verdict.split()
    assert found.tables and found.figures
    for table in found.tables:
        assert table.rows, table.caption
        assert {len(row) for row in table.rows} == {len(table.header)}
    for figure in found.figures:
        assert figure.path.read_bytes().startswith(PNG)
        assert figure.path.is_relative_to(tmp_path)


@pytest.mark.long
def test_a_page_comes_out_the_same_twice(tmp_path):
    one, two = (n_cycles.answer(tmp_path, 3, True) for _ in range(2))
    assert one.verdict == two.verdict
    assert [table.rows for table in one.tables] == [table.rows for table in two.tables]
    assert n_cycles.answer(tmp_path, 4, True).tables[0].rows != one.tables[0].rows


def chain(bars, angle=np.pi):
    """Unit bars in a row, each turned against the last by pi - angle in a plane."""
    turns = (np.pi - angle) * np.arange(bars)
    steps = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(bars)])
    positions = np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])
    return pliant.Framework([(k, k + 1) for k in range(bars)], positions=positions), positions


@pytest.mark.parametrize("size", [3, 5, 8, 20, 50])
def test_rate_of_polygons_at_weighting_1(size):
    framework, positions = bfs_cycle.polygon(size)
    expected = np.cos(2 * np.pi / size) ** 2
    assert spectral_radius(sweep_matrix(framework, positions, 0, 1.0)) == pytest.approx(expected)
    assert closing_rate(framework, positions, 0) == pytest.approx(expected)


@pytest.mark.parametrize("weighting", [0.5, 0.75, 1.0])
@pytest.mark.parametrize("size", [5, 6, 12])
def test_rates_are_those_that_sweeps_have(size, weighting):
    framework, positions = bfs_cycle.polygon(size)
    rate = spectral_radius(sweep_matrix(framework, positions, 0, weighting))
    assert bfs_cycle.measured_rate(framework, positions, weighting) == pytest.approx(rate, rel=0.03)


def test_the_closing_bar_decides_on_random_cycles():
    compared = 0
    for trial in pushed_graphs("1-cycle-ring", 8, 3, 11):
        formula = closing_rate(trial.framework, trial.positions, trial.root)
        matrix = sweep_matrix(trial.framework, trial.positions, trial.root, 1.0)
        if formula is not None:
            compared += 1
            assert spectral_radius(matrix) == pytest.approx(formula, abs=1e-9)
    assert compared > 15


def test_a_sweep_matrix_is_one_sweep_to_first_order():
    trial = pushed_graphs("2-cycle-path", 1, 1, 5)[0]
    framework, whole = trial.framework, trial.positions
    broken = whole + 1e-6 * np.random.default_rng(1).standard_normal(whole.shape)
    before = pliant.residuals(framework, broken)
    pliant.resolve(
        framework, broken, "bfs_cycle", 0.75, tolerance=1e-15, max_sweeps=1, root=trial.root
    )
    expected = sweep_matrix(framework, whole, trial.root, 0.75) @ before
    assert np.allclose(pliant.residuals(framework, broken), expected, atol=1e-10)


def test_trials_push_one_joint_by_as_much_as_is_asked():
    trials = pushed_graphs("tree", 2, 5, 3, length=0.7)
    assert len(trials) == 10
    for trial in trials:
        moved = np.linalg.norm(trial.pushed() - trial.positions, axis=1)
        assert np.flatnonzero(moved).tolist() == [trial.root]
        assert moved[trial.root] == pytest.approx(0.7)
        assert pliant.measure_bars(trial.framework, trial.positions).within


def test_trees_take_one_sweep_of_every_bar():
    trials = pushed_graphs("tree", 3, 4, 8)
    bars = [trial.framework.bar_count for trial in trials]
    for technique, weighting in [("bfs_cycle", 1.0), ("anderson", 1.0), ("blocks", 0.5)]:
        work = work_of(trials, technique, weighting)
        assert (work.sweeps == 1).all()
        assert work.projections.tolist() == bars
        assert work.failures == 0


@pytest.mark.parametrize("technique", ["blocks", "units"])
def test_new_techniques_do_better_than_the_best_of_the_thesis(technique):
    for family, trials in root_adaptation.family_trials(6, 10, 21).items():
        new = work_of(trials, technique)
        thesis = min(
            work_of(trials, name, weighting).projections.sum()
            for name in ("random", "bfs_cycle", "dfs_cycle", "bfs_adapt", "bfs_random")
            for weighting in (0.5, 1.0)
        )
        assert new.failures == 0
        assert new.projections.sum() < 0.75 * thesis, family


def test_the_bootstrap_draws_whole_graphs():
    graphs = np.repeat([4, 7, 9], 5)
    weights = _replicates(graphs, 1)
    assert weights.shape == (REPLICATES, 15)
    assert (weights.sum(axis=1) == 15).all()
    assert (weights.reshape(-1, 3, 5).std(axis=2) == 0).all()
    one, three = (Work(graphs, k * graphs, graphs > 0, graphs) for k in (1, 3))
    mean, low, high = mean_interval(one, 1)
    assert (mean, low, high) == (pytest.approx(20 / 3), 4.0, 9.0)
    ratio, low, high = ratio_interval(three, one, 1)
    assert (ratio, low, high) == (pytest.approx(3.0),) * 3


def test_numbers_have_three_digits():
    assert [
        number(x) for x in (0.012345, 1.2345, 12.345, 123.45, 12345.6, 7.0)
    ] == "0.0123 1.23 12.3 123 12346 7".split()
    assert label(("bfs_cycle", 0.5)) == "bfs_cycle 0.5"
    assert label(("blocks", 0.5)) == "blocks"


def test_known_molecules_have_their_rings():
    pytest.importorskip("rdkit")
    rings = {"palmitic acid": 0, "toluene": 1, "spirodecane": 2, "cubane": 5}
    rings |= {"cholesterol": 4, "dodecahedrane": 11}
    for specimen in specimens.rdkit_molecules(list(rings)):
        facts = specimen.framework.graph_facts()
        assert facts.cycles == rings[specimen.name]
        assert facts.components == 1
        assert pliant.measure_bars(specimen.framework, specimen.positions).within
    assert {s.name for s in specimens.rdkit_molecules(["spirodecane"])} == {"spirodecane"}


def test_packaged_proteins_are_read_without_water():
    pytest.importorskip("MDAnalysisTests")
    found, _ = specimens.packaged_proteins()
    facts = {s.name: s.framework.graph_facts() for s in found}
    kinase = facts["adenylate kinase (4AKE)"]
    # rings by its sequence: 3 HIS, 5 PHE, 7 TYR, 10 PRO, no TRP; no disulfide bridge
    assert (kinase.joints, kinase.components, kinase.cycles) == (3341, 1, 25)
    assert kinase.blocks == 25
    assert facts["HIV-1 protease (1HVR)"].components <= 3
    # A haem with its two thioethers and the backbone between these; its iron bonds no histidine.
    assert facts["nine-haem cytochrome c (19HC)"].largest_block == 49


def test_a_trial_keeps_what_it_was_made_of():
    framework, positions = chain(3)
    trial = Trial(framework, positions, 1, np.array([0.0, 0.0, 0.5]), 0)
    moved = trial.pushed()
    assert moved[1, 2] == 0.5
    assert positions[1, 2] == 0.0
