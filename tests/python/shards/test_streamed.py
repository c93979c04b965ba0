# SPDX-License-Identifier: MIT
"""``pliant analyse DIR`` tells what one who has all frames in memory computes."""

import csv
import gc
import json
import multiprocessing
import shutil
import tracemalloc
from dataclasses import replace

import MDAnalysis
import numpy as np
import pliant.mdanalysis  # noqa: F401
import pytest
from ensembles import PEPTIDE, call, frames_of, made, shards_of
from MDAnalysis.analysis.align import rotation_matrix
from pliant.measure.shapes.medoids import k_medoids
from pliant.measure.stages.parts import Units
from pliant.report.shards.sections import flexibility_figure
from pliant.shards import over_shards
from pliant.shards.flexibility import flexibility
from pliant.shards.sums import Task, sums_of
from pliant.trajectory.shards.plan import load_plan
from pliant.trajectory.superposition import pairwise_rmsd
from real_files import CAFFEINE


@pytest.fixture(scope="module")
def many(tmp_path_factory, there):
    """64 walkers with contacts that may break."""
    folder = tmp_path_factory.mktemp("streamed") / "many"
    words = ("--walkers", 64, "--shard-size", 10, "--model", "protein", "--steps", 20)
    made(PEPTIDE, "-o", folder, *words, "--every", 4, "--perturb", "displacement", *there)
    return folder


def analysed(folder, output):
    """What pliant analyse says of an ensemble."""
    ended = call("analyse", folder, "-o", output)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def moved_by_mdanalysis(frames, reference):
    centred = reference - reference.mean(axis=0)
    moved = []
    for frame in frames:
        rotation, _ = rotation_matrix(frame - frame.mean(axis=0), centred)
        moved.append((frame - frame.mean(axis=0)) @ rotation.T + reference.mean(axis=0))
    return np.array(moved)


@pytest.fixture(scope="module")
def oracle(many):
    """All frames at once, superposed by MDAnalysis: walkers, and positions of CA."""
    trace = MDAnalysis.Universe(many / "ensemble.pliant").select_atoms("name CA").ix
    positions, _, _, walkers = frames_of(shards_of(many), names=("walker",))
    mean = moved_by_mdanalysis(positions[:, trace], positions[0, trace]).mean(axis=0)
    return walkers, moved_by_mdanalysis(positions[:, trace], mean)


@pytest.mark.parametrize("workers", [1, 2])
def test_flexibility_is_that_of_all_frames(many, oracle, workers):
    walkers, moved = oracle
    found = flexibility(many, workers)
    square = ((moved - moved.mean(axis=0)) ** 2).sum(axis=2)
    assert (found.frames, found.walkers) == (64 * 6, 64)
    assert found.rmsf == pytest.approx(np.sqrt(square.mean(axis=0)), rel=1e-9)
    of_walkers = np.array([square[walkers == w].mean(axis=0) for w in range(64)])
    error = of_walkers.std(axis=0, ddof=1) / 8 / (2 * found.rmsf)
    assert found.error == pytest.approx(error, rel=1e-7)
    for half, chosen in zip(found.halves, (walkers % 2 == 0, walkers % 2 == 1), strict=True):
        part = moved[chosen] - moved[chosen].mean(axis=0)
        assert half == pytest.approx(np.sqrt((part**2).sum(axis=2).mean(axis=0)), rel=1e-9)
    assert found.correlation == pytest.approx(np.corrcoef(*found.halves)[0, 1])


@pytest.mark.long
def test_any_number_of_processes_gives_the_same_bits(many):
    one, three = flexibility(many, 1), flexibility(many, 3)
    for name in ("rmsf", "error", "halves", "variances", "modes"):
        assert getattr(one, name).tobytes() == getattr(three, name).tobytes()
    for name, value in vars(one.clusters).items():
        assert np.array_equal(value, getattr(three.clusters, name))


def test_few_results_wait_at_once(monkeypatch):
    """The first part takes longest: what is done after it must not pile up."""

    class Now:
        def __init__(self, *words, **options):
            self.waiting = 0

        def __enter__(self):
            return self

        def __exit__(self, *what):
            pass

        def submit(self, work, task):
            self.waiting += 1
            assert self.waiting <= 3
            return self

        def result(self):
            self.waiting -= 1
            return 7

    monkeypatch.setattr(over_shards, "ProcessPoolExecutor", Now)
    assert list(over_shards.each_part(abs, list(range(20)), 2)) == 20 * [7]


