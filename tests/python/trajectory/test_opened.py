# SPDX-License-Identifier: MIT
"""What is read of an H5MD file, and what is said of one that is none, whoever opens it."""

import pickle
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_trajectories import molecule_run
from pliant.report.check.command import main as check
from pliant.report.command import main as analyse
from pliant.report.compare.command import main as compare
from pliant.trajectory.opened import one_file

import pliant

PEPTIDE = Path(__file__).parents[3] / "data" / "molecules" / "peptide_20.pdb"


@pytest.fixture(scope="module")
def ethane():
    return molecule_run("CC", frames=4)


@pytest.fixture
def path(ethane, tmp_path):
    return ethane.write(tmp_path / "ethane.h5md")


def test_what_is_read(ethane, path):
    frames = one_file(path)
    assert (len(frames), frames.atom_count) == (4, 8)
    assert np.array_equal(frames.bars, ethane.bars)
    assert np.array_equal(frames.rest_lengths, ethane.rest_lengths)
    assert np.array_equal(frames.masses, ethane.masses)
    assert np.array_equal(frames.read(np.array([1, 3])), ethane.positions[[1, 3]])
    assert frames.bar_label(0) == "C1(0) - C2(1)"


def test_frames_are_read_once_each_in_any_runs(ethane, path):
    frames = one_file(path)
    for chosen in ([0, 1, 2, 3], [0, 2, 3], [3], []):
        assert np.array_equal(frames.read(np.array(chosen, dtype=int)), ethane.positions[chosen])


def test_another_process_opens_the_file_anew(path):
    frames = one_file(path)
    other = pickle.loads(pickle.dumps(frames))
    assert np.array_equal(other.positions(2), frames.positions(2))


def test_nanometres_are_converted(path):
    before = one_file(path).positions(1)
    with h5py.File(path, "a") as file:
        file["particles/trajectory/position/value"].attrs["unit"] = "nm"
    assert np.array_equal(one_file(path).positions(1), 10.0 * before)


def test_a_frame_without_step_or_time_does_not_count(path):
    replace("particles/trajectory/position/time", np.arange(3.0))(path)
    assert (len(one_file(path)), one_file(path).frames_left_out) == (3, 1)


def test_numbers_keep_their_kind(path):
    with h5py.File(path, "a") as file:
        for name, values in {"whole": [1, 2, 3, 4], "truth": [True] * 4, "real": [0.5] * 4}.items():
            file[f"observables/{name}/value"] = values
        file["observables/short/value"] = [1, 2]
    found = one_file(path).observables
    assert [found[name].dtype.kind for name in ("whole", "truth", "real")] == ["i", "b", "f"]
    assert "short" not in found


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
        (remove(VALUE), f"no positions: /{VALUE} is missing"),
        (
            replace(VALUE, np.zeros((4, 8))),
            f"/{VALUE} has shape (4, 8); expected (frames, joints, 3)",
        ),
        (
            unit("ft"),
            f'/{VALUE} has the unit "ft"; known: Angstrom, angstrom, A, nm, pm, fm, um, m',
        ),
        (replace("particles/trajectory/position/step", np.empty(0, int)), "holds no frame"),
        (
            remove("particles"),
            "no group with positions in /particles; groups of the file: "
            '"connectivity", "observables", "parameters"; of /particles: none',
        ),
    ],
)
def test_who_opens_a_broken_file_hears_of_its_part(path, tmp_path, change, message, capsys):
    change(path)
    with pytest.raises(pliant.InputError) as error:
        one_file(path)
    assert str(error.value) == f"{path}: {message}"
    for main, name in ((analyse, "analyse"), (check, "check"), (compare, "compare")):
        words = [path, PEPTIDE] if main is compare else [path]
        assert main(list(map(str, words))) == 1
        said = capsys.readouterr().err.splitlines()
        assert said[-1] == f"pliant {name}: error: {path}: {message}"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (remove(BARS), f"no bars with rest lengths: /{BARS} or /{REST} is missing"),
        (replace(BARS, np.array([[0, 8]] * 7)), f"/{BARS}: value 1 is 8; expected 0 to 7"),
        (replace(REST, np.ones(6)), f"/{REST} has 6 values; expected 7"),
        (
            replace(REST, np.array([1, 1, 1, 0, 1, 1, 1.0])),
            "bar C1(1) - H5(5) has rest length 0: must be from 1e-150 to 1e150 Angstrom",
        ),
        (
            replace(REST, np.array([1, 1, np.nan, 1, 1, 1, 1.0])),
            "bar C1(1) - H4(4) has rest length nan: must be from 1e-150 to 1e150 Angstrom",
        ),
        (
            replace("particles/trajectory/mass", np.zeros(8)),
            "mass of C1(1) is 0: must be from 1e-150 to 1e150 u",
        ),
        (
            replace("parameters/framework/pinned", np.zeros(3, bool)),
            "/parameters/framework/pinned has 3 values; expected 8",
        ),
    ],
)
def test_who_asks_for_bars_hears_what_is_wrong_with_them(path, change, message):
    change(path)
    with pytest.raises(pliant.InputError) as error:
        _ = one_file(path).framework
    assert str(error.value) == f"{path}: {message}"


def test_what_is_no_trajectory(tmp_path):
    text, empty = tmp_path / "text.h5md", tmp_path / "empty.h5md"
    text.write_text("ATOM      1")
    empty.touch()
    for path, message in (
        (tmp_path / "none.h5md", "no such file"),
        (tmp_path, "is a folder, expected a trajectory file"),
        (text, "is not an HDF5 file"),
        (empty, "is empty"),
    ):
        with pytest.raises(pliant.InputError) as error:
            one_file(path)
        assert str(error.value) == f"{path}: {message}"
