# SPDX-License-Identifier: MIT
"""HDF5 as the page reads and writes it, against HDF5's own library by h5py."""

import hashlib
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

h5py = pytest.importorskip("h5py")
SCRIPT = Path(__file__).resolve().parents[3] / "apps/play/test/from_python/hdf5_values.mjs"
pytestmark = pytest.mark.skipif(not shutil.which("node"), reason="node is not installed")

VERSIONS = ["earliest", "v108"]
NUMBERS = [*"i1 i2 i4 i8 u1 u2 u4 u8 f4 f8".split(), ">f8", ">i2"]
FRAMES = np.random.default_rng(1).normal(size=(37, 5, 3))
ENDLESS = {"maxshape": (None, 5, 3)}
#: How a dataset is cut.
CHUNKS = {
    "rows": {"chunks": (1, 5, 3), **ENDLESS},
    "odd": {"chunks": (4, 2, 2), **ENDLESS},
    "gzip": {"chunks": (4, 5, 3), **ENDLESS, "compression": "gzip", "shuffle": True},
    "sums": {"chunks": (4, 5, 3), "fletcher32": True, "compression": "gzip"},
    "fixed": {"chunks": (2, 3, 3)},
    "two": {"chunks": (2, 3, 3), "maxshape": (None, None, 3)},
    "two_gzip": {"chunks": (2, 3, 3), "maxshape": (None, None, 3), "compression": "gzip"},
    "single": {"chunks": FRAMES.shape},
    "single_gzip": {"chunks": FRAMES.shape, "compression": "gzip"},
}
LONG = {"endless": {"maxshape": (None,)}, "ended": {}}  # enough chunks for pages of an array


def asked(*words):
    done = subprocess.run(
        ["node", SCRIPT, *map(str, words)], capture_output=True, text=True, timeout=900
    )
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout)


def early(file, name, layout):
    """A dataset as h5py itself does not make them: of chunks that all exist, or in its header."""
    made = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    made.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
    if layout == "chunks":
        made.set_chunk((2, 3))
    else:
        made.set_layout(h5py.h5d.COMPACT)
    space = h5py.h5s.create_simple((5, 7))
    row = h5py.h5d.create(file.id, name.encode(), h5py.h5t.IEEE_F64LE, space, made)
    h5py.Dataset(row)[...] = np.arange(35.0).reshape(5, 7)


def fill(file):
    file.attrs["title"], file.attrs["list"], file.attrs["real"] = "Å", np.int32([1, 2]), 2.5
    for k in range(60):
        file[f"many/of a long name, number {k}"] = np.arange(k)
        file["many"].attrs[f"a{k}"] = k
    for kind in NUMBERS:
        file[f"types/{kind.replace('>', 'big ')}"] = np.arange(7).astype(kind)
    file["types/text"], file["types/one"] = ["a", "bcd", "Å", ""], "alone"
    file["types/fixed"] = np.array([b"ab", b"c"], dtype="S4")
    file["types/bool"], file["types/single"] = np.array([True, False]), np.int64(-3)
    file["types/none"], file["types/empty"] = np.zeros((0, 3)), h5py.Empty("f8")
    for name, options in CHUNKS.items():
        file.create_dataset(f"chunks/{name}", data=FRAMES, **options)
    for name, options in LONG.items():
        file.create_dataset(f"chunks/{name}", data=np.arange(9011), chunks=(3,), **options)
    holes = file.create_dataset(
        "chunks/holes", shape=(1000, 2), chunks=(10, 2), dtype="f8", fillvalue=np.nan
    )
    holes[500:507] = 1
    early(file, "all there", "chunks")
    early(file, "in its header", "compact")
    file["soft"], file["hard"] = h5py.SoftLink("/chunks/rows"), file["types/i4"]
    file["particles/trajectory/position/value"] = h5py.SoftLink("/chunks/rows")


@pytest.fixture(scope="module", params=VERSIONS)
def written(request, tmp_path_factory):
    name = tmp_path_factory.mktemp("hdf5") / f"{request.param}.h5"
    low = request.param
    with h5py.File(name, "w", libver="earliest" if low == "earliest" else (low, low)) as file:
        fill(file)
    return name


def plain(value):
    return value.tolist() if hasattr(value, "tolist") else value


def data_of(item):
    if item.shape is None:
        return []
    values = item[()]
    if item.dtype.kind in "OS":
        row = np.atleast_1d(values).ravel()
        return [x.decode() if isinstance(x, bytes) else x for x in row]
    kind = item.dtype if item.dtype.kind == "b" else item.dtype.newbyteorder("<")
    return hashlib.sha1(np.ascontiguousarray(values, kind).tobytes()).hexdigest()


def test_what_h5py_writes_is_read(written):
    found = asked("values", written)
    seen = []

    def compare(path, item):
        told = found[path]
        seen.append(path)
        assert {name: plain(value) for name, value in item.attrs.items()} == told["attributes"]
        if isinstance(item, h5py.Dataset):
            assert told["shape"] == (None if item.shape is None else list(item.shape)), path
            assert told["data"] == data_of(item), path
            return
        assert told["names"] == sorted(item)
        for name in item:
            compare(f"{path.rstrip('/')}/{name}", item[name])

    with h5py.File(written) as file:
        compare("/", file)
    assert len(seen) == len(found) > 90


def test_a_damaged_file_is_one_error_of_the_pages_own(written):
    told = asked("damage", written, 40)
    assert set(told) <= {"fine", "Damaged", "Outside", "NoTrajectory"}
    assert told["Damaged"] >= 20


def test_h5py_reads_what_the_page_writes(tmp_path):
    count = 4200  # more than fit into two levels of a tree
    name = tmp_path / "written.h5md"
    asked("write", name, count)
    with h5py.File(name) as file:
        value = file["particles/trajectory/position/value"]
        assert (value.chunks, value.maxshape) == ((1, 5, 3), (None, 5, 3))
        expected = np.arange(count)[:, None] + np.arange(15) / 100
        assert np.array_equal(value[()].reshape(count, 15), expected)
        assert value.attrs["unit"] == "Angstrom"
        assert [file[f"parameters/many/p{k}"][()] for k in range(300)] == list(range(-5, 295))
        assert file["parameters/run/text"].asstr()[()] == "Å, and more"
        assert file["parameters/run/none"].asstr()[()] == ""
        assert file["parameters/topology/chain"].asstr()[()].tolist() == ["A", "Å"]
    found = asked("values", name)
    assert found["/particles/trajectory/position/value"]["shape"] == [count, 5, 3]


def test_a_filter_that_the_page_has_not_is_named(tmp_path):
    name = tmp_path / "lzf.h5"
    with h5py.File(name, "w") as file:
        file.create_dataset("x", data=FRAMES, chunks=(4, 5, 3), compression="lzf")
    done = subprocess.run(["node", SCRIPT, "values", name], capture_output=True, text=True)
    assert "found chunks packed by LZF, which the page does not read" in done.stderr


def test_the_newest_format_is_named(tmp_path):
    name = tmp_path / "latest.h5"
    with h5py.File(name, "w", libver="latest") as file:
        file.create_dataset("x", data=FRAMES, chunks=(4, 5, 3))
    done = subprocess.run(["node", SCRIPT, "values", name], capture_output=True, text=True)
    assert "found chunks in the newest format of HDF5" in done.stderr
