# SPDX-License-Identifier: MIT
"""Density maps in files, against gemmi and headers made by hand."""

import gzip
import re
import struct
from itertools import permutations, product
from pathlib import Path

import gemmi
import numpy as np
import pytest

import pliant

VALUES = np.random.default_rng(1).normal(size=(4, 5, 6)).astype(np.float32)
MODES = {0: "i1", 1: "i2", 2: "f4", 6: "u2", 12: "f2"}


def map_bytes(values, order="<", axes=(1, 2, 3), **fields):
    """A map of `values` (X, Y, Z) whose columns, rows and sections go along `axes`."""
    mode = fields.get("mode", 2)
    stored = np.transpose(values, [axis - 1 for axis in reversed(axes)])
    head = bytearray(1024)
    words = {1: stored.shape[::-1], 4: [mode], 5: fields.get("start", (0, 0, 0))}
    words |= {8: fields.get("intervals", values.shape), 17: axes, 24: [fields.get("extended", 0)]}
    for word, numbers in words.items():
        struct.pack_into(f"{order}{len(numbers)}i", head, 4 * (word - 1), *numbers)
    cell = fields.get("cell", [2.0 * n for n in values.shape])
    for word, numbers in {11: [*cell, 90, 90, 90], 50: fields.get("origin", (0, 0, 0))}.items():
        struct.pack_into(f"{order}{len(numbers)}f", head, 4 * (word - 1), *numbers)
    head[208:212] = fields.get("mark", b"MAP ")
    head[212:214] = fields.get("stamp", b"\x44\x44" if order == "<" else b"\x11\x11")
    return (
        bytes(head)
        + b"x" * fields.get("extended", 0)
        + stored.astype(order + MODES[mode]).tobytes()
    )


@pytest.fixture
def read(tmp_path):
    def read_bytes(data):
        (tmp_path / "m.mrc").write_bytes(data)
        return pliant.DensityMap.read(tmp_path / "m.mrc")

    return read_bytes


@pytest.mark.parametrize("axes", list(permutations((1, 2, 3))))
@pytest.mark.parametrize("order", "<>")
def test_axes_and_bytes_in_any_order(read, tmp_path, axes, order):
    found = read(map_bytes(VALUES, order, axes, cell=(8, 15, 24), start=(1, 2, 3)))
    assert np.array_equal(found.values, VALUES)
    assert np.allclose(found.spacing, [2, 3, 4])
    start = [(1, 2, 3)[axes.index(axis)] for axis in (1, 2, 3)]
    assert np.allclose(found.origin, np.multiply(start, [2, 3, 4]))
    # gemmi gives the whole cell, which begins at 0.
    other = gemmi.read_ccp4_map(str(tmp_path / "m.mrc"), setup=True)
    assert np.array_equal(other.grid.array, np.roll(VALUES, start, (0, 1, 2)))


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("order", "<>")
def test_all_modes(read, mode, order):
    integers = np.rint(100 * VALUES / np.abs(VALUES).max())
    values = np.abs(integers) if mode == 6 else integers if mode < 2 else VALUES
    found = read(map_bytes(values, order, mode=mode))
    expected = values.astype("f2").astype("f4") if mode == 12 else values
    assert np.array_equal(found.values, expected)


def test_small_numbers_of_16_bits(read):
    values = np.zeros((2, 2, 2), "f2")
    values.flat = [0.0, -0.0, 6e-8, -6.1e-5, 6.1e-5, 65504, -65504, 1]
    assert np.array_equal(read(map_bytes(values, mode=12)).values, values.astype("f4"))


def test_the_origin_wins_if_it_is_not_zero(read):
    found = read(map_bytes(VALUES, start=(1, 2, 3), origin=(-5, 0, 7)))
    assert np.allclose(found.origin, [-5, 0, 7])
    old = read(map_bytes(VALUES, start=(1, 2, 3), origin=(-5, 0, 7), mark=b"    "))
    assert np.allclose(old.origin, [2, 4, 6])


