# SPDX-License-Identifier: MIT
"""The Python package is annotated throughout, and mypy --strict finds nothing in it."""

import ast
import importlib.util
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from sources import ROOT, files, place, refuse
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


def unannotated(path: Path) -> Iterator[str]:
    """Functions with an argument or a result of which nothing is said."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
        every += [one for one in (node.args.vararg, node.args.kwarg) if one]
        names = [one.arg for one in every if one.annotation is None]
        names = [name for name in names if name not in ("self", "cls")]
        names += [] if node.returns else ["result"]
        if names:
            yield f"{place(path, node.lineno)}: {node.name}: no type of {', '.join(names)}"


def test_everything_is_annotated():
    sources = files(".py", folders=("python/pliant",))
    refuse([text for path in sources for text in unannotated(path)])


def test_mypy_finds_nothing():
    passes(tool("mypy"), "--no-error-summary", str(whole_package()))
