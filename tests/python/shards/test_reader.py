# SPDX-License-Identifier: MIT
"""MDAnalysis opens all shards as one trajectory."""

import pickle
import shutil
import subprocess
import sys
import warnings

import h5py
import MDAnalysis
import numpy as np
import pliant.mdanalysis
import pytest
from ensembles import PEPTIDE, frames_of, shards_of
from MDAnalysis.analysis.rms import RMSD


@pytest.fixture
def universe(ensemble):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # nothing to complain about
        return MDAnalysis.Universe(ensemble / "ensemble.pliant")


def test_all_frames_are_there_in_the_order_of_walkers(universe, ensemble):
    positions, steps, times, walkers = frames_of(shards_of(ensemble), names=("walker",))
    assert len(universe.trajectory) == len(steps) == 24 * 5
    for k, frame in enumerate(universe.trajectory):
        assert (frame.frame, frame.time) == (k, times[k])
        assert (frame.data["walker"], frame.data["step"]) == (walkers[k], steps[k])
        assert np.array_equal(frame.positions, positions[k].astype(np.float32))


def test_frames_in_any_order(universe, ensemble):
    positions = frames_of(shards_of(ensemble), names=())[0]
    for k in (119, 0, 64, 20, 19, 118, 40):
        assert np.array_equal(universe.trajectory[k].positions, positions[k].astype(np.float32))
    with pytest.raises(IndexError):
        universe.trajectory[120]
    assert [frame.frame for frame in universe.trajectory[18:42:11]] == [18, 29, 40]


def test_every_number_of_a_frame_is_there(universe, ensemble):
    names = tuple(sorted(h5py.File(shards_of(ensemble)[0])["observables"]))
    columns = frames_of(shards_of(ensemble), names)[3:]
    for k in (0, 1, 2, 57, 56, 119, 3):
        data = universe.trajectory[k].data
        assert {name: data[name] for name in names} == {
            name: column[k].item() for name, column in zip(names, columns, strict=True)
        }


def test_names_and_bonds_are_those_of_the_input(universe):
    structure = pliant.read(PEPTIDE)
    structure.perceive_bonds()
    assert list(universe.atoms.names) == list(structure.names)
    assert len(universe.bonds) == len(structure.bonds)
    assert universe.trajectory.dt == pytest.approx(0.1)


def test_analyses_run_on_it_in_processes_too(universe):
    alone = RMSD(universe, select="name CA").run()
    if "multiprocessing" in getattr(RMSD, "get_supported_backends", tuple)():
        both = RMSD(universe, select="name CA").run(backend="multiprocessing", n_workers=2)
        assert np.array_equal(alone.results.rmsd, both.results.rmsd)
    assert alone.results.rmsd.shape == (120, 3)


def test_copies_and_pickles_go_their_own_way(universe):
    universe.trajectory[30]
    for other in (universe.copy(), pickle.loads(pickle.dumps(universe))):
        assert np.array_equal(other.atoms.positions, universe.atoms.positions)
        other.trajectory[31]
        assert universe.trajectory.frame == 30


def test_the_folder_may_be_moved_and_needs_no_other_file(ensemble, tmp_path):
    moved = shutil.copytree(ensemble, tmp_path / "elsewhere")
    code = "import sys, MDAnalysis, pliant.mdanalysis\n"
    code += "print(len(MDAnalysis.Universe(sys.argv[1]).trajectory))"
    ended = subprocess.run(
        [sys.executable, "-c", code, moved / "ensemble.pliant"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=True,
    )
    assert ended.stdout == "120\n"


def test_what_is_whole_can_be_looked_at_while_the_rest_is_made(ensemble, tmp_path):
    folder = shutil.copytree(ensemble, tmp_path / "half")
    lines = (folder / "shards.jsonl").read_text().splitlines(keepends=True)
    (folder / "shards.jsonl").write_text("".join(sorted(lines)[:4]))
    with pytest.warns(pliant.PliantWarning, match="4 of 6 shards are there"):
        universe = MDAnalysis.Universe(folder / "ensemble.pliant")
    assert len(universe.trajectory) == 80


def test_a_shard_that_is_gone_is_an_error_and_no_empty_frame(ensemble, tmp_path):
    folder = shutil.copytree(ensemble, tmp_path / "gone")
    universe = MDAnalysis.Universe(folder / "ensemble.pliant")
    shards_of(folder)[3].unlink()
    with pytest.raises((OSError, pliant.Error), match="shard-000000012"):
        universe.trajectory[65]
    assert universe.trajectory[100].frame == 100


def test_a_first_shard_that_is_gone_is_named(ensemble, tmp_path):
    folder = shutil.copytree(ensemble, tmp_path / "gone")
    shards_of(folder)[0].unlink()
    with pytest.raises(OSError, match=r"shard-000000000-000000003\.h5md: is gone: the same"):
        MDAnalysis.Universe(folder / "ensemble.pliant")
