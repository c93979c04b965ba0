# SPDX-License-Identifier: MIT
"""Files that are no trajectories of ours: what the error says, to the letter."""

import h5py
import numpy as np
import pytest
from made_trajectories import molecule_run
from pliant.trajectory.recording import read_recording

import pliant


@pytest.fixture(scope="module")
def ethane():
    return molecule_run("CC", frames=4)


@pytest.fixture
def path(ethane, tmp_path):
    return ethane.write(tmp_path / "ethane.h5md")


def test_what_is_read(ethane, path):
    recording = read_recording(path)
    assert (recording.frame_count, recording.joint_count) == (4, 8)
    assert np.array_equal(recording.bars, ethane.bars)
    assert np.array_equal(recording.rest_lengths, ethane.rest_lengths)
    assert np.array_equal(recording.masses, ethane.masses)
    assert np.array_equal(recording.positions(np.array([1, 3])), ethane.positions[[1, 3]])
    assert recording.bar_label(0) == "C1(0) - C2(1)"


def test_blocks_hold_every_frame_once(path, monkeypatch):
    monkeypatch.setattr("pliant.trajectory.recording.BLOCK_BYTES", 24 * 8 * 3)
    recording = read_recording(path)
    blocks = list(recording.blocks())
    assert [(first, len(block)) for first, block in blocks] == [(0, 3), (3, 1)]
    together = np.concatenate([block for _, block in blocks])
    assert np.array_equal(together, recording.positions(np.arange(4)))


def test_nanometres_are_converted(path):
    with h5py.File(path, "a") as file:
        file["particles/trajectory/position/value"].attrs["unit"] = "nm"
    plain = read_recording(path)
    assert plain.to_angstrom == 10.0


def test_a_frame_without_step_or_time_does_not_count(path):
    replace("particles/trajectory/position/time", np.arange(3.0))(path)
    assert read_recording(path).frame_count == 3


def remove(name):
    def change(path):
        with h5py.File(path, "a") as file:
            del file[name]

    return change


def replace(name, values):
    def change(path):
        with h5py.File(path, "a") as file:
            attributes = dict(file[name].attrs)
            del file[name]
            file[name] = values
            file[name].attrs.update({k: v for k, v in attributes.items() if k == "unit"})

    return change


def unit(text):
    def change(path):
        with h5py.File(path, "a") as file:
            file["particles/trajectory/position/value"].attrs["unit"] = text

    return change


VALUE = "particles/trajectory/position/value"
BARS = "connectivity/bars"
REST = "parameters/framework/rest_length"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (remove(VALUE), f"/{VALUE}: expected positions (F, N, 3), found nothing"),
        (
            replace(VALUE, np.zeros((4, 8))),
            f"/{VALUE}: expected positions (F, N, 3), found float64 of shape (4, 8)",
        ),
        (unit("ft"), f"/{VALUE}: expected unit Angstrom, A, nm, pm, found 'ft'"),
        (
            remove("particles/trajectory/position/step"),
            "/particles/trajectory/position/step: expected one number a frame, found nothing",
        ),
        (replace("particles/trajectory/position/step", np.empty(0, int)), "holds no frame"),
        (remove(BARS), f"/{BARS}: expected joints (B, 2), found nothing"),
        (replace(BARS, np.array([[0, 8]] * 7)), f"/{BARS}: expected joints from 0 to 7, found 8"),
        (
            replace(REST, np.ones(6)),
            f"/{REST}: expected one length for each of 7 bars, found float64 of shape (6,)",
        ),
        (
            replace(REST, np.array([1, 1, 1, 0, 1, 1, 1.0])),
            f"/{REST}: expected lengths above 0, found 0.0 for bar 3",
        ),
        (
            replace(REST, np.array([1, 1, np.nan, 1, 1, 1, 1.0])),
            f"/{REST}: expected lengths above 0, found nan for bar 2",
        ),
        (
            replace("particles/trajectory/mass", np.zeros(8)),
            "/particles/trajectory/mass: expected masses above 0, found 0.0 for joint 0",
        ),
        (
            replace("parameters/framework/pinned", np.zeros(3, bool)),
            "/parameters/framework/pinned: expected one truth value for each of 8 joints, "
            "found bool of shape (3,)",
        ),
    ],
)
def test_a_broken_file_is_named_with_its_part(path, change, message):
    change(path)
    with pytest.raises(pliant.InputError) as error:
        read_recording(path)
    said = str(error.value)
    assert said.startswith(f"{path}: ")
    assert said.removeprefix(f"{path}: ") == message


def test_no_such_file(tmp_path):
    with pytest.raises(pliant.InputError, match=r"none\.h5md: no such file"):
        read_recording(tmp_path / "none.h5md")


def test_not_hdf5(tmp_path):
    (tmp_path / "text.h5md").write_text("ATOM      1")
    with pytest.raises(pliant.InputError, match=r"text\.h5md: not an HDF5 file"):
        read_recording(tmp_path / "text.h5md")