def test_what_is_left_out_of_a_header_is_as_usual(read):
    found = read(map_bytes(VALUES, intervals=(0, 0, 0), stamp=b"\0\0", extended=80))
    assert np.array_equal(found.values, VALUES)
    assert np.allclose(found.spacing, 2)
    assert np.array_equal(read(map_bytes(VALUES, ">", stamp=b"\0\0")).values, VALUES)


@pytest.mark.parametrize("cell", [(8, 15, 24, 90, 90, 90), (8, 15, 24, 75, 100, 115)])
def test_maps_of_gemmi(tmp_path, cell):
    grid = gemmi.FloatGrid(VALUES)
    grid.set_unit_cell(gemmi.UnitCell(*cell))
    written = gemmi.Ccp4Map()
    written.grid = grid
    written.update_ccp4_header()
    path = tmp_path / "m.ccp4"
    written.write_ccp4_map(str(path))
    path.with_suffix(".gz").write_bytes(gzip.compress(path.read_bytes()))
    for one in (path, path.with_suffix(".gz")):
        found = pliant.DensityMap.read(one)
        assert np.array_equal(found.values, VALUES)
        places = [gemmi.Fractional(i / 4, j / 5, k / 6) for i, j, k in np.ndindex(VALUES.shape)]
        expected = [grid.unit_cell.orthogonalize(place).tolist() for place in places]
        indices = np.array(list(np.ndindex(VALUES.shape)))
        assert np.allclose(found.origin + indices @ found.steps, expected, atol=1e-5)


def test_gemmi_reads_what_is_saved(tmp_path):
    saved = pliant.DensityMap(VALUES, [2, 3, 4], [-5, 0, 7])
    saved.save(tmp_path / "m.mrc")
    found = gemmi.read_ccp4_map(str(tmp_path / "m.mrc"))
    assert np.array_equal(np.array(found.grid, copy=False), VALUES)
    assert np.allclose(found.grid.unit_cell.parameters, [8, 15, 24, 90, 90, 90])
    assert [found.header_float(word) for word in (50, 51, 52)] == [-5, 0, 7]
    statistics = [found.header_float(word) for word in (20, 21, 22, 55)]
    assert np.allclose(statistics, [VALUES.min(), VALUES.max(), VALUES.mean(), VALUES.std()])
    again = pliant.DensityMap.read(tmp_path / "m.mrc")
    assert np.array_equal(again.values, VALUES)
    assert np.allclose([again.origin, again.spacing], [[-5, 0, 7], [2, 3, 4]])
    with pytest.raises(pliant.FileError, match="exists"):
        saved.save(tmp_path / "m.mrc")
    saved.save(tmp_path / "m.mrc", overwrite=True)


NAN = np.where(VALUES > 1.5, np.nan, VALUES)
GOOD = map_bytes(VALUES)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "header: expected 1024 bytes, found 0 bytes"),
        (GOOD[:-1], r"densities: expected 4 x 5 x 6 of 4 bytes from byte 1024, found 479 bytes"),
        (
            map_bytes(VALUES[:1]),
            r"sections \(words 1 to 3\): expected 2 or more of each, found 1 5",
        ),
        (struct.pack("<i", -4) + GOOD[4:], "expected 2 or more of each, found -4 5 6"),
        (struct.pack("<3i", *3 * [2**31 - 1]) + GOOD[12:], "2147483647 of 4 bytes .* cut short"),
        (GOOD[:12] + struct.pack("<i", 4) + GOOD[16:], r"mode \(word 4\): .*, found 4"),
        (map_bytes(VALUES, cell=(0, 0, 0)), r"cell \(words 11 to 13\): .* found 0 0 0"),
        (map_bytes(VALUES, cell=(8, np.nan, 8)), "found 8 nan 8"),
        (GOOD[:64] + struct.pack("<3i", 1, 2, 2) + GOOD[76:], "axes .*, found 1 2 2"),
        (GOOD[:52] + struct.pack("<3f", 10, 90, 170) + GOOD[64:], "angles of the cell"),
        (GOOD[:92] + struct.pack("<i", -1) + GOOD[96:], "extended header .*, found -1"),
        (map_bytes(VALUES, origin=(np.inf, 0, 0)), "origin .*, found inf 0 0"),
        (map_bytes(VALUES, intervals=(4, -5, 6)), "intervals .*, found 4 -5 6"),
        (map_bytes(NAN), f"densities: expected finite numbers, found {np.isnan(NAN).sum()} that"),
        (b"ATOM      1  N   ALA A   1\n" * 99, "map: "),
    ],
)
def test_what_is_no_map_is_refused_in_one_line(read, data, message):
    with pytest.raises(pliant.InputError, match=message) as refused:
        read(data)
    assert re.match(r"[^\n]+m\.mrc: map: [^\n]+$", str(refused.value))


