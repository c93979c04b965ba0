# SPDX-License-Identifier: MIT
"""The page of pliant play in Chromium, where node, Chromium and the page are there.

What a person does is tested in apps/play/test by node; here these tests are called, and the files
that the page saves are read by h5py, MDAnalysis and pliant run.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from h5md_contents import positions_in
from real_files import PEPTIDE, ROOT
from wasm_solver import what_page_lacks

TESTS = ROOT / "apps/play/test"
COMMAND = Path(os.environ.get("PLIANT_COMMAND", Path(sys.executable).parent / "pliant"))
TOLERANCE = 1e-6  #: of a bar, relative; the page's default


pytestmark = pytest.mark.skipif(bool(what_page_lacks()), reason=what_page_lacks() or "all is there")


def node(script, *words, timeout):
    return subprocess.run(
        ["node", TESTS / script, *map(str, words)],
        capture_output=True,
        text=True,
        timeout=timeout,
        env={**os.environ, "PLIANT_COMMAND": str(COMMAND)},
    )


# --- all that a person does -----------------------------------------------------------------------


@pytest.mark.long
# What each file of tests does, by the word that chooses it.
@pytest.mark.parametrize("tests", sorted(file.name[:-4] for file in TESTS.glob("*.page.mjs")))
def test_what_a_person_does(tests):
    done = node("run.mjs", tests, timeout=3000)
    assert done.returncode == 0, done.stdout[-4000:]


# --- a short one: two drags, and the files that they leave ----------------------------------------


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What two drags at a peptide leave: the folder of its files, and its facts."""
    folder = tmp_path_factory.mktemp("session")
    return made(ROOT / "data/molecules/peptide_20.pdb", folder)


def made(molecule, folder, *settings):
    done = node("from_python/make_session.mjs", molecule, folder, *settings, timeout=900)
    assert done.returncode == 0, done.stderr[-4000:]
    return folder, json.loads(done.stdout)


def worst_of(file):
    """Largest relative deviation of a bar in any frame of an H5MD file."""
    h5py = pytest.importorskip("h5py")
    with h5py.File(file) as found:
        bars = found["connectivity/bars"][:]
        rest = found["parameters/framework/rest_length"][:]
        worst = 0.0
        for frame in found["particles/trajectory/position/value"]:
            length = np.linalg.norm(frame[bars[:, 0]] - frame[bars[:, 1]], axis=1)
            worst = max(worst, np.abs(length / rest - 1).max())
    return worst


def test_every_bar_of_every_saved_frame_is_whole(session):
    folder, facts = session
    assert facts["steps"] >= 10
    assert worst_of(folder / "session.h5md") <= TOLERANCE


def test_mdanalysis_opens_the_h5md_and_the_pdb(session):
    MDAnalysis = pytest.importorskip("MDAnalysis")
    folder, facts = session
    pdb, h5md = folder / "session.pdb", folder / "session.h5md"
    models, frames = MDAnalysis.Universe(pdb), MDAnalysis.Universe(pdb, h5md)
    assert len(models.trajectory) == len(frames.trajectory) == facts["steps"] + 1
    assert len(frames.atoms) == facts["joints"] == 327
    for k in (0, facts["steps"]):
        models.trajectory[k], frames.trajectory[k]
        assert np.allclose(models.atoms.positions, frames.atoms.positions, atol=0.0011)
    assert frames.trajectory.units["length"] == "Angstrom"


def replayed(molecule, folder, model):
    """The frames that pliant run makes of the session's force file."""
    out = folder / "replayed.h5md"
    words = [
        "run",
        molecule,
        "--forces",
        folder / "session.forces.txt",
        "--model",
        model,
        "-o",
        out,
    ]
    subprocess.run([COMMAND, *map(str, words), "--overwrite"], check=True, capture_output=True)
    return positions_in(out)


def test_pliant_run_replays_the_session_to_the_same_bits(session):
    folder, facts = session
    frames = positions_in(folder / "session.h5md")
    assert np.array_equal(replayed(PEPTIDE, folder, facts["model"]), frames)


#: Of the page's file alone: contacts step by step, limits, sterics, and where a run would go on.
NOT_OF_THE_PAGE = tuple(
    "connectivity/contact_states connectivity/limits observables/contacts_ "
    "parameters/limit parameters/sterics parameters/torsion_preferences "
    "parameters/checkpoint".split()
)


def test_the_h5md_says_of_itself_what_that_of_pliant_run_says(session):
    h5py = pytest.importorskip("h5py")
    folder, facts = session
    replayed(PEPTIDE, folder, facts["model"])
    rows = []
    with h5py.File(folder / "replayed.h5md") as run, h5py.File(folder / "session.h5md") as page:
        run.visititems(lambda path, item: rows.append(path) if hasattr(item, "shape") else None)
        expected = [path for path in rows if not path.startswith(NOT_OF_THE_PAGE)]
        assert len(expected) > 60
        for path in expected:
            if path != "parameters/run/forces":  # the page replays no file
                assert np.array_equal(page[path][()], run[path][()]), path
                assert dict(page[path].attrs).get("unit") == dict(run[path].attrs).get("unit")
        assert page["parameters/run/technique_used"].asstr()[()] == "froda"
        assert page["parameters/run/perturb"].asstr()[()] == "events"


@pytest.mark.long
def test_a_protein_of_3341_atoms(tmp_path):
    data = pytest.importorskip("MDAnalysisTests.datafiles")
    folder, facts = made(data.PDB_small, tmp_path, "blocks", "bonds")
    assert facts["joints"] == 3341
    assert worst_of(folder / "session.h5md") <= TOLERANCE
    frames = positions_in(folder / "session.h5md")
    assert np.array_equal(replayed(data.PDB_small, folder, "bonds"), frames)