def test_collective_motions_are_those_of_all_frames(many, oracle):
    _, moved = oracle
    found = flexibility(many)
    covariance = np.cov(moved.reshape(len(moved), -1).T, bias=True)
    values, vectors = np.linalg.eigh(covariance)
    assert found.variances == pytest.approx(values[::-1][:10], rel=1e-8)
    assert found.total_variance == pytest.approx(np.trace(covariance))
    assert abs((found.modes * vectors[:, ::-1][:, :10]).sum(axis=0)) == pytest.approx(np.ones(10))


def test_errors_are_what_drawing_walkers_anew_gives(many, oracle):
    walkers, moved = oracle
    square = ((moved - moved.mean(axis=0)) ** 2).sum(axis=2)
    of_walkers = np.array([square[walkers == w].mean(axis=0) for w in range(64)])
    draws = np.random.default_rng(1).integers(64, size=(4000, 64))
    spread = np.sqrt(of_walkers[draws].mean(axis=1)).std(axis=0)
    assert flexibility(many).error == pytest.approx(spread, rel=0.1)


def test_contacts_and_residuals_are_counted(many):
    names = ("contacts_held", "max_residual")
    _, _, _, held, residual = frames_of(shards_of(many), names=names)
    found = flexibility(many)
    assert sum(share for _, _, share in found.contacts) == pytest.approx(held.mean())
    assert found.max_residual == residual.max()


def test_clusters_are_those_of_all_frames(many, tmp_path):
    trace = MDAnalysis.Universe(many / "ensemble.pliant").select_atoms("name CA").ix
    positions, steps, _, walkers = frames_of(shards_of(many), names=("walker",))
    expected = k_medoids(pairwise_rmsd(positions[:, trace]), 10)
    found = flexibility(many, 2).clusters
    assert sorted(found.frames) == sorted(expected.frames)
    order = [expected.frames.tolist().index(frame) for frame in found.frames]
    shares = np.bincount(expected.owner, minlength=10) / len(positions)
    assert found.shares == pytest.approx(shares[order])
    for k, one in enumerate(order):
        own = expected.owner == one
        assert found.distances[k] == pytest.approx(expected.distance[own].mean(), abs=1e-6)
        of_walkers = np.array([own[walkers == w].mean() for w in range(64)])
        assert found.errors[k] == pytest.approx(of_walkers.std() / np.sqrt(63))
        assert found.halves[:, k] == pytest.approx(
            [of_walkers[::2].mean(), of_walkers[1::2].mean()]
        )
        assert found.positions[k].tolist() == positions[found.frames[k]].tolist()
        assert (found.records[k]["walker"], found.records[k]["step"]) == (
            walkers[found.frames[k]],
            steps[found.frames[k]],
        )


def peak_memory(tasks):
    """The most that Python held while each task was done."""
    found = []
    for task in tasks:
        gc.collect()
        tracemalloc.start()
        sums_of(task)
        found.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    return found


@pytest.mark.long
def test_memory_does_not_grow_with_frames(many):
    trace = np.arange(20)
    reference = frames_of(shards_of(many)[:1])[0][0, trace]
    plan = load_plan(many)
    tasks = [
        Task(plan, shards_of(many) * k, [None] * 7 * k, trace, reference, True) for k in (1, 8, 1)
    ]
    # In a process of its own: threads of other tests allocate here, too.
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        _, eight, one = pool.apply(peak_memory, (tasks,))
    assert eight < 1.1 * one


