# SPDX-License-Identifier: MIT
"""An installation without the laboratory: its commands say so, and nothing else needs it."""

import subprocess
import sys

import pytest

import pliant
from pliant import _laboratory

HIDDEN = "import sys; sys.modules['pliant.lab'] = None\n"
PRODUCT = """
import importlib, pkgutil, pliant
for row in pkgutil.walk_packages(pliant.__path__, "pliant."):
    if not row.name.startswith("pliant.lab") and "tests" not in row.name:
        importlib.import_module(row.name)
"""


def run(code):
    return subprocess.run([sys.executable, "-c", HIDDEN + code], capture_output=True, text=True)


@pytest.mark.parametrize("command", ["bench", "experiment"])
def test_its_commands_say_that_it_is_left_out(command):
    ended = run(f"from pliant import _laboratory; sys.exit(_laboratory.{command}())")
    assert ended.returncode == 1
    assert ended.stderr == (
        f"pliant {command}: error: needs the laboratory, which this installation leaves out: "
        "pip install --force-reinstall --no-deps pliant\n"
    )


def test_no_other_module_needs_it():
    ended = run(PRODUCT)
    assert (ended.returncode, ended.stderr) == (0, "")


def test_a_module_that_the_laboratory_lacks_is_not_taken_for_it():
    code = "import pliant.lab; sys.modules['pliant.lab.bench.subcommands'] = None\n"
    code += "from pliant import _laboratory; _laboratory.bench()"
    ended = subprocess.run([sys.executable, "-c", "import sys\n" + code], capture_output=True)
    assert b"ModuleNotFoundError" in ended.stderr


def test_names_that_are_left_out_say_why():
    package = {"__all__": ["Framework", *_laboratory.NAMES]}
    _laboratory.leave_out(package)
    assert package["__all__"] == ["Framework"]
    with pytest.raises(AttributeError, match=r"^pliant\.generate needs the laboratory, which"):
        package["__getattr__"]("generate")
    with pytest.raises(AttributeError, match=r"^module 'pliant' has no attribute 'generat'$"):
        package["__getattr__"]("generat")


def test_names_of_the_laboratory_are_there_otherwise():
    assert set(_laboratory.NAMES) <= set(pliant.__all__)
    assert all(hasattr(pliant, name) for name in _laboratory.NAMES)
