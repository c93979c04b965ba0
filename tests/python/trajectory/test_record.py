# SPDX-License-Identifier: MIT
"""Recording: what run() and H5mdRecorder leave in a file, whatever ends them."""

import os
import re
import signal
import subprocess
import sys
import threading

import h5py
import numpy as np
import pytest
from h5md_contents import positions_in

import pliant

WATER = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")


def test_a_run_is_recorded(tmp_path):
    path = tmp_path / "out.h5md"
    frames = []
    summary = pliant.run(
        WATER,
        output=path,
        steps=20,
        every=4,
        seed=3,
        observers=[lambda frame: frames.append(frame.positions.copy())],
        parameters={"note/why": "test", "note/times": 2, "note/yes": True, "note/half": 0.5},
    )
    assert (summary.frames, summary.converged) == (6, True)
    assert np.array_equal(positions_in(path), frames)
    assert np.array_equal(frames[-1], summary.state.positions)
    with h5py.File(path) as file:
        bars = file["connectivity/bars"][:]
        rests = file["parameters/framework/rest_length"][:]
        run = file["parameters/run"]
        assert run["technique"][()] == b"auto"
        assert run["technique_used"][()] == b"blocks"
        assert run["seed"][()] == b"3"
        assert (run["steps"][()], run["weighting"][()]) == (20, 0.5)
        assert file["parameters/input/file"][()] == b"water.xyz"
        assert file["parameters/input/bars"][()] == b"bonds"
        note = file["parameters/note"]
        assert (note["why"][()], note["times"][()]) == (b"test", 2)
        assert (bool(note["yes"][()]), note["half"][()]) == (True, 0.5)
        assert file["connectivity/bonds"].shape == (2, 2)
    lengths = np.linalg.norm(np.diff(np.asarray(frames)[:, bars], axis=2)[:, :, 0], axis=-1)
    assert (np.abs(lengths - rests) / rests).max() <= 1e-6


@pytest.mark.filterwarnings("ignore:.*atom UNK1.H is given twice")
def test_a_topology_beside_the_trajectory(tmp_path):
    sidecar = tmp_path / "out.pdb"
    pliant.run(WATER, output=tmp_path / "out.h5md", topology=sidecar, steps=1)
    again = pliant.read(sidecar)
    assert again.names.tolist() == WATER.names.tolist()
    assert again.bonds.tolist() == WATER.bonds.tolist()
    np.testing.assert_allclose(again.positions, WATER.positions, atol=5e-4)
    with pytest.raises(pliant.FileError, match="exists already"):
        pliant.write_topology_pdb(sidecar, WATER)
    pliant.write_topology_pdb(sidecar, WATER, positions=WATER.positions + 5, overwrite=True)
    assert pliant.read(sidecar).positions.min() > 4
    with pytest.raises(TypeError, match="a topology needs a structure"):
        pliant.run(WATER.framework(), WATER.positions, topology=sidecar)


@pytest.mark.filterwarnings("ignore:.*atom UNK1.H is given twice")
def test_the_input_is_never_overwritten(tmp_path):
    path = tmp_path / "water.pdb"
    pliant.write_topology_pdb(path, WATER)
    before = path.read_bytes()
    structure = pliant.read(path)
    (tmp_path / "link.h5md").symlink_to(path)
    for outputs in (
        {"output": path},
        {"output": tmp_path / "link.h5md"},
        {"output": tmp_path / "out.h5md", "topology": path},
    ):
        with pytest.raises(pliant.OptionError, match="is both input and output"):
            pliant.run(structure, steps=1, overwrite=True, **outputs)
    assert path.read_bytes() == before
    assert not (tmp_path / "out.h5md").exists()