def test_the_command_writes_tables_and_a_figure(many, tmp_path):
    ended = call("analyse", many, "-o", tmp_path / "r", "--json")
    assert ended.returncode == 0, ended.stderr
    result = json.loads(ended.stdout)
    assert (result["walkers"], result["units"], result["unit"]) == (64, 20, "residue")
    assert sum(result["cluster_shares"]) == pytest.approx(1)
    for path in (path for paths in result["outputs"].values() for path in paths):
        assert (tmp_path / "r" / path).stat().st_size > 0
    with (tmp_path / "r" / "flexibility.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["residue"] for row in rows][:2] == ["SER1", "PRO2"]
    assert np.mean([float(row["rmsf_angstrom"]) for row in rows]) == result["flexibility_mean"]
    text = call("analyse", many / "ensemble.pliant", "-o", tmp_path / "s").stdout
    assert "64 walkers" in text
    assert "left out        torsions" in text and "clusters        10; the largest" in text
    models = MDAnalysis.Universe(tmp_path / "s" / "representatives.pdb")
    assert len(models.trajectory) == 10


def test_what_goes_with_one_file_is_refused(many, tmp_path):
    ended = call("analyse", many, "-o", tmp_path / "r", "--superpose", "name CB")
    assert (ended.returncode, ended.stderr.count("\n")) == (2, 1)
    assert "--superpose: goes with one file" in ended.stderr
    ended = call("analyse", many, "-o", tmp_path / "r", "--mass-weighted")
    assert "--mass-weighted: goes with one file" in ended.stderr


def test_one_walker_has_no_error(tmp_path, there):
    made(PEPTIDE, "-o", tmp_path / "one", "--walkers", 1, "--steps", 10, *there)
    ended = call("analyse", tmp_path / "one", "-o", tmp_path / "r")
    assert ended.returncode == 1
    assert "one walker: errors and convergence need two" in ended.stderr


def test_frames_of_a_sample_are_called_frames(tmp_path, there):
    made(PEPTIDE, "-o", tmp_path / "drawn", "--frames", 12, "--shard-size", 5, *there)
    text = analysed(tmp_path / "drawn", tmp_path / "r")
    assert "frames          12, independent of each other\n" in text
    written = [path.read_text() for path in (tmp_path / "r").glob("*.csv")]
    assert not any("walker" in one for one in (text, *written))
    rows = read_csv(tmp_path / "r" / "clusters.csv")
    assert {"step", "share_even_frames", "share_odd_frames"} < set(rows[0])
    found = flexibility(tmp_path / "drawn")
    legend = flexibility_figure(found).axes[0].get_legend().get_texts()
    assert [text.get_text() for text in legend][:2] == ["all 12 frames", "even-numbered frames"]


@pytest.mark.parametrize("asks", [True, False])
def test_an_amplitude_that_was_asked_for_is_no_result(tmp_path, asks, there):
    """Conformers of a small molecule are asked for none."""
    words = (PEPTIDE, "--amplitude", 0.9) if asks else (CAFFEINE.with_name("aspirin.sdf"),)
    made(*words, "-o", tmp_path / "s", "--frames", 12, "--shard-size", 6, *there)
    text = analysed(tmp_path / "s", tmp_path / "r")
    said = (
        "amplitude       asked 0.90 Angstrom: how far all moves is an input, which parts move more "
        "than others is a result\n"
    )
    assert (said in text) == ("\namplitude" in text) == asks


def test_of_a_rigid_molecule_it_says_that_nothing_moves(tmp_path, there):
    made(CAFFEINE, "-o", tmp_path / "rigid", "--frames", 20, "--shard-size", 10, *there)
    text = analysed(tmp_path / "rigid", tmp_path / "r")
    assert "nothing moves: RMSF of all 14 atoms is below 0.001 Angstrom" in text
    assert "clusters        1: all frames have one shape\n" in text
    assert "nan" not in text and "halves" not in text and "modes " not in text
    assert len(read_csv(tmp_path / "r" / "clusters.csv")) == 1
    assert not (tmp_path / "r" / "modes.csv").exists()


def labels_of(figure):
    axes = figure.axes[0]
    return [label.get_text() for label in axes.get_xticklabels()], axes.get_xlabel()


def test_the_figure_has_the_numbers_of_residues(many):
    found = flexibility(many)
    labels, axis = labels_of(flexibility_figure(found))
    assert (labels[0], labels[-1], len(labels), axis) == ("SER1", "GLY20", 20, "residue")
    numbers = np.arange(24, 84)
    places = np.arange(60)
    names, chains = [f"ALA{n}" for n in numbers], np.full(60, "")
    units = Units("residue", names, numbers, chains, places, places, places, places >= 0)
    values = np.linspace(0.1, 1, 60)
    longer = replace(
        found, units=units, rmsf=values, error=values / 9, halves=np.array(2 * [values])
    )
    axes = flexibility_figure(longer).axes[0]
    labels, axis = labels_of(flexibility_figure(longer))
    assert (labels, axis) == (["30", "40", "50", "60", "70", "80"], "residue number")
    assert axes.get_xticks().tolist() == [6, 16, 26, 36, 46, 56]


@pytest.mark.parametrize("lost", ["one", "all"])
def test_a_shard_that_is_gone_is_named(many, tmp_path, lost):
    folder = shutil.copytree(many, tmp_path / "many")
    first, *_ = shards_of(folder)
    if lost == "one":
        first.unlink()
    else:
        shutil.rmtree(folder / "shards")
    ended = call("analyse", folder, "-o", tmp_path / "r")
    assert ended.returncode == 1
    others = "; so are 6 others" if lost == "all" else ""
    assert ended.stderr == (
        f"pliant analyse: error: {first}: is gone: the same pliant ensemble command makes it "
        f"again{others}\n"
    )


def test_shards_that_are_not_counted_are_reported_from_none(many, tmp_path):
    folder = shutil.copytree(many, tmp_path / "many")
    (folder / "shards.jsonl").unlink()
    ended = call("analyse", folder)
    assert "no shard is counted yet: run the command of the ensemble once more" in ended.stderr
    shutil.rmtree(folder / "shards")
    assert "none of its 7 shards is complete yet" in call("analyse", folder).stderr
