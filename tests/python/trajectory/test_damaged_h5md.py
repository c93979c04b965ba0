# SPDX-License-Identifier: MIT
"""H5MD files that are damaged or made to do harm: one line that names the file, never a traceback.

Every reader in Python is tried on every file: what cannot be used is refused before memory is asked
for, and links in circles and to other files are not followed.
"""

import os
import shutil

import h5py
import numpy as np
import pytest
from pliant.report.check.command import main as check
from pliant.report.command import main as analyse
from pliant.report.compare.command import main as compare
from pliant.trajectory.opened import one_file

import pliant

POSITION = "particles/trajectory/position"
VALUE = f"{POSITION}/value"
RUN = "parameters/run"
HUGE = 10**11
DEEP = 20_000 if os.environ.get("PLIANT_ALL") else 4000
pytestmark = pytest.mark.filterwarnings("ignore:.* has no unit:pliant.PliantWarning")


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    path = tmp_path_factory.mktemp("good") / "good.h5md"
    text = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"
    structure = pliant.read_text(text, "water.xyz")
    pliant.run(structure, output=path, steps=3)
    return path


def put(name, value, keep_unit=True):
    """A change that puts a value in the place of a dataset."""

    def change(file):
        unit = file[name].attrs.get("unit") if name in file else None
        if name in file:
            del file[name]
        file[name] = value
        if unit is not None and keep_unit:
            file[name].attrs["unit"] = unit

    return change


def declare(name, shape, kind):
    """A change that declares a dataset of which nothing is stored."""

    def change(file):
        del file[name]
        chunk = tuple(min(extent, 8) for extent in shape)
        file.create_dataset(name, shape=shape, chunks=chunk, dtype=kind)

    return change


def link(name, target):
    def change(file):
        if name in file:
            del file[name]
        file[name] = target

    return change


def nest(file):
    group = file["parameters"]
    for _ in range(DEEP):
        group = group.create_group("a")


def all_huge(file):
    declare(VALUE, (HUGE, 3, 3), "f8")(file)
    declare(f"{POSITION}/step", (HUGE,), "i8")(file)
    declare(f"{POSITION}/time", (HUGE,), "f8")(file)


def many_bars(file):
    declare("connectivity/bars", (HUGE, 2), "u4")(file)
    declare("parameters/framework/rest_length", (HUGE,), "f8")(file)


def unit_of(value):
    def change(file):
        file[VALUE].attrs["unit"] = value

    return change


CHANGES = {
    "scalar": put(VALUE, 1.0),
    "empty": put(VALUE, h5py.Empty("f8"), keep_unit=False),
    "no_frames": put(VALUE, np.zeros((0, 3, 3))),
    "no_atoms": put(VALUE, np.zeros((4, 0, 3))),
    "one_axis": put(VALUE, np.zeros(4)),
    "text": put(VALUE, np.array([b"a"] * 4)),
    "compound": put(VALUE, np.zeros((4, 3, 3), [("x", "f8")])),
    "not_finite": put(VALUE, np.full((4, 3, 3), np.nan)),
    "huge_frames": declare(VALUE, (HUGE, 3, 3), "f8"),
    "huge_atoms": declare(VALUE, (4, HUGE, 3), "f8"),
    "all_huge": all_huge,
    "many_bars": many_bars,
    "huge_observable": declare("observables/sweeps/value", (HUGE,), "i8"),
    "huge_names": declare("parameters/topology/atom_name", (HUGE,), "S4"),
    "huge_masses": declare("particles/trajectory/mass", (HUGE,), "f8"),
    "link_to_itself": link(VALUE, h5py.SoftLink(f"/{VALUE}")),
    "particles_in_a_circle": link("particles", h5py.SoftLink("/particles")),
    "observables_in_a_circle": link("observables", h5py.SoftLink("/observables")),
    "soft_circle": link("parameters/loop", h5py.SoftLink("/parameters")),
    "hard_circle": lambda file: file.__setitem__("parameters/loop", file["parameters"]),
    "leads_nowhere": link("observables/x", h5py.SoftLink("/nowhere")),
    "other_file": link(VALUE, h5py.ExternalLink("/etc/hostname", "/x")),
    "nested": nest,
    "type_in_particles": link("particles/aaa", np.dtype("f8")),
    "particles_a_number": link("particles", 5),
    "scalar_step": put(f"{POSITION}/step", 1),
    "text_steps": put(f"{POSITION}/step", np.array([b"a"] * 4)),
    "text_times": put(f"{POSITION}/time", np.array([b"a"] * 4)),
    "real_bars": put("connectivity/bars", np.zeros((2, 2))),
    "bars_of_others": put("connectivity/bars", np.full((2, 2), 99, "u4")),
    "bonds_of_others": put("connectivity/bonds", np.full((2, 2), 99, "u4")),
    "one_mass": put("particles/trajectory/mass", np.zeros(1)),
    "text_masses": put("particles/trajectory/mass", np.array([b"a"] * 3)),
    "numbers_as_names": put("parameters/topology/atom_name", np.zeros(3, "i4")),
    "residue_below_0": put("parameters/topology/residue_of", np.full(3, -1)),
    "residue_as_text": put("parameters/topology/residue_of", b"x"),
    "text_tolerance": put(f"{RUN}/tolerance", b"abc"),
    "tolerance_no_number": put(f"{RUN}/tolerance", float("nan")),
    "reference_as_tolerance": lambda file: put(f"{RUN}/tolerance", file["particles"].ref)(file),
    "units": unit_of(np.arange(3)),
    "empty_unit": unit_of(h5py.Empty("S1")),
    "creator": lambda file: file["h5md/creator"].attrs.__setitem__("name", np.arange(3)),
}

#: What of a file does not matter to a reader may be damaged; these cannot be used by any.
FATAL = tuple(
    "scalar empty no_frames one_axis text compound not_finite huge_atoms all_huge "
    "link_to_itself particles_in_a_circle other_file particles_a_number".split()
)


@pytest.fixture(params=CHANGES)
def damaged(request, good, tmp_path):
    path = tmp_path / f"{request.param}.h5md"
    shutil.copy(good, path)
    with h5py.File(path, "a") as file:
        CHANGES[request.param](file)
    return path


def commands(path, good, tmp_path):
    yield check, [path, "--frames", "2", "--quiet"]
    yield analyse, [path, "-o", tmp_path / "report", "--dpi", "50", "--quiet"]
    yield compare, [good, path]
    yield compare, [path, good]


def test_no_command_ends_in_a_traceback(damaged, good, tmp_path, capsys, monkeypatch):
    # What OpenMM says of these files is not asked for: reading them is the matter.
    monkeypatch.setattr("pliant.report.check.suite._ask_openmm", lambda *_: pytest.skip("readable"))
    for main, arguments in commands(damaged, good, tmp_path):
        try:
            code = main([str(argument) for argument in arguments])
        except pytest.skip.Exception:
            code = 0
        said = capsys.readouterr().err.splitlines()
        assert code in (0, 1), (main.__module__, said)
        if code == 1:
            errors = [line for line in said if ": error: " in line]
            assert len(errors) == 1 and damaged.name in errors[0], said
        assert code == 1 or damaged.stem not in FATAL, main.__module__


def test_all_is_read_or_refused_by_name(damaged):
    try:
        frames = one_file(damaged)
        _ = frames.framework, frames.observables, frames.contacts, frames.tolerance
    except pliant.Error as error:
        assert str(error).startswith(f"{damaged}: ")