def test_devices_and_folders_are_refused(tmp_path):
    for path in ("/dev/zero", tmp_path, tmp_path / "none.mrc"):
        with pytest.raises(pliant.FileError, match="cannot read"):
            pliant.DensityMap.read(path)


def test_maps_of_crystals_and_microscopes_are_where_others_have_them():
    gridData = pytest.importorskip("gridData")
    tests = Path(gridData.__file__).parent / "tests" / "datafiles"
    if not (tests / "1jzv.ccp4").exists():
        pytest.skip("gridDataFormats came without its test files")
    crystal = pliant.DensityMap.read(tests / "1jzv.ccp4")  # axes y, x, z; nstart
    grid = gridData.Grid(str(tests / "1jzv.ccp4"))
    assert crystal.origin == pytest.approx(grid.origin, abs=1e-5)
    assert crystal.spacing == pytest.approx(grid.delta, abs=1e-6)
    assert np.array_equal(crystal.values, grid.grid.astype(np.float32))
    density = pliant.DensityMap.read(tests / "ispg_0.mrc")
    other = gemmi.read_ccp4_map(str(tests / "ispg_0.mrc"), setup=True)
    assert np.array_equal(density.values, np.array(other.grid))
    assert density.spacing == pytest.approx(np.full(3, 3.0))


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_atoms_of_a_crystal_are_in_its_density():
    """A skew cell, the map of a part of it, and the structure (5I55), of gemmi's tests."""
    tests = Path(__file__).parents[3] / "build" / "public_files" / "gemmi" / "tests"
    if not (tests / "5i55_tiny.ccp4").exists():
        pytest.skip("no files of gemmi here: tests/support/public/fetch_public_files.sh")
    density = pliant.DensityMap.read(tests / "5i55_tiny.ccp4")
    other = gemmi.read_ccp4_map(str(tests / "5i55_tiny.ccp4"), setup=True).grid
    cell, copies = other.unit_cell, other.spacegroup.operations()
    found = {}
    for atom, place in zip(*named_places(tests / "5i55.cif"), strict=True):
        inside = cell.fractionalize(gemmi.Position(*place))
        for copy, *shift in product(copies, *[range(-3, 4)] * 3):
            there = gemmi.Fractional(*np.add(copy.apply_to_xyz(inside.tolist()), shift))
            point = cell.orthogonalize(there).tolist()
            values, _, outside = density.at(np.array([point]))
            if not outside:
                assert values[0] == pytest.approx(other.interpolate_value(gemmi.Position(*point)))
                found[atom] = values[0]
    assert set(found) == {"ASP CA", "ASP C", "ASP CB", "LEU N", "LEU CA"}
    assert min(found.values()) > density.values.mean() + density.values.std()


def named_places(path):
    structure = pliant.read(path)
    names = [f"{a} {b}" for a, b in zip(structure.residue_names, structure.names, strict=True)]
    return names, structure.positions
