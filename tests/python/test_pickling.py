# SPDX-License-Identifier: MIT
"""Framework, Structure and State travel to other processes, with every bit."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
from real_files import MOLECULES

import pliant

PROTOCOLS = range(2, pickle.HIGHEST_PROTOCOL + 1)


def sent(thing, protocol=pickle.HIGHEST_PROTOCOL):
    return pickle.loads(pickle.dumps(thing, protocol))


@pytest.fixture(scope="module")
def structure():
    made = pliant.read(MOLECULES / "peptide_20.pdb")
    made.perceive_bonds()
    return made


COLUMNS = tuple(
    "positions names symbols elements serials residue_of residue_ids residue_names "
    "insertion_codes chains bonds bond_orders bond_origins b_factors".split()
)


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_structure_is_the_same_there(structure, protocol):
    there = sent(structure, protocol)
    for name in COLUMNS:
        assert np.array_equal(getattr(there, name), getattr(structure, name)), name
    for name in ("title", "source", "format", "model", "model_count", "assemblies"):
        assert getattr(there, name) == getattr(structure, name)
    assert there.label(5) == structure.label(5)


def test_b_factors_and_assemblies_travel(tmp_path):
    path = tmp_path / "two.pdb"
    path.write_text(
        "REMARK 350 BIOMOLECULE: 1\n"
        "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
        "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
        "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 12.50           N\n"
        "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00 17.25           C\n"
    )
    here = pliant.read(path)
    assert here.b_factors.tolist() == [12.5, 17.25]
    assert here.assemblies == ["1"]
    there = sent(here)
    assert there.b_factors.tolist() == [12.5, 17.25]
    assert there.assemblies == ["1"]


def framework_of(structure):
    return structure.framework(bars="angles", pin="name CA and resid 3")


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_framework_is_the_same_there(structure, protocol):
    here = framework_of(structure)
    there = sent(here, protocol)
    for name in ("bars", "rest_lengths", "inverse_masses", "pinned", "limits"):
        assert np.array_equal(getattr(there, name), getattr(here, name)), name
    assert repr(there) == repr(here)
    assert there.bar_label(7) == here.bar_label(7)


def test_masses_keep_every_bit():
    masses = 10.0 ** np.random.default_rng(1).uniform(-149, 149, 20_000)
    bars = np.column_stack([np.arange(19_999), np.arange(1, 20_000)])
    here = pliant.Framework(bars, np.ones(len(bars)), masses=masses)
    assert np.array_equal(sent(here).inverse_masses, here.inverse_masses)


def test_limits_sterics_planes_and_merged_bars_are_kept(tmp_path):
    positions = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]
    here = pliant.Framework(
        [(0, 1), (1, 2), (1, 0)],
        positions=positions,
        planar=True,
        limits=[(0, 2, 1.0, np.inf, "torsion", 2.5, 1)],
        names=["a", "b", "c"],
    )
    there = sent(here)
    assert (there.is_planar, there.merged_bar_count) == (True, 1)
    assert there.limits.tolist() == here.limits.tolist()
    text = tmp_path / "bars.txt"
    text.write_text("pliant-bars 1\nbars bonds\nsterics C C 3.0\nown 0 5 1.5\n")
    butane = pliant.read(MOLECULES / "butane.sdf")
    framework = butane.framework(bars=text)
    assert sent(framework).has_sterics
    overlaps = [
        pliant.measure_bars(each, 0.5 * butane.positions).max_overlap
        for each in (framework, sent(framework))
    ]
    assert overlaps[0] == overlaps[1] > 0.9


def test_a_state_is_the_same_there():
    here = pliant.State(np.arange(6.0).reshape(2, 3))
    here.previous[0, 1], here.step, here.time = 0.1 + 0.2, 7, 0.07
    there = sent(here)
    assert np.array_equal(there.positions, here.positions)
    assert np.array_equal(there.previous, here.previous)
    assert (there.step, there.time) == (7, 0.07)
    there.positions[0, 0] = 5.0
    assert here.positions[0, 0] == 0.0
    assert copy.deepcopy(here).positions is not here.positions


def last_positions(job):
    framework, state, walker = job
    pliant.run(framework, state, steps=20, seed=3, walker=walker)
    return state.positions.copy()


def test_workers_give_the_bits_of_this_process(structure):
    framework = framework_of(structure)
    jobs = [(framework, pliant.State(structure.positions), walker) for walker in range(2)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        there = pool.map(last_positions, jobs)
    for job, positions in zip(jobs, there, strict=True):
        assert np.array_equal(last_positions(job), positions)


@pytest.mark.parametrize("state", [(), (1,), (2, 3), ("x",) * 10, (1,) + (b"abc",) * 10])
@pytest.mark.parametrize("kind", [pliant.Framework, pliant.Structure, pliant.State])
def test_what_is_no_pickle_of_ours_is_refused(kind, state):
    with pytest.raises((ValueError, TypeError)):
        kind.__new__(kind).__setstate__(state)


def test_torsion_preferences_travel(structure):
    framework = pliant.build_model(structure).framework
    here, there = framework.torsion_preferences, sent(framework).torsion_preferences
    assert here.staggered and here.backbone
    assert here.staggered == there.staggered
    assert here.backbone == there.backbone
