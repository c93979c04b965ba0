# SPDX-License-Identifier: MIT
"""Datasets that expand out of proportion are refused by every reader in Python; files that are
packed well, as programs write them, are not."""

import shutil
import tracemalloc

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from expanding_files import EXPANDING, put_zeros
from pliant.trajectory.opened import one_file
from pliant.trajectory.recover.reading import read
from pliant.trajectory.universe import open_universe, source_of

VALUE = "particles/trajectory/position/value"


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    path = tmp_path_factory.mktemp("good") / "good.h5md"
    structure = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")
    pliant.run(structure, output=path, steps=3)
    return path


def all_of(path):
    """Reads all that our opener can tell."""
    frames = one_file(path)
    _ = frames.moment(0), frames.framework, frames.observables, frames.contacts


READERS = {
    "one_file": all_of,
    "open_universe": open_universe,
    "Universe": lambda path: MDAnalysis.Universe(path),
}


#: What a reader does not look at, it may leave alone.
UNREAD = {("open_universe", "bars"), ("Universe", "bars")}


@pytest.mark.parametrize(
    ("reader", "name"), [(r, n) for r in READERS for n in EXPANDING if (r, n) not in UNREAD]
)
def test_no_reader_takes_memory(good, tmp_path, reader, name):
    path = tmp_path / "bad.h5md"
    shutil.copy(good, path)
    change, dataset = EXPANDING[name]
    with h5py.File(path, "a") as file:
        change(file)
    tracemalloc.start()
    with pytest.raises((pliant.InputError, ValueError), match="that unpack to") as refused:
        READERS[reader](str(path))
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert f"/{dataset}" in str(refused.value)
    assert most < 5e7


def test_a_chunk_is_weighed_by_its_own_bytes(good, tmp_path):
    """Ten chunks of a thousandth are no better than one."""
    path = tmp_path / "bad.h5md"
    shutil.copy(good, path)
    with h5py.File(path, "a") as file:
        put_zeros(file, "observables/sweeps/value", (10 << 24,), (1 << 24,), "i8")
    with pytest.raises(pliant.InputError, match="has chunks that unpack to 134217728 bytes"):
        all_of(path)


def test_texts_that_are_one_place_in_the_file(tmp_path):
    """A hundred names of a megabyte each, of which the file has one."""
    path = tmp_path / "names.h5"
    with h5py.File(path, "w") as file:
        file.create_dataset("names", (1000,), h5py.string_dtype(), chunks=(1000,))
        file["names"][0] = "A" * 1_000_000
        stored = file["names"].id.read_direct_chunk((0,))[1]
        file["names"].id.write_direct_chunk((0,), stored[:16] * 1000)
    with (
        h5py.File(path) as file,
        pytest.raises(pliant.InputError, match="/names: has values that unpack"),
    ):
        read(file["names"])


def test_texts_of_variable_length_are_read_whole(tmp_path):
    names = [f"C{k}" for k in range(300)]
    with h5py.File(tmp_path / "names.h5", "w") as file:
        file["names"] = names
        found = read(file["names"])
        assert [name.decode() for name in found] == names
        assert found.dtype == file["names"].dtype


#: Layouts of frames that programs write: (F, N), chunk, options of h5py.
LAYOUTS = {
    "one frame a chunk, gzip": ((20, 2000), (1, 2000, 3), {"compression": "gzip"}),
    "as h5py chooses": ((20, 2000), True, {"compression": "gzip", "shuffle": True}),
    "all frames in a chunk": ((500, 2000), (500, 2000, 3), {"compression": "gzip"}),
    "a million atoms": ((1, 1_000_000), (1, 1_000_000, 3), {"compression": "gzip"}),
    "not packed": ((20, 2000), (10, 2000, 3), {}),
}


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
@pytest.mark.parametrize("still", [True, False])
def test_frames_that_are_packed_well_are_read(tmp_path, layout, still):
    """Also those in which nothing moves, all atoms on a lattice: packed a hundredfold."""
    (frames, atoms), chunk, options = layout
    positions = np.zeros((frames, atoms, 3), np.float64) + np.arange(atoms)[:, None] % 30
    if not still:
        positions += np.random.default_rng(1).normal(size=(atoms, 3)).round(2)
    path = tmp_path / "made.h5md"
    with h5py.File(path, "w") as file:
        file.create_group("h5md").attrs["version"] = [1, 1]
        file["particles/all/position/step"] = np.arange(frames)
        file["particles/all/position/time"] = np.arange(frames, dtype=float)
        file["particles/all/position/time"].attrs["unit"] = "ps"
        box = file.create_group("particles/all/box")
        box.attrs["dimension"] = 3
        box.attrs["boundary"] = ["none"] * 3
        file.create_dataset("particles/all/position/value", data=positions, chunks=chunk, **options)
        file["particles/all/position/value"].attrs["unit"] = "Angstrom"
    opened = one_file(path)
    assert (opened.positions(frames - 1) == positions[-1]).all()
    assert (source_of(open_universe(path).trajectory).positions(0) == positions[0]).all()


def test_a_file_of_mdanalysis_is_read(tmp_path):
    universe = MDAnalysis.Universe.empty(5000, trajectory=True)
    path = tmp_path / "out.h5md"
    with MDAnalysis.Writer(
        str(path), 5000, compression="gzip", timeunit="ps", lengthunit="Angstrom"
    ) as writer:
        for _ in range(3):
            writer.write(universe.atoms)
        writer.h5md_file.close()  # which it leaves open
    with pytest.warns(pliant.PliantWarning, match="steps do not increase: frame 1 has step 0"):
        assert (pliant.H5mdReader(path).positions(2) == 0).all()
    assert len(open_universe(path).trajectory) == 3
