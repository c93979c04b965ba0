# SPDX-License-Identifier: MIT
"""pliant.view: what the page is given, what comes back, and both in a real JupyterLab."""

import base64
import gzip
import json
import os
import re
import secrets
import socket
import subprocess
import sys
import urllib.request
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from pliant.play import page
from pliant.play.view import given_of
from real_files import MOLECULES, PEPTIDE
from wasm_solver import BUILT, ROOT, sha1, what_page_lacks

import pliant

BARE = b"<p>page</p>" + page.PLACE


@pytest.fixture
def built(tmp_path, monkeypatch):
    """A package with a page."""
    pytest.importorskip("anywidget")
    monkeypatch.setattr(page, "PAGE", tmp_path / "page.html")
    page.PAGE.write_bytes(BARE)


def digits():
    """A peptide with more digits than a PDB file has."""
    structure = pliant.read(PEPTIDE)
    return pliant.Structure(
        structure.positions * (1 + 1e-9) + 5000,
        elements=structure.elements,
        names=structure.names,
        residue_names=structure.residue_names,
        residue_ids=structure.residue_ids,
        bonds=structure.bonds[:-3],
        title="some/title.xml",
    )


def facts_in(view):
    html = gzip.decompress(view._page)
    return json.loads(re.search(rb'id="given">(.*?)</script>', html)[1])


def test_a_structure_keeps_its_digits_and_its_bonds(built):
    structure = digits()
    view = pliant.view(structure, model="bonds", height=300)
    facts = facts_in(view)
    assert (facts["model"], facts["isInside"], view.height) == ("bonds", True, 300)
    assert np.array_equal(np.reshape(facts["known"]["positions"], (-1, 3)), structure.positions)
    assert np.array_equal(np.reshape(facts["known"]["bonds"], (-1, 3))[:, :2], structure.bonds)
    assert np.array_equal(view.positions, structure.positions)
    assert repr(view) == "<PlayView of 327 joints>"


def test_the_solver_takes_them_as_they_are(solver, tmp_path):
    structure = digits()
    given = given_of(structure)
    file = tmp_path / "given.pdb"
    file.write_bytes(given.data)
    fields = {"name": given.name, "file": str(file), **given.known}
    reply = solver.ask("open", model="bonds", whole=True, **fields)
    assert np.array_equal(np.reshape(reply["positions"], (-1, 3)), structure.positions)
    assert np.array_equal(np.reshape(reply["bars"], (-1, 2)), structure.bonds)
    for wrong, said in (
        ({"positions": [1.0, 2.0, 3.0]}, "some/title.xml.pdb: has 327 atoms, positions 1"),
        ({"bonds": [3, 327, 1]}, "some/title.xml.pdb: bond of atoms 3 and 327 of 327"),
        ({"bonds": [3, 3, 1]}, "some/title.xml.pdb: bond of atoms 3 and 3 of 327"),
    ):
        with pytest.raises(ValueError, match=f"^{re.escape(said)}$"):
            solver.ask("open", model="bonds", **{**fields, **wrong})
    assert solver.ask("state")["hash"]


def test_other_sources(tmp_path):
    mda = pytest.importorskip("MDAnalysis")
    trajectory = tmp_path / "run.h5md"
    pliant.run(pliant.read(PEPTIDE), output=trajectory, steps=3)
    assert given_of(str(trajectory)).data == trajectory.read_bytes()
    assert given_of(pliant.Trajectory(trajectory)).name == "run.h5md"
    assert given_of(PEPTIDE).data == PEPTIDE.read_bytes()
    universe = mda.Universe(str(PEPTIDE))
    assert np.array_equal(given_of(universe).start, universe.atoms.positions)
    assert len(given_of(universe.select_atoms("name CA")).start) == 20
    graph = pliant.generate("tree", seed=1)
    assert given_of(graph).name == "graph.xml"


def test_what_cannot_be_shown(built, tmp_path):
    with pytest.raises(TypeError, match="molecule = 3: must be a Structure, a path"):
        pliant.view(3)
    with pytest.raises(pliant.OptionError, match="model 'steel': expected one of auto, bonds"):
        pliant.view(PEPTIDE, model="steel")
    with pytest.raises(pliant.FileError, match=r"none\.pdb: cannot be read"):
        pliant.view(tmp_path / "none.pdb")
    page.PAGE.unlink()
    with pytest.raises(pliant.Error, match=r"not there: \./dev play makes"):
        pliant.view(PEPTIDE)


