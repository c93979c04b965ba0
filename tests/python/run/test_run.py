# SPDX-License-Identifier: MIT
"""run(): the loop, its observers, and that it can be reproduced and interrupted."""

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import pliant

DATA = Path(__file__).parents[3] / "data"
SHAPE = np.array([[0, 0, 0], [1.5, 0, 0], [2, 1.4, 0.3], [0.7, 2.2, 0.6], [-0.5, 1.3, 0.2]])
RING = pliant.Framework([[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]], positions=SHAPE)


def test_every_step_is_whole():
    state = pliant.State(SHAPE)
    memory = state.positions
    summary = pliant.run(RING, state, steps=50)
    assert (summary.steps, summary.frames, summary.unconverged_steps) == (50, 51, 0)
    assert state.step == 50
    assert state.time == pytest.approx(0.5)
    assert state.positions.ctypes.data == memory.ctypes.data
    assert np.abs(memory - SHAPE).max() > 0.01
    assert np.abs(pliant.residuals(RING, memory) / RING.rest_lengths).max() <= 1e-6


def test_recorded_forces_replay_to_the_same_bits(tmp_path):
    file, again = tmp_path / "f.txt", tmp_path / "g.txt"
    first, second = pliant.State(SHAPE), pliant.State(SHAPE)
    settings = {"timestep": 0.02, "tolerance_length": 1e-5, "max_sweeps": 500, "damping": 0.1}
    pliant.run(RING, first, steps=12, seed=4, record_forces=file, **settings)
    forces = pliant.read_force_file(file, RING)
    assert (forces.timestep, forces.tolerance_length, forces.max_sweeps) == (0.02, 1e-5, 500)
    assert forces.pushes == pliant.make_force_file(RING, 12, seed=4).pushes
    pliant.run(
        RING, second, steps=12, seed=4, replay=forces.pushes, record_forces=again, **settings
    )
    assert first.positions.tobytes() == second.positions.tobytes()
    assert again.read_bytes() == file.read_bytes()


def test_forces_are_recorded_only_where_a_file_can_hold_them(tmp_path):
    file = tmp_path / "f.txt"
    with pytest.raises(pliant.OptionError, match="one force on one joint a step, which force_all"):
        pliant.run(RING, SHAPE, steps=1, perturb="force_all", record_forces=file)
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(RuntimeError, match="enough"):
        pliant.run(RING, SHAPE, steps=1, record_forces=file, observers=[_raise_enough])
    assert not file.exists()
    file.write_text("mine")
    with pytest.raises(pliant.FileError, match="exists; overwrite=True replaces it"):
        pliant.run(RING, SHAPE, tmp_path / "o.h5md", steps=1, record_forces=file)
    assert file.read_text() == "mine"
    assert not (tmp_path / "o.h5md").exists()
    pliant.run(RING, SHAPE, steps=1, record_forces=file, overwrite=True)
    assert file.read_text().startswith("pliant-forces 3")


def _raise_enough(frame):
    raise RuntimeError("enough")


def test_observers_see_frames():
    seen = []

    def look(frame):
        assert not frame.positions.flags.writeable
        seen.append((frame.step, frame.time, frame.positions.copy(), frame.root_joint))
        assert frame.converged
        assert frame.stop is pliant.Stop.converged
        assert frame.max_residual <= 1e-6

    state = pliant.State(SHAPE)
    pliant.run(RING, state, steps=7, every=3, observers=[look])
    assert [step for step, *_ in seen] == [0, 3, 6, 7]
    assert seen[0][3] is None
    assert 0 <= seen[1][3] < 5
    assert np.array_equal(seen[0][2], SHAPE)
    assert np.array_equal(seen[-1][2], state.positions)


def test_frames_show_the_state_itself():
    kept = []
    state = pliant.State(SHAPE)
    pliant.run(RING, state, steps=2, observers=[kept.append])
    assert np.shares_memory(kept[0].positions, state.positions)
    last = state.positions.copy()
    del state
    assert np.array_equal(kept[0].positions, last)
    force = np.linalg.norm(kept[1].force)
    assert force == pytest.approx(50.0)


def test_an_observer_may_stop_the_run():
    summary = pliant.run(RING, SHAPE, steps=1000, observers=[lambda frame: frame.step == 4])
    assert (summary.steps, summary.stopped_by_caller) == (4, True)


def test_an_observer_may_raise():
    def refuse(frame):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        pliant.run(RING, SHAPE, observers=[refuse])


def test_positions_given_are_not_touched():
    start = SHAPE.copy()
    pliant.run(RING, start, steps=3)
    assert np.array_equal(start, SHAPE)


def test_a_broken_start_is_warned_of_at_the_callers_line():
    with pytest.warns(pliant.PliantWarning, match="the start misses its rest lengths") as caught:
        pliant.run(RING, SHAPE * 1.1, steps=1)
    assert [warning.filename for warning in caught] == [__file__]


def test_refuses_options_by_name():
    for options, message in [
        ({"steps": -1}, "steps = -1: must be from 0"),
        ({"every": 0}, "every = 0: must be from 1"),
        ({"force": -1.0}, "force = -1: must be 0 or more and finite"),
        ({"timestep": 0.0}, "timestep = 0: must be positive and finite"),
    ]:
        with pytest.raises(pliant.OptionError) as caught:
            pliant.run(RING, SHAPE, **options)
        assert str(caught.value) == message
    with pytest.raises(pliant.OptionError, match="known: force, force_all, displacement"):
        pliant.run(RING, SHAPE, perturb="shake")
    with pytest.raises(pliant.InputError, match="position of joint 1 is not finite"):
        pliant.run(RING, np.where(np.arange(15).reshape(5, 3) == 3, np.nan, SHAPE))


def test_other_threads_go_on_meanwhile_and_ctrl_c_ends_a_run():
    """The run would never end by itself: another thread counts, and then ends it."""
    state = pliant.State(SHAPE)
    began = threading.Event()

    def count_and_interrupt():
        began.wait()
        for _ in range(20):
            time.sleep(0.001)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=count_and_interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        pliant.run(RING, state, steps=10**12, every=10**11, observers=[lambda _: began.set()])
    thread.join()
    assert state.step > 0
    assert np.isfinite(state.positions).all()


def test_tables_name_what_runs_take():
    assert [row.name for row in pliant.perturbations()] == ["force", "force_all", "displacement"]
    for row in [*pliant.perturbations(), *pliant.techniques(), *pliant.orderings()]:
        assert row.summary
        assert row.name in repr(row)


def test_a_file_is_enough(tmp_path):
    """What the command does: bonds perceived, or the framework and positions of graph XML."""
    path = DATA / "molecules" / "cholesterol.cif"
    summary = pliant.run(path, steps=5, seed=2)
    same = pliant.run(pliant.read(path), steps=5, seed=2)
    assert np.array_equal(summary.state.positions, same.state.positions)
    graph = str(DATA / "mechanisms" / "four_bar.xml")
    summary = pliant.run(graph, output=tmp_path / "out.h5md", steps=5)
    assert (summary.converged, len(pliant.H5mdReader(tmp_path / "out.h5md"))) == (True, 6)
    with pytest.raises(pliant.FileError):
        pliant.run("nowhere.pdb")
