# SPDX-License-Identifier: MIT
"""What Python of Windows lacks is imported only where it is used: here a process lacks it, too."""

import subprocess
import sys

import h5py
import pytest
from pliant.base.file_lock import take_lock
from pliant.trajectory.recover.pieces import dataset, salvage

# fork is taken away after the imports: what begins processes decides by it when it does.
LACKING = """
import importlib, importlib.metadata, os, sys

class Lacking:
    def find_spec(self, name, path=None, target=None):
        if name in ("fcntl", "grp", "pwd", "pty", "resource", "termios", "tty"):
            raise ModuleNotFoundError(name)

sys.meta_path.insert(0, Lacking())
for name in [name for name in sys.modules if name in ("fcntl", "pwd", "resource", "termios")]:
    del sys.modules[name]
for point in importlib.metadata.distribution("pliant").entry_points:
    importlib.import_module(point.value.partition(":")[0])
print(len(importlib.metadata.distribution("pliant").entry_points) > 10)
"""


def test_every_command_is_imported_without_what_only_posix_has():
    said = subprocess.run([sys.executable, "-c", LACKING], capture_output=True, text=True)
    assert (said.stderr, said.stdout) == ("", "True\n")


def test_a_lock_holds_between_two_openings(tmp_path):
    path = tmp_path / "lock"
    with open(path, "w") as first, open(path, "w") as second:
        take_lock(first)
        with pytest.raises(OSError):
            take_lock(second)
    with open(path, "w") as third:
        take_lock(third)


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "good.h5"
    with h5py.File(path, "w") as file:
        file["a/b"] = [1.0, 2.0]
    return str(path)


def test_pieces_are_saved_without_fork(path, monkeypatch):
    monkeypatch.delattr("os.fork")
    saved = salvage(path, [("b", dataset("a/b")), ("c", dataset("a/c"))])
    assert saved.found["b"].values.tolist() == [1.0, 2.0]
    assert "c" not in saved.found and saved.lost == {}
