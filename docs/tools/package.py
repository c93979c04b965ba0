# SPDX-License-Identifier: MIT
"""The Python package as text, for the reference: sources, and the stub of the compiled part."""

from __future__ import annotations

import ast
import importlib.util
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TREE = ROOT / "build" / "docs-python" / "pliant"


def make() -> None:
    """Copies the sources into TREE, and puts the stub there as if it were a source.

    Raises FileNotFoundError if pliant is not installed for this Python.
    """
    found = importlib.util.find_spec("pliant")
    if found is None or found.origin is None:
        raise FileNotFoundError("pliant is not installed: ./dev build")
    shutil.rmtree(TREE, ignore_errors=True)
    shutil.copytree(ROOT / "python" / "pliant", TREE, ignore=shutil.ignore_patterns("static"))
    stub = Path(found.origin).with_name("_core.pyi")
    text = stub.read_text(encoding="utf-8")
    (TREE / "_core.py").write_text(text + _shown_overloads(text), encoding="utf-8")


def _shown_overloads(stub: str) -> str:
    """The first of the overloads of each function, as if it were the function itself: the reference
    finds none that has overloads alone."""
    first: dict[str, ast.FunctionDef] = {}
    for node in ast.parse(stub).body:
        if isinstance(node, ast.FunctionDef) and node.decorator_list:
            first.setdefault(node.name, node).decorator_list = []
    return "".join(f"\n\n{ast.unparse(node)}\n" for node in first.values())
