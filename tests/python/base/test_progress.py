# SPDX-License-Identifier: MIT
"""Progress bars: in notebooks and on terminals, and nowhere else."""

import fcntl
import os
import pty
import struct
import subprocess
import sys
import termios
import types

import numpy as np
import pytest
from real_files import MOLECULES

import pliant
from pliant.base import console
from pliant.base import progress as _progress

CAFFEINE, ASPIRIN = MOLECULES / "caffeine.sdf", MOLECULES / "aspirin.sdf"

#: A run that looks at its bar as often as it can, so that no machine is too fast to show it.
RUN = f"""
import pliant
from pliant.base import progress as _progress
_progress.DELAY = _progress.INTERVAL = 0.0
pliant.run({str(CAFFEINE)!r}, steps=3000, every=3000)
"""


class RecordedBar:
    def __init__(self, what, total):
        self.what, self.total, self.shown, self.closed = what, total, [], 0

    def show(self, done):
        self.shown.append(done)

    def close(self):
        self.closed += 1


@pytest.fixture
def bars(monkeypatch):
    made = []

    def begin(what, total):
        made.append(RecordedBar(what, total))
        return made[-1]

    monkeypatch.setattr(_progress, "begin", begin)
    monkeypatch.setattr(_progress, "INTERVAL", 0.0)
    return made


def on_a_terminal(code, **environment):
    """What a script writes to a terminal as its stderr."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("4H", 24, 80, 0, 0))
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdout=subprocess.DEVNULL,
        stderr=theirs,
        env={**os.environ, **environment},
    )
    os.close(theirs)
    text = b""
    try:
        while piece := os.read(ours, 65536):
            text += piece
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    assert process.wait() == 0, text.decode()
    return text.decode()


def test_run_tells_its_steps(bars):
    pliant.run(CAFFEINE, steps=3000, every=3000)
    (bar,) = bars
    assert (bar.what, bar.total, bar.closed) == ("steps", 3000, 1)
    assert bar.shown
    assert np.all(np.diff([0, *bar.shown, 3000]) >= 0)
    assert bar.shown[-1] > 0


def test_sample_tells_its_frames(bars):
    pliant.sample(pliant.read(ASPIRIN), 500)
    (bar,) = bars
    assert (bar.what, bar.total, bar.closed) == ("frames", 500, 1)
    assert bar.shown
    assert np.all(np.diff([0, *bar.shown, 500]) >= 0)


def test_bar_is_closed_if_the_run_fails(bars):
    def fails(frame):
        raise RuntimeError("no")

    with pytest.raises(RuntimeError, match="no"):
        pliant.run(CAFFEINE, steps=10, observers=[fails])
    assert bars[0].closed == 1


def test_a_bar_that_fails_ends_the_run(bars, monkeypatch):
    def show(self, done):
        raise ValueError("the bar is broken")

    monkeypatch.setattr(RecordedBar, "show", show)
    with pytest.raises(ValueError, match="the bar is broken"):
        pliant.run(CAFFEINE, steps=3000, every=3000)


def test_analyse_names_its_stages(bars, tmp_path):
    pytest.importorskip("MDAnalysis")
    pliant.run(CAFFEINE, output=tmp_path / "out.h5md", steps=5)
    bars.clear()
    pliant.analyse(tmp_path / "out.h5md")
    (bar,) = bars
    assert bar.shown == list(range(len(bar.shown)))
    assert bar.total - 1 <= len(bar.shown) <= bar.total
    assert bar.closed == 1


def test_nothing_is_shown_without_a_terminal():
    done = subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("", "")


def test_a_terminal_shows_a_bar():
    text = on_a_terminal(RUN)
    assert "steps" in text
    assert "3000" in text


def test_a_terminal_without_tqdm_shows_a_bar():
    text = on_a_terminal("import sys\nsys.modules['tqdm.auto'] = None\n" + RUN)
    assert "steps: [" in text
    assert " / 3000" in text
    assert text.endswith("\r\x1b[K")


def test_it_can_be_hidden():
    assert on_a_terminal(RUN, TQDM_DISABLE="1") == ""
    assert on_a_terminal("from pliant.base import progress\nprogress.hide()" + RUN) == ""


def test_a_notebook_shows_a_bar(tmp_path):
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    cell = nbformat.v4.new_code_cell(RUN)
    notebook = nbformat.v4.new_notebook(cells=[cell])
    resources = {"metadata": {"path": str(tmp_path)}}
    done = nbclient.NotebookClient(notebook, timeout=900, resources=resources).execute()
    shown = str(done.cells[0].outputs)
    assert "steps" in shown
    assert "3000" in shown
    assert "TqdmWarning" not in shown


def test_commands_of_python_show_bars_in_notebooks(bars, monkeypatch):
    kernel = types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: kernel))
    with console.progress("jobs") as show:
        show(1, 4)
        show(2, 4)
    (bar,) = bars
    assert (bar.what, bar.total, bar.shown, bar.closed) == ("jobs", 4, [1, 2], 1)


def test_walkers_that_begin_are_shown(bars):
    structure = pliant.read(CAFFEINE)
    seen = []
    pliant.run_ensemble(
        structure.framework(),
        structure.positions,
        (3, 8),
        steps=2,
        observers_of=lambda walker: seen.append(walker) or (),
    )
    (bar,) = bars
    assert (bar.what, bar.total, bar.closed) == ("walkers begun", 5, 1)
    assert bar.shown == sorted(bar.shown) and bar.shown[-1] == 5
    assert sorted(seen) == [3, 4, 5, 6, 7]


def test_long_work_without_a_terminal_says_now_and_then_how_far_it_is(monkeypatch, capsys):
    monkeypatch.setattr(_progress, "LINE_EVERY", 0.0)
    with _progress.progress("structures", lines=True) as show:
        show(1, 3)
        show(1, 3)
        show(3, 3)
    with _progress.progress("structures") as show:
        show(1, 3)
    assert capsys.readouterr().err == "structures: 1 of 3\nstructures: 3 of 3\n"