def test_what_the_page_tells_is_there(built, monkeypatch):
    view = pliant.view(PEPTIDE)
    heard, sent = [], []
    view.observe(lambda change: heard.append(change.new), "positions")
    monkeypatch.setattr(view, "send", lambda said, buffers: sent.append((said, buffers)))
    view._take(view, {"tell": "ready"}, [])
    assert sent[0][0] == {"tell": "page"}
    html = gzip.decompress(sent[0][1][0])
    given = json.loads(re.search(rb'id="given">(.*?)</script>', html)[1])
    assert base64.b64decode(given["data"]) == PEPTIDE.read_bytes()
    view._take(view, {"tell": "opened", "names": ["A", "B"], "model": "bonds"}, [])
    moved = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 1 / 3]])
    view._take(view, {"tell": "moved"}, [memoryview(moved.tobytes())])
    assert (view.names, view.model) == (["A", "B"], "bonds")
    assert np.array_equal(view.positions, moved)
    assert [len(positions) for positions in heard] == [2]
    view.positions[0, 0] = 7  # one's own to change


# --- in JupyterLab --------------------------------------------------------------------------------

SHOW = """\
import pathlib
import pliant
from pliant.play import page
page.PAGE = pathlib.Path({page!r})
view = pliant.view(pliant.read({file!r}), model="bonds")
view"""
TELL = """\
import json
import numpy as np
np.save("positions.npy", view.positions)
pathlib.Path("view.json").write_text(json.dumps([view.names, view.model]))
print("written")"""


def missing():
    """What a notebook in a browser lacks here."""
    if lacks := what_page_lacks():
        return lacks
    for package in ("anywidget", "ipykernel", "jupyterlab"):
        pytest.importorskip(package)
    return ""


def write_notebook(file, *codes):
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code) for code in codes])
    notebook.metadata.kernelspec = {"name": "python3", "display_name": "Python 3"}
    nbformat.write(notebook, file)


@contextmanager
def lab(folder):
    """JupyterLab on a free port; the address of the folder's notebook."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    words = [
        *("-m", "jupyterlab", "--no-browser", "--allow-root", f"--ServerApp.root_dir={folder}"),
        *(f"--IdentityProvider.token={token}", f"--ServerApp.port={port}"),
        "--ServerApp.port_retries=0",
    ]
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    homes = {name: str(folder / name) for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR")}
    server = subprocess.Popen(
        [sys.executable, *words],
        cwd=folder,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, **homes, "PATH": path},
    )
    try:
        for line in server.stderr:
            if "is running at" in line:
                break
        else:
            raise AssertionError("JupyterLab did not start")
        yield f"http://127.0.0.1:{port}/lab/tree/view.ipynb?token={token}"
        address = f"http://127.0.0.1:{port}/api/shutdown?token={token}"
        urllib.request.urlopen(urllib.request.Request(address, method="POST"), timeout=900).close()
        server.communicate(timeout=900)
    finally:
        server.kill()
        server.wait()


@pytest.mark.long
def test_a_drag_in_a_notebook_comes_back_to_python(tmp_path):
    if reason := missing():
        pytest.skip(reason)
    file = MOLECULES / "alanine_dipeptide.pdb"
    show = SHOW.format(page=str(BUILT / "pliant.html"), file=str(file))
    write_notebook(tmp_path / "view.ipynb", show, TELL)
    script = ROOT / "apps/play/test/from_python/notebook.mjs"
    with lab(tmp_path) as address:
        words = ["node", script, address, *filter(None, [os.environ.get("PLIANT_PICTURE")])]
        done = subprocess.run(words, capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, done.stderr[-4000:]
    shown = json.loads(done.stdout)
    positions = np.load(tmp_path / "positions.npy")
    assert sha1(positions) == sha1(np.array(shown["positions"]))
    structure = pliant.read(file)
    assert np.linalg.norm(positions - structure.positions, axis=1)[shown["joint"]] > 0.05
    off = pliant.residuals(structure.framework(), positions)  # Angstrom, of bars below 2
    assert np.abs(off).max() <= 2e-6
    names, model = json.loads((tmp_path / "view.json").read_text())
    assert (len(names), names[0], model) == (22, "A:ACE1:CH3", "bonds")
    assert shown["complaints"] == []