def test_two_threads_record_what_one_does(tmp_path):
    def record(name, walker):
        pliant.run(WATER, output=tmp_path / name, steps=200, walker=walker, flush_seconds=0)

    for walker in range(2):
        record(f"serial-{walker}", walker)
    threads = [
        threading.Thread(target=record, args=(f"parallel-{walker}", walker)) for walker in range(2)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for walker in range(2):
        serial = positions_in(tmp_path / f"serial-{walker}")
        assert serial.tobytes() == positions_in(tmp_path / f"parallel-{walker}").tobytes()
    assert serial.tobytes() != positions_in(tmp_path / "serial-0").tobytes()


def test_an_existing_file_is_kept(tmp_path):
    path = tmp_path / "out.h5md"
    path.write_text("precious")
    with pytest.raises(pliant.FileError, match="exists; overwrite=True replaces it"):
        pliant.run(WATER, output=path, steps=1)
    with pytest.raises(pliant.OptionError, match="steps = -1"):
        pliant.run(WATER, output=path, steps=-1, overwrite=True)
    assert path.read_text() == "precious"
    pliant.run(WATER, output=path, steps=1, overwrite=True)
    assert len(positions_in(path)) == 2


def test_what_was_recorded_outlives_an_observer_that_raises(tmp_path):
    path = tmp_path / "out.h5md"

    def refuse(frame):
        if frame.step == 5:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        pliant.run(WATER, output=path, steps=100, observers=[refuse])
    assert len(positions_in(path)) == 6


def test_ctrl_c_leaves_a_readable_file(tmp_path):
    path = tmp_path / "out.h5md"
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        pliant.run(WATER, output=path, steps=10**12, every=100)
    positions = positions_in(path)
    assert len(positions) > 1
    assert np.isfinite(positions).all()


def test_a_recorder_of_ones_own(tmp_path):
    framework = WATER.framework()
    with pliant.H5mdRecorder(tmp_path / "out.h5md", framework, structure=WATER) as recorder:
        recorder.record(pliant.Frame(0, 0.0, WATER.positions))
        found = {"max_residual": 0.25, "root_joint": 2, "stop": pliant.Stop.max_sweeps}
        recorder(pliant.Frame(5, 0.5, WATER.positions + 1, force=(1, 2, 3), **found))
        recorder.flush()
        assert (recorder.frames, recorder.committed_frames) == (2, 2)
        assert recorder.path == tmp_path / "out.h5md"
        with pytest.raises(pliant.InputError, match="comes after that of step 5"):
            recorder.record(pliant.Frame(5, 0.5, WATER.positions))
        with pytest.raises(pliant.InputError, match="has 2 positions for 3 joints"):
            recorder.record(pliant.Frame(6, 0.5, WATER.positions[:2]))
    with h5py.File(tmp_path / "out.h5md") as file:
        assert file["particles/trajectory/position/step"][:].tolist() == [0, 5]
        assert file["observables/max_residual/value"][:].tolist() == [0, 0.25]
        assert file["observables/force_y/value"][:].tolist() == [0, 2]
        assert file["observables/converged/value"][:].astype(bool).tolist() == [True, False]


@pytest.mark.parametrize(
    ("value", "why"),
    [
        ([1], "expected a bool, int, float or str"),
        (None, "expected a bool, int, float or str"),
        (2**63, "does not fit into 64 bits, or is no Unicode text"),
        ("\ud800", "does not fit into 64 bits, or is no Unicode text"),
        (float("nan"), "is not finite"),
        (float("inf"), "is not finite"),
    ],
)
def test_a_bad_parameter_is_named(tmp_path, value, why):
    path = tmp_path / "o"
    with pytest.raises(ValueError, match="^" + re.escape(f'parameters["run/x"]: {why}') + "$"):
        pliant.H5mdRecorder(path, WATER.framework(), parameters={"run/x": value})
    assert not path.exists()


def test_a_closed_recorder_takes_no_frame(tmp_path):
    path = tmp_path / "out.h5md"
    recorder = pliant.H5mdRecorder(path, WATER.framework())
    recorder.record(pliant.Frame(0, 0.0, WATER.positions))
    recorder.close()
    with pytest.raises(pliant.FileError, match=f"^{path}: is closed: no frame can be recorded$"):
        recorder.record(pliant.Frame(1, 0.1, WATER.positions))
    recorder.flush()
    recorder.close()
    assert (recorder.frames, len(pliant.H5mdReader(path))) == (1, 1)


@pytest.mark.parametrize("time", [float("nan"), float("inf"), -float("inf")])
def test_a_frame_has_a_finite_time(time):
    with pytest.raises(pliant.InputError, match=r"^time: is not finite$"):
        pliant.Frame(0, time, WATER.positions)


def test_a_state_is_moved_by_one_run_at_a_time():
    framework, state = WATER.framework(), pliant.State(WATER.positions)
    met = []

    def run_within(frame):
        with pytest.raises(RuntimeError, match=r"^State: another run is moving it$"):
            pliant.run(framework, state, steps=1)
        met.append(pliant.run(framework, pliant.State(WATER.positions), steps=1).steps)

    pliant.run(framework, state, steps=2, observers=[run_within])
    assert met == [1, 1, 1]
    assert pliant.run(framework, state, steps=1).steps == 1


FORKS = """
import os, sys, threading
import pliant
path, other = sys.argv[1:]
water = pliant.read_text("2\\n\\nH 0 0 0\\nH 0.74 0 0\\n", "h.xyz")
framework = water.framework()
recorder = pliant.H5mdRecorder(path, framework, flush_seconds=0)
done = threading.Event()

def record():
    step = 0
    while not done.is_set():
        recorder.record(pliant.Frame(step, 0.1 * step, water.positions))
        step += 1

thread = threading.Thread(target=record)
thread.start()
codes = []
for k in range(20):
    child = os.fork()
    if child == 0:
        code = 1
        try:
            recorder.record(pliant.Frame(10**9, 1.0, water.positions))
        except RuntimeError as error:
            code = 0 if "belongs to process" in str(error) else 2
        try:
            pliant.run(water, output=f"{other}{k}", steps=2)
        except pliant.FileError as error:
            code = code if "was forked" in str(error) else 3
        if k % 2:
            os._exit(code)
        del recorder
        sys.exit(code)
    codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
done.set()
thread.join()
frames = recorder.frames
recorder.close()
reader = pliant.H5mdReader(path)
print(codes.count(0), frames == len(reader), reader.step(-1) < 10**9)
"""


def test_a_forked_process_neither_hangs_nor_writes(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", FORKS, tmp_path / "out.h5md", tmp_path / "child"],
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "20 True True\n"), done.stderr


def test_reads_back_what_was_recorded(tmp_path):
    path = tmp_path / "out.h5md"
    framework = WATER.framework("angles", pin="name O")
    summary = pliant.run(framework, WATER.positions, path, steps=6, every=2, structure=WATER)
    reader = pliant.H5mdReader(path)
    assert (len(reader), reader.joint_count) == (4, 3)
    assert np.array_equal(reader.positions(-1), summary.state.positions)
    assert (reader.step(2), reader.time(2)) == (4, pytest.approx(0.04))
    assert reader.observable("sweeps").shape == (4,)
    assert "max_residual" in reader.observables
    assert reader.parameters()["run/steps"] == 6
    again = reader.framework()
    assert again.bars.tolist() == framework.bars.tolist()
    assert again.rest_lengths.tolist() == framework.rest_lengths.tolist()
    assert again.pinned.tolist() == [0]
    assert again.label(0) == "O(1)"
    structure = reader.structure()
    assert structure.symbols.tolist() == ["O", "H", "H"]
    assert structure.bonds.tolist() == WATER.bonds.tolist()
    assert structure.bond_origins.tolist() == ["distance", "distance"]
    assert np.array_equal(structure.positions, WATER.positions)
    with pytest.raises(IndexError, match=r"^frame 4 of 4 does not exist$"):
        reader.positions(4)
    with pytest.raises(pliant.FileError):
        pliant.H5mdReader(tmp_path / "none.h5md")


def test_replays_a_force_file(tmp_path):
    framework = WATER.framework()
    path = tmp_path / "pushes.txt"
    path.write_text(
        "pliant-forces 3\nset timestep 0.02\nset tolerance 1e-7\nset max_sweeps 50\n"
        "push 1 30 -3 0.25\npush 2 0 40 0\n"
    )
    forces = pliant.read_force_file(path, framework)
    assert (forces.timestep, forces.tolerance, forces.max_sweeps) == (0.02, 1e-7, 50)
    assert forces.tolerance_length is None
    assert forces.pushes == [(1, (30.0, -3.0, 0.25)), (2, (0.0, 40.0, 0.0))]
    seen = []
    pliant.run(
        framework,
        WATER.positions,
        replay=forces.pushes,
        timestep=forces.timestep,
        observers=[lambda frame: seen.append((frame.root_joint, frame.force))],
    )
    assert seen == [(None, (0.0, 0.0, 0.0)), *forces.pushes]
    path.write_text(forces.text(framework))
    assert pliant.read_force_file(path, framework).pushes == forces.pushes
    with pytest.raises(IndexError, match=r"^joint 9 of 3 does not exist$"):
        pliant.run(framework, WATER.positions, replay=[(9, (1, 0, 0))])
    with pytest.raises(pliant.InputError, match=r"^replay: force on H\(2\) is not finite$"):
        pliant.run(framework, WATER.positions, replay=[(1, (np.inf, 0, 0))])
    with pytest.raises(pliant.InputError, match=r"^replay: holds no push$"):
        pliant.run(framework, WATER.positions, replay=[])


def test_a_failed_write_is_raised(tmp_path):
    script = (
        "import pliant, resource, signal, sys\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))\n"
        "water = pliant.read_text('3\\n\\nO 0 0 0\\nH 0.96 0 0\\nH -0.24 0.93 0\\n', 'w.xyz')\n"
        "try:\n"
        "    pliant.run(water, output=sys.argv[1], steps=100_000, flush_seconds=0.01)\n"
        "except pliant.FileError as error:\n"
        "    print(error)\n"
    )
    path = tmp_path / "out.h5md"
    done = subprocess.run(
        [sys.executable, "-c", script, path], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "File too large" in done.stdout
    assert np.isfinite(positions_in(path)).all()
