# SPDX-License-Identifier: MIT
"""Figures drawn in two processes: the same bytes as in one, and nothing lost when one fails."""

import os
import signal
import sys
import threading

import pytest
from pliant.report.build import Report
from pliant.report.figures import draw_in_parallel
from pliant.report.sections.table import SECTIONS

pytestmark = pytest.mark.usefixtures("rendered")
on_linux = pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux only")


def two_of(analysis, folder):
    """Two figures being drawn."""
    pictures = Report(analysis, SECTIONS).pictures[-2:]
    return draw_in_parallel.Drawing(analysis, pictures, folder, 60)


def drawn(analysis, folder):
    folder.mkdir()
    with two_of(analysis, folder) as drawing:
        figures = drawing.finish()
    assert [path.stem for _, path in figures] == [picture.name for picture, _ in figures]
    return {path.name: path.read_bytes() for _, path in figures}


@on_linux
def test_two_processes_write_the_bytes_of_one(analysis, tmp_path, monkeypatch):
    monkeypatch.setattr(draw_in_parallel, "may_fork", lambda: False)
    alone = drawn(analysis, tmp_path / "one")
    monkeypatch.setattr(draw_in_parallel, "may_fork", lambda: True)
    monkeypatch.setattr(
        draw_in_parallel.Drawing, "finish", finish_after_the_other(draw_in_parallel.Drawing.finish)
    )
    assert drawn(analysis, tmp_path / "two") == alone
    assert len(alone) == 2


def finish_after_the_other(finish):
    """`finish` of a first process so slow that the other draws all."""

    def late(drawing):
        os.waitid(os.P_PID, drawing._child, os.WEXITED | os.WNOWAIT)
        return finish(drawing)

    return late


@on_linux
def test_what_a_process_that_dies_left_out_is_drawn(analysis, tmp_path, monkeypatch):
    monkeypatch.setattr(draw_in_parallel, "may_fork", lambda: False)
    alone = drawn(analysis, tmp_path / "one")
    monkeypatch.setattr(draw_in_parallel, "may_fork", lambda: True)
    mine = os.getpid()
    save = draw_in_parallel.save_picture

    def save_or_die(*what):
        if os.getpid() != mine:
            os.kill(os.getpid(), signal.SIGKILL)  # which no handler turns into pages of a trace
        save(*what)

    monkeypatch.setattr(draw_in_parallel, "save_picture", save_or_die)
    monkeypatch.setattr(
        draw_in_parallel.Drawing, "finish", finish_after_the_other(draw_in_parallel.Drawing.finish)
    )
    assert drawn(analysis, tmp_path / "two") == alone


@on_linux
def test_no_process_is_left_when_the_work_beside_fails(analysis, tmp_path, monkeypatch):
    monkeypatch.setattr(draw_in_parallel, "may_fork", lambda: True)
    with pytest.raises(RuntimeError, match="beside"), two_of(analysis, tmp_path) as drawing:
        child = drawing._child
        raise RuntimeError("beside")
    with pytest.raises(ChildProcessError):
        os.waitpid(child, 0)


@on_linux
def test_a_process_with_other_threads_is_not_forked(analysis):
    here, go = threading.Event(), threading.Event()
    other = threading.Thread(target=lambda: (here.set(), go.wait()))
    other.start()
    here.wait()
    try:
        assert not draw_in_parallel.may_fork()
    finally:
        go.set()
        other.join()
