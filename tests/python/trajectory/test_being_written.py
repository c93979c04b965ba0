# SPDX-License-Identifier: MIT
"""A file that is being written is read by every reader at any moment, and is never "damaged"."""

import os
import subprocess
import sys
import time

import pytest
from pliant.trajectory.opened import one_file

import pliant

# Commits each frame, and so meets readers often.
WRITER = """
import sys, time, pliant
structure = pliant.read_text("3\\nwater\\nO 0 0 0\\nH 0.96 0 0\\nH -0.24 0.93 0\\n", "water.xyz")
recorder = pliant.H5mdRecorder(
    sys.argv[1], structure.framework(), structure=structure, flush_seconds=0.0,
    precision=1e-6 if len(sys.argv) > 2 else 0.0)
step = 0
with recorder:
    print("ready", flush=True)
    while not sys.stdin.closed and step < 10**6:
        recorder.record(
            pliant.Frame(step=step, time=0.1 * step, positions=structure.positions + 1e-4 * step))
        step += 1
        time.sleep(0.02)
"""


@pytest.fixture(params=["plain", "compressed"])
def written(request, tmp_path):
    path = tmp_path / "growing.h5md"
    words = [sys.executable, "-c", WRITER, str(path)] + ["c"] * (request.param == "compressed")
    writer = subprocess.Popen(words, stdout=subprocess.PIPE)
    assert writer.stdout.readline() == b"ready\n"
    while not path.exists():  # it takes its name with its first frame
        time.sleep(0.01)
    yield path, writer
    writer.kill()
    writer.wait()
    writer.stdout.close()


def last_of(path):
    reader = pliant.H5mdReader(path)
    if len(reader) > 0:
        reader.positions(-1)
    return len(reader)


def test_every_open_reads_all_that_is_there(written):
    path, _ = written
    while last_of(path) == 0:
        pass
    counts = []
    while len(counts) < 75 or counts[-1] == counts[0]:  # a later reader sees new frames
        counts.append(last_of(path))
        counts.append(len(one_file(path)))
    assert counts == sorted(counts)


def test_it_is_said_who_writes(written):
    path, writer = written
    assert pliant._core.writer_of(path) == f"process {writer.pid}"
    writer.kill()
    writer.wait()
    assert pliant._core.writer_of(path) == ""


@pytest.mark.long
def test_what_stays_unreadable_is_being_written(tmp_path):
    path = tmp_path / "half.h5md"
    structure = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")
    recorder = pliant.H5mdRecorder(path, structure.framework(), structure=structure)
    recorder.record(pliant.Frame(0, 0.0, structure.positions))
    recorder.flush()
    os.truncate(path, 3000)
    mine = f"{path}: is being written by "
    for read in (pliant.H5mdReader, one_file):
        with pytest.raises(pliant.FileError) as caught:
            read(path)
        assert str(caught.value).startswith(mine)
