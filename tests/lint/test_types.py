# SPDX-License-Identifier: MIT
"""mypy --strict, which wants every function annotated, finds nothing in the Python package."""

import importlib.util
import shutil
from pathlib import Path

import pytest
from sources import ROOT
from test_tools import passes, tool

PACKAGE = ROOT / "python" / "pliant"
TREE = ROOT / "build" / "mypy" / "tree" / "pliant"


def stub_of_the_extension() -> Path:
    """The stub that nanobind made when the extension was last built; skips where none is."""
    installed = importlib.util.find_spec("pliant")
    near = [Path(installed.origin).with_name("_core.pyi")] if installed else []
    for path in [*near, *sorted(ROOT.glob("build/*/python/_core.pyi"))]:
        if path.exists():
            return path
    pytest.skip("the extension is not built: ./dev build builds it")


def whole_package() -> Path:
    """The sources and the stub of the extension as one package, made of links."""
    shutil.rmtree(TREE, ignore_errors=True)
    TREE.mkdir(parents=True)
    for path in PACKAGE.iterdir():
        if not path.name.startswith(("_core.", "__pycache__")):
            (TREE / path.name).symlink_to(path)
    (TREE / "_core.pyi").symlink_to(stub_of_the_extension())
    return TREE


def test_mypy_finds_nothing():
    passes(tool("mypy"), "--no-error-summary", str(whole_package()))
