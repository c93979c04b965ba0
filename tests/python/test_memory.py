# SPDX-License-Identifier: MIT
"""Lifetimes, leaks, threads and interrupts at the border between Python and C++."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import pliant

REPORTING = {**os.environ, "PLIANT_REPORT_LEAKS": "1"}

# Made and dropped again and again; ends with cycles through observers and an exception.
SCENARIO = """
import gc, sys
import numpy as np
import pliant

water = pliant.read_text("3\\n\\nO 0 0 0\\nH 0.96 0 0\\nH -0.24 0.93 0\\n", "w.xyz")
kept = []

def refuse(frame):
    kept.append(frame)
    raise ValueError(frame)

for _ in range(5):
    framework = water.framework()
    resolver = pliant.Resolver(framework)
    resolver.resolve(np.random.default_rng(1).normal(size=(3, 3)))
    views = [framework.bars, framework.components(), framework.bridges(), water.positions]
    frames = []
    summary = pliant.run(water, steps=3, observers=[frames.append])
    frames[0].positions, summary.state.positions
    try:
        pliant.run(framework, summary.state, observers=[refuse])
    except ValueError:
        pass
    pliant.techniques()[0].name, pliant.formats()[0].extensions
    try:
        pliant.read("none")
    except pliant.FileError as error:
        kept.append(error)
with pliant.H5mdRecorder(sys.argv[1], framework, overwrite=True) as recorder:
    pliant.run(framework, water.positions, steps=3, observers=[recorder])
reader = pliant.H5mdReader(sys.argv[1])
views.append(reader.positions(0))
"""


def test_nothing_is_left_at_the_end(tmp_path):
    done = subprocess.run(
        [sys.executable, "-X", "dev", "-c", SCENARIO, tmp_path / "out.h5md"],
        capture_output=True,
        text=True,
        check=False,
        env=REPORTING,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_the_report_of_leaks_is_on(tmp_path):
    """A leak made on purpose is reported, so that the test above can fail."""
    script = "import ctypes, pliant; f = pliant.Framework([[0, 1]], [1])\n"
    script += "ctypes.pythonapi.Py_IncRef(ctypes.py_object(f))\n"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False, env=REPORTING
    )
    assert "nanobind: leaked" in done.stderr


def resident_bytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_memory_does_not_grow_with_calls():
    count = 2000
    bars = np.stack([np.arange(count - 1), np.arange(1, count)], axis=1)
    start = np.random.default_rng(1).normal(size=(count, 3))

    def use():
        framework = pliant.Framework(bars, np.ones(count - 1))
        positions = start.copy()
        pliant.resolve(framework, positions, max_sweeps=1)
        pliant.measure_bars(framework, positions)
        pliant.order(framework)
        framework.blocks(), framework.bars, pliant.residuals(framework, positions)
        state = pliant.State(positions)
        state.positions = positions.tolist()
        structure = pliant.Structure(positions, bonds=bars)
        structure.bonds, structure.names, structure.framework(use_masses=False)

    for _ in range(10):
        use()
    gc.collect()
    before = resident_bytes()
    for _ in range(100):
        use()
    gc.collect()
    # One copy of the positions each time would be 5 MB.
    assert resident_bytes() - before < 2_000_000


def test_arguments_are_not_held():
    positions = np.zeros((2, 3))
    framework = pliant.Framework([[0, 1]], [1.0])
    held = sys.getrefcount(positions)
    for _ in range(10):
        pliant.resolve(framework, positions)
        with pytest.raises(pliant.OptionError):
            pliant.resolve(framework, positions, weighting=2)
        pliant.measure_bars(framework, positions)
        pliant.State(positions)
    assert sys.getrefcount(positions) == held


def impossible():
    """Lengths that no triangle has: sweeps go on for ever."""
    return pliant.Framework([[0, 1], [1, 2], [2, 0]], [1, 1, 3])


def test_other_threads_go_on_during_a_resolve_and_ctrl_c_ends_it():
    """The resolve would never end by itself: another thread sees it at work, and then ends it."""
    positions = np.random.default_rng(1).normal(size=(3, 3))
    before = positions.copy()
    began = time.process_time()
    has_ended = threading.Event()

    def watch_and_interrupt():
        while time.process_time() - began < 0.2:
            time.sleep(0.001)
        while not has_ended.is_set():  # Python loses an interrupt that meets a __del__
            os.kill(os.getpid(), signal.SIGINT)
            has_ended.wait(10.0)

    thread = threading.Thread(target=watch_and_interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        pliant.resolve(impossible(), positions, max_sweeps=10**15)
    has_ended.set()
    thread.join()
    assert np.isfinite(positions).all()
    assert not np.array_equal(positions, before)


def test_threads_that_share_a_resolver_wait_for_each_other():
    framework = pliant.Framework([[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]], [1] * 5)
    starts = np.random.default_rng(2).normal(size=(8, 200, 4, 3))
    expected = starts.copy()
    for start in expected.reshape(-1, 4, 3):
        pliant.resolve(framework, start, "random")
    resolver = pliant.Resolver(framework, "random")

    def work(mine):
        for positions in mine:
            resolver.resolve(positions)

    threads = [threading.Thread(target=work, args=(mine,)) for mine in starts]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert starts.tobytes() == expected.tobytes()


def test_warnings_as_errors_do_not_end_the_process(tmp_path):
    script = (
        "import pliant, resource, signal, sys, warnings\n"
        "warnings.simplefilter('error')\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "framework = pliant.Framework([[0, 1]], [1.0])\n"
        "recorder = pliant.H5mdRecorder(sys.argv[1], framework, flush_seconds=1e9)\n"
        "recorder.record(pliant.Frame(0, 0, [[0, 0, 0], [1, 0, 0]]))\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))\n"
        "for step in range(1, 1000):\n"
        "    recorder.record(pliant.Frame(step, step, [[0, 0, 0], [1, 0, 0]]))\n"
        "del recorder\n"
        "print('alive')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, tmp_path / "out.h5md"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "alive\n"), done.stderr
    assert "File too large" in done.stderr


def test_what_is_held_when_python_ends_is_nothing_to_complain_of():
    script = "import ctypes, pliant; held = pliant.Guide()\n"
    script += "ctypes.pythonapi.Py_IncRef(ctypes.py_object(held))\n"
    ended = subprocess.run(
        [sys.executable, "-c", script], text=True, capture_output=True, check=False
    )
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "", "")
