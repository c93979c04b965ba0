# SPDX-License-Identifier: MIT
"""The notebooks of docs/ run, and are committed without outputs."""

import json

import places
import pytest

notebooks = pytest.importorskip("notebooks", reason="nbclient is not installed")
ALL = places.notebooks()


def test_there_are_notebooks():
    assert len(ALL) >= 4


#: what takes minutes, and the packages that it needs
LONG = {"docking": ("meeko", "vina")}


@pytest.mark.parametrize("path", [one for one in ALL if one.stem not in LONG], ids=lambda p: p.stem)
def test_notebook_runs(path):
    notebooks.run(path)


@pytest.mark.long
@pytest.mark.parametrize("path", [one for one in ALL if one.stem in LONG], ids=lambda p: p.stem)
def test_long_notebook_runs(path):
    for package in LONG[path.stem]:
        pytest.importorskip(package)
    notebooks.run(path)


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_notebook_holds_no_output(path):
    cells = json.loads(path.read_text())["cells"]
    assert [cell for cell in cells if cell.get("outputs") or cell.get("execution_count")] == []
    assert cells[0]["source"][0].startswith("# ")
