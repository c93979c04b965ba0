# SPDX-License-Identifier: MIT
"""What is not asked for is the same in Python as in the command."""

import importlib
import inspect
import subprocess

import pytest
from pliant.base.console import command_path
from real_files import PEPTIDE

import pliant

pytestmark = pytest.mark.filterwarnings(
    "ignore:frames reach an amplitude", "ignore:no bond can rotate", "ignore:select. .* bonds"
)

#: parameters that tell of the file, and where a value is from in words
OF_THE_COMMAND = ("input/", "sample/amplitude_reason")


def compare(folder):
    """What both files say must agree; the command also says what Python has no option for."""
    ours, theirs = (
        pliant.H5mdReader(folder / f"{name}.h5md").parameters() for name in ("python", "command")
    )
    shared = [name for name in ours if name in theirs and not name.startswith(OF_THE_COMMAND)]
    assert len(shared) > 5
    assert {name: ours[name] for name in shared} == {name: theirs[name] for name in shared}


def by_command(*words):
    subprocess.run([command_path(), *map(str, words)], check=True, capture_output=True)


def test_of_a_sample(tmp_path):
    by_command("sample", PEPTIDE, "-o", tmp_path / "command.h5md", "--frames", 2)
    pliant.sample(PEPTIDE, 2, output=tmp_path / "python.h5md")
    compare(tmp_path)
    frames = [pliant.Trajectory(tmp_path / f"{k}.h5md").positions for k in ("python", "command")]
    assert frames[0].tobytes() == frames[1].tobytes()


def test_of_a_run(tmp_path):
    by_command("run", PEPTIDE, "-o", tmp_path / "command.h5md", "--steps", 2)
    pliant.run(PEPTIDE, output=tmp_path / "python.h5md", steps=2)
    compare(tmp_path)


def test_of_a_path(tmp_path):
    pliant.sample(PEPTIDE, 1).save(tmp_path / "end.pdb")
    by_command("path", PEPTIDE, tmp_path / "end.pdb", "-o", tmp_path / "command.h5md")
    pliant.path(PEPTIDE, tmp_path / "end.pdb", output=tmp_path / "python.h5md")
    compare(tmp_path)


def test_all_cores_sample():
    for function in (pliant.sample, pliant.continue_sample):
        assert inspect.signature(function).parameters["threads"].default is None
    few, many = (pliant.sample(PEPTIDE, 3, threads=threads) for threads in (1, None))
    assert few.positions.tobytes() == many.positions.tobytes()


#: functions whose command is written in Python: its module
COMMANDS = {
    "analyse": "pliant.report.command",
    "compare": "pliant.report.compare.command",
    "check": "pliant.report.check.command",
    "convert": "pliant.adapters.convert.command",
    "path": "pliant.jobs.path.command",
}

#: rows of C++ for options that a command leaves out when they are not given
ROWS = {"path": pliant._core.path_rows}

#: what the command gives in another way: a flag with an argument, text of its own
OTHERWISE = {
    *(("path", "backtrack"), ("compare", "output"), ("compare", "frames")),
    *(("check", "force_field"), ("check", "displacements"), ("check", "quiet")),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_of_other_functions(name):
    pytest.importorskip("MDAnalysis")
    module = importlib.import_module(COMMANDS[name])
    parser = getattr(module, "make_parser", None) or module._parser
    parser = parser()
    options = {action.dest: action.default for action in parser._actions}
    options |= {row["name"]: row["default"] for row in ROWS.get(name, list)()}
    parameters = inspect.signature(getattr(pliant, name)).parameters.values()
    shared = [one for one in parameters if one.name in options and one.kind is one.KEYWORD_ONLY]
    assert shared
    unlike = {
        one.name: (one.default, options[one.name])
        for one in shared
        if (name, one.name) not in OTHERWISE
        and (one.default or None) != (options[one.name] or None)
    }
    assert unlike == {}
