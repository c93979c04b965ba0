# SPDX-License-Identifier: MIT
"""Modules are found by the names that they had in 0.1.0, too, with a warning."""

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import pliant
from pliant import _moved

OLD_NAMES = Path(__file__).with_name("module_names_0_1_0.txt").read_text().split()


def imported_anew(name):
    """The module after an import that no earlier one makes short."""
    for module in [name, *(known for known in sys.modules if known.startswith(name + "."))]:
        sys.modules.pop(module, None)
    return importlib.import_module(name)


@pytest.mark.parametrize("name", OLD_NAMES)
def test_an_old_name_is_the_module_that_it_became(name):
    new = _moved.new_name(name)
    assert new != name
    with pytest.warns(DeprecationWarning, match=f"^{name} is now {new}$"):
        module = imported_anew(name)
    assert module is sys.modules[name] is importlib.import_module(new)
    assert module.__name__ == module.__spec__.name == new


def test_the_warning_names_the_line_that_imports():
    imported = "import warnings\nwarnings.simplefilter('error')\nimport pliant\n"
    old = "import pliant.openmm_check.suite"
    ended = subprocess.run([sys.executable, "-c", imported + old], capture_output=True, text=True)
    assert ended.returncode == 1
    assert ended.stderr.endswith("DeprecationWarning: pliant.openmm_check is now pliant.check\n")
    shown = subprocess.run([sys.executable, "-c", old], capture_output=True, text=True)
    assert shown.returncode == 0
    assert shown.stderr.startswith("<string>:1: DeprecationWarning")


def test_names_within_are_found():
    with pytest.warns(DeprecationWarning):
        sys.modules.pop("pliant.openmm_check", None)
        from pliant.openmm_check import CheckReport, check
    assert (CheckReport, check) == (pliant.check.CheckReport, pliant.check.check)


def test_a_name_that_never_was_is_not_found():
    with pytest.raises(ModuleNotFoundError, match=r"pliant\.bench\.nothing"):
        importlib.import_module("pliant.bench.nothing")


def test_an_old_name_runs_as_a_program():
    words = [sys.executable, "-m", "pliant.openmm_check.command", "--help"]
    ended = subprocess.run(words, capture_output=True, text=True)
    assert ended.returncode == 0
    assert ended.stdout.startswith("usage: pliant check")


def test_one_module_is_loaded_once():
    names = "pliant.peers.child", "pliant._openmm.child"
    code = f"import {names[0]} as a, {names[1]} as b; assert a is b and a.Job is b.Job"
    subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=True)
