# SPDX-License-Identifier: MIT
"""What only a real system shows, by the commands of other systems: names of files in UTF-8, and
runs that are killed in the middle and continued."""

import contextlib
import os
import signal
import subprocess
import time

import h5py
import pytest
from emulated import EMULATED, ROOT
from h5md_contents import assert_same_runs, stored

PEPTIDE = (ROOT / "data/molecules/peptide_20.pdb").read_bytes()
NAME = "größe 名"
EVERY = 50
ENDLESS = 10**9  # steps: no run reaches them before it is killed, however fast the machine


@pytest.fixture(params=EMULATED)
def theirs(request, command):
    return command(request.param)


def test_names_of_files_are_utf8(theirs, tmp_path):
    (tmp_path / f"{NAME}.pdb").write_bytes(PEPTIDE)
    output = f"{NAME}.h5md"
    printed = theirs.succeed("sample", f"{NAME}.pdb", "--frames", 3, "-o", output, cwd=tmp_path)
    assert output in printed.decode()
    assert NAME in theirs.succeed("info", f"{NAME}.pdb", cwd=tmp_path).decode()
    assert stored(tmp_path / output)
    (tmp_path / f"{NAME}.xyz").write_text("2\n\nC 0 0\n", encoding="utf-8")
    refused = theirs.run("info", f"{NAME}.xyz", cwd=tmp_path)
    assert refused.returncode == 1
    assert f"{NAME}.xyz:4: 2 atoms wanted" in refused.stderr.decode()


def test_what_is_there_is_kept_or_replaced(theirs, tmp_path):
    (tmp_path / "m.pdb").write_bytes(PEPTIDE)
    words = ["run", "m.pdb", "--steps", 4, "-o", "out.h5md"]
    theirs.succeed(*words, cwd=tmp_path)
    first = stored(tmp_path / "out.h5md")
    refused = theirs.run(*words, cwd=tmp_path)
    assert refused.returncode == 1
    assert b"exists; --overwrite replaces it" in refused.stderr
    assert stored(tmp_path / "out.h5md") == first
    theirs.succeed(*words, "--overwrite", "--seed", 9, cwd=tmp_path)
    assert stored(tmp_path / "out.h5md") != first
    assert sorted(os.listdir(tmp_path)) == ["m.pdb", "out.h5md", "out.pdb"]


def frames_in(path):
    """How many were committed, also while the file is written; 0 where there is none yet."""
    with contextlib.suppress(OSError, KeyError), h5py.File(path, "r", locking=False) as file:
        return len(file["particles/trajectory/position/step"])
    return 0


def kill_after(process, file, frames, environment):
    """When so many are committed. Wine's server learns of the end a little later, and holds the
    locks until then."""
    while frames_in(file) < frames:
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    assert process.wait() == -signal.SIGKILL
    if process.args[0] == "wine":
        subprocess.run(["wineserver", "-w"], env=environment, check=True)


def test_a_run_killed_three_times_and_continued_is_that_of_one(theirs, tmp_path):
    (tmp_path / "m.pdb").write_bytes(PEPTIDE)
    part = tmp_path / "part.h5md"
    words = ["run", "m.pdb", "--steps", ENDLESS, "--every", EVERY, "-o", "part.h5md"]
    for _ in range(3):
        process = theirs.start(
            *words, cwd=tmp_path, start_new_session=True, stdout=subprocess.DEVNULL
        )
        kill_after(process, part, frames_in(part) + 100, theirs.environment)
        words = ["run", "--continue", "part.h5md", "--steps", ENDLESS]
    steps = EVERY * (frames_in(part) + 100)
    theirs.succeed("run", "--continue", "part.h5md", "--steps", steps, cwd=tmp_path)
    whole = ["run", "m.pdb", "--steps", steps, "--every", EVERY, "-o", "whole.h5md"]
    theirs.succeed(*whole, cwd=tmp_path)
    assert_same_runs(tmp_path / "whole.h5md", part)
