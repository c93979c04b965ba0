# SPDX-License-Identifier: MIT
"""Positions that are in a temporary file: the same numbers, and the same results, as in memory."""

import errno
import os
import pickle

import MDAnalysis
import numpy as np
import pytest
from pliant.measure.flexibility import flexibility
from pliant.trajectory import frame_store
from pliant.trajectory.frame_store import FramesHeld, FrameStore, sum_of, variance_of
from pliant.trajectory.frames_reader import FramesReader
from pliant.trajectory.superposition import superpose_all, superpose_frames

from pliant import FileError
from pliant.measure import PrincipalComponents, pca

FRAMES, ATOMS = 23, 50


@pytest.fixture(params=[1, 5, 23], ids=lambda frames: f"{frames} at once")
def at_once(request, monkeypatch):
    monkeypatch.setattr(frame_store, "AT_ONCE_BYTES", request.param * ATOMS * 24)


@pytest.fixture
def positions():
    rng = np.random.default_rng(3)
    shape = rng.normal(scale=8, size=(ATOMS, 3))
    return shape + rng.normal(scale=0.4, size=(FRAMES, ATOMS, 3))


def stored(positions, dtype=np.float64):
    store = FrameStore(*positions.shape[:2], dtype, most=0)
    assert store.array is None
    store.put(0, positions[:7])
    store.put(7, positions[7:])
    return store


def test_frames_come_back(at_once, positions):
    store = stored(positions)
    assert store.shape == positions.shape
    chosen = np.array([3, 4, 5, 1, 22, 22, 0])
    assert (store.take(chosen) == positions[chosen]).all()
    assert (np.concatenate(list(store.blocks())) == positions).all()
    assert (np.concatenate(list(store.blocks(chosen))) == positions[chosen]).all()
    columns = np.concatenate(list(store.columns()), axis=1)
    assert (columns == positions.reshape(FRAMES, -1)).all()


def test_some_atoms_and_the_first_frames(at_once, positions):
    store = stored(positions, np.float32)
    atoms = np.array([4, 9, 10])
    expected = positions.astype(np.float32)
    assert (np.concatenate(list(store.of_atoms(atoms).blocks())) == expected[:, atoms]).all()
    assert (np.concatenate(list(store.of_atoms(np.arange(ATOMS)).blocks())) == expected).all()
    store.cut(4)
    assert len(store) == 4
    assert (np.concatenate(list(store.blocks())) == expected[:4]).all()
    assert (pickle.loads(pickle.dumps(store)).array == expected[:4]).all()


def test_few_positions_are_in_memory():
    assert FrameStore(2, 3).array is not None
    assert FrameStore(2, 3, most=143).array is None


def test_no_room_is_reported(positions, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    store = FrameStore(FRAMES, ATOMS, most=0)
    monkeypatch.setattr(os, "pwrite", full)
    size = FRAMES * ATOMS * 24
    expected = f"no room for {size} bytes of positions: No space left on device \\(TMPDIR names"
    with pytest.raises(FileError, match=expected):
        store.put(0, positions)


def test_sums_and_variances_are_numpy_s_to_the_last_bit(at_once, positions):
    store = stored(positions)
    assert (sum_of(store.blocks()) == positions.sum(axis=0)).all()
    assert (variance_of(store) == positions.var(axis=0)).all()
    chosen = np.arange(4, 15)
    assert (variance_of(store, chosen) == positions[chosen].var(axis=0)).all()


def test_superposition_and_flexibility_are_the_same(at_once, positions):
    store, fitted = stored(positions), np.arange(5, 40)
    superpose_frames(store, fitted)
    moved = superpose_all(positions, fitted)
    assert np.concatenate(list(store.blocks())) == pytest.approx(moved, abs=1e-12)
    units, blocks = np.arange(ATOMS) // 5, [np.arange(11), np.arange(11, FRAMES)]
    found, expected = (flexibility(frames, units, blocks) for frames in (store, moved))
    assert found.rmsf == pytest.approx(expected.rmsf, abs=1e-12)
    assert found.error == pytest.approx(expected.error, abs=1e-12)


def universe_of(positions):
    universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=True)
    universe.load_new(positions.astype(np.float32), order="fac")
    return universe


@pytest.mark.parametrize("atoms", [6, ATOMS], ids=["more frames", "more coordinates"])
def test_principal_components_are_the_same(at_once, positions, atoms, monkeypatch):
    universe = universe_of(positions[:, :atoms])
    expected = PrincipalComponents(universe.atoms).run().results
    created = FrameStore.__init__
    monkeypatch.setattr(FrameStore, "__init__", lambda *words: created(*words, most=0))
    monkeypatch.setattr(pca, "MEMORY_BYTES", 0)
    found = PrincipalComponents(universe.atoms, in_memory=False).run().results
    assert found.eigenvalues == pytest.approx(expected.eigenvalues, rel=1e-9)
    assert found.explained == pytest.approx(expected.explained, rel=1e-9)
    assert len(found.components) == pca.LEADING < len(expected.components)
    assert found.components == pytest.approx(expected.components[: pca.LEADING], abs=1e-7)
    assert found.projections == pytest.approx(expected.projections[:, : pca.LEADING], abs=1e-7)
    assert found.components @ found.components.T == pytest.approx(np.eye(pca.LEADING), abs=1e-12)


def test_a_universe_reads_a_store(at_once, positions):
    boxes = np.array([[k + 1.0, 2, 3, 90, 90, 90] for k in range(FRAMES)], dtype=np.float32)
    universe = MDAnalysis.Universe.empty(ATOMS)
    universe.trajectory = FramesReader(FramesHeld(stored(positions, np.float32), boxes))
    trajectory, expected = universe.trajectory, positions.astype(np.float32)
    assert len(trajectory) == FRAMES
    for k, step in enumerate(trajectory):
        assert (step.frame, step.dimensions[0]) == (k, k + 1)
        assert (step.positions == expected[k]).all()
    assert trajectory.ts.frame == 0  # it was rewound
    for k in (22, 3, 4, -1):
        assert (trajectory[k].positions == expected[k]).all()
    universe.atoms.translate([1, 0, 0])  # of this frame as it was read
    assert (trajectory[3].positions == expected[3]).all()
    other = trajectory.copy()
    assert (trajectory[7].frame, other.ts.frame) == (7, 3)
    assert (universe.copy().atoms.positions == expected[7]).all()
