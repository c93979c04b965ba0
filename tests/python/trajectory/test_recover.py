# SPDX-License-Identifier: MIT
"""pliant convert --recover: what it saves was recorded, and what it cannot save it names."""

import json
import os

import h5py
import numpy as np
import pytest
from h5md_contents import positions_in
from pliant.adapters.convert.command import main
from pliant.trajectory.opened import one_file
from pliant.trajectory.recover.recover import recover

import pliant

WATER = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"
VALUE = "particles/trajectory/position/value"


@pytest.fixture
def good(tmp_path):
    path = tmp_path / "good.h5md"
    pliant.run(pliant.read_text(WATER, "water.xyz"), output=path, steps=599)
    return path


def test_a_whole_file_stays_what_it_is(good, tmp_path, capsys):
    out = tmp_path / "out.h5md"
    assert main([str(good), "-o", str(out), "--recover"]) == 0
    assert capsys.readouterr().out.endswith("nothing was lost\n")
    assert np.array_equal(positions_in(out), positions_in(good))
    ours, theirs = pliant.H5mdReader(out), pliant.H5mdReader(good)
    assert ours.parameters() == theirs.parameters()
    assert ours.observables == theirs.observables
    for name in ours.observables:
        assert np.array_equal(ours.observable(name), theirs.observable(name))
    assert ours.structure().names.tolist() == theirs.structure().names.tolist()
    assert ours.structure().bonds.tolist() == theirs.structure().bonds.tolist()
    assert ours.framework().rest_lengths.tolist() == theirs.framework().rest_lengths.tolist()
    assert len(one_file(out)) == 600


def test_a_file_cut_short_keeps_its_first_frames(good, tmp_path, capsys):
    cut, out = tmp_path / "cut.h5md", tmp_path / "out.h5md"
    whole = good.read_bytes()
    with h5py.File(good) as file:  # the third block of frames begins where the file will end
        end = file[VALUE].id.get_chunk_info(2).byte_offset + 1000
    cut.write_bytes(whole[:end])
    with pytest.raises(pliant.InputError, match=r"cut.h5md: is damaged: .* truncated file"):
        pliant.H5mdReader(cut)
    assert main([str(cut), "-o", str(out), "--recover"]) == 0
    said = capsys.readouterr().out
    assert f"lost: superblock: states {len(whole)} bytes, the file has {end}\n" in said
    kept = positions_in(out)
    assert 0 < len(kept) < 600
    assert np.array_equal(kept, positions_in(good)[pliant_steps(out)])


def pliant_steps(path):
    reader = pliant.H5mdReader(path)
    return [reader.step(k) for k in range(len(reader))]


def test_frames_around_a_hole_are_saved(good, tmp_path, capsys):
    out = tmp_path / "out.h5md"
    before = positions_in(good)
    with h5py.File(good, "r+") as file:
        file[VALUE][300, 1] = np.nan
    assert main([str(good), "-o", str(out), "--json", "--recover"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["lost"] == {"frame 300": "has coordinates that are not finite"}
    assert (report["frames"], report["frames_stated"]) == (599, 600)
    assert np.array_equal(positions_in(out), np.delete(before, 300, axis=0))
    assert pliant.H5mdReader(out).observable("sweeps").shape == (599,)


def test_lost_names_leave_the_frames(good, tmp_path):
    out = tmp_path / "out.h5md"
    before = positions_in(good)
    with h5py.File(good) as file:
        at = h5py.h5o.get_info(file["parameters/topology/atom_name"].id).addr
    with open(good, "r+b") as file:
        file.seek(at)
        file.write(b"\xff" * 64)
    found = recover(good, out)
    assert "parameters/topology/atom_name" in found.lost
    assert np.array_equal(positions_in(out), before)


def test_a_broken_superblock_is_mended(good, tmp_path):
    out = tmp_path / "out.h5md"
    before = positions_in(good)
    with open(good, "r+b") as file:
        file.seek(2)
        file.write(b"xyz")
    assert recover(good, out).lost == {"superblock": "had wrong bytes"}
    assert np.array_equal(positions_in(out), before)


@pytest.mark.parametrize("content", [b"", b"ATOM      1  N   ALA A   1", bytes(5000)])
def test_nothing_to_save_makes_no_file(tmp_path, content, capsys):
    path, out = tmp_path / "no.h5md", tmp_path / "out.h5md"
    path.write_bytes(content)
    assert main([str(path), "-o", str(out), "--recover"]) == 1
    wanted = f"pliant convert: error: {path}: no frame can be read"
    assert capsys.readouterr().err.startswith(wanted)
    assert not out.exists()


def test_files_are_not_replaced_unasked(good, tmp_path, capsys):
    out = tmp_path / "out.h5md"
    out.write_text("mine")
    assert main([str(good), "-o", str(out), "--recover"]) == 1
    assert capsys.readouterr().err.endswith(f"{out}: exists; --overwrite replaces it\n")
    assert main([str(good), "-o", str(good), "--overwrite", "--recover"]) == 2
    assert capsys.readouterr().err.endswith("is both input and output\n")
    assert out.read_text() == "mine"
    before = good.read_bytes()
    assert main([str(good), "-o", str(out), "--overwrite", "--recover"]) == 0
    assert good.read_bytes() == before
    assert sorted(os.listdir(tmp_path)) == ["good.h5md", "out.h5md"]
