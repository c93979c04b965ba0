# SPDX-License-Identifier: MIT
"""The Python package as text, for the reference: sources, and the stub of the compiled part."""

from __future__ import annotations

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
    (TREE / "_core.py").write_text(stub.read_text(encoding="utf-8"), encoding="utf-8")
