# SPDX-License-Identifier: MIT
"""What pliant convert writes as Zarr, as xarray reads it."""

import subprocess

import h5py
import numpy as np
import pytest
from ensembles import COMMAND, PEPTIDE, made, shards_of
from pliant.adapters.convert import zarr_store

import pliant
from pliant import convert

xarray = pytest.importorskip("xarray")


def call(*words):
    """In a process that was not forked from one in which the threads of Zarr were."""
    words = [str(word) for word in (COMMAND, *words)]
    return subprocess.run(words, capture_output=True, text=True, timeout=900)


@pytest.fixture(scope="module")
def ensemble(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ensemble") / "many"
    made(PEPTIDE, "-o", folder, "--walkers", 6, "--shard-size", 4, "--steps", 40, "--every", 10)
    return folder


def test_an_ensemble_is_one_store(ensemble, tmp_path):
    store = tmp_path / "many.zarr"
    ended = call("convert", ensemble, "-o", store)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout == f"{store}: 30 frames of 327 atoms, Zarr\n"
    with xarray.open_zarr(store, consolidated=False, chunks=None) as found:
        assert found.positions.dims == ("frame", "atom", "xyz")
        assert found.positions.attrs["units"] == "Angstrom"
        assert list(found.walker.values) == [k for k in range(6) for _ in range(5)]
        assert list(found.step.values) == [0, 10, 20, 30, 40] * 6
        third = found.positions.where(found.walker == 3, drop=True).sel(xyz="y")
        alphas = found.positions.isel(atom=found.name.values == "CA")
        assert third.shape == (5, 327) and alphas.shape == (30, 20, 3)
        parts = []
        for shard in shards_of(ensemble):
            with h5py.File(shard) as file:
                parts.append(file["particles/trajectory/position/value"][:])
        assert np.allclose(found.positions.values, np.concatenate(parts), atol=1e-5)


def test_names_and_every_bit_of_a_trajectory(tmp_path, monkeypatch):
    """In chunks of two frames, of which eight are written at once."""
    monkeypatch.setattr(zarr_store, "_CHUNK_BYTES", 2 * 24 * 327)
    result = pliant.sample(PEPTIDE, frames=19, seed=3)
    convert(result, tmp_path / "s.zarr")
    structure = pliant.read(PEPTIDE)
    with xarray.open_zarr(tmp_path / "s.zarr", consolidated=False, chunks=None) as found:
        assert found.positions.values.tobytes() == result.positions.tobytes()
        assert found.positions.encoding["chunks"] == (2, 327, 3)
        assert list(found.name.values) == list(structure.names)
        assert list(found.residue.values) == list(structure.residue_ids)
        assert list(found.xyz.values) == ["x", "y", "z"]
        assert list(found.frame.values) == list(range(19))
        assert "walker" not in found.coords


def test_a_store_that_is_there_stays_unless_it_may_go(ensemble, tmp_path):
    store = tmp_path / "many.zarr"
    store.mkdir()
    (store / "mine").write_text("kept")
    ended = call("convert", ensemble, "-o", store)
    assert ended.returncode == 1 and "exists; --overwrite replaces it" in ended.stderr
    assert (store / "mine").read_text() == "kept"
    ended = call("convert", ensemble, "-o", store, "--overwrite", "--select", "name CA")
    assert ended.returncode == 0, ended.stderr
    assert not (store / "mine").exists()
    assert [path.name for path in tmp_path.iterdir()] == ["many.zarr"]
