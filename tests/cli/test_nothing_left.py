# SPDX-License-Identifier: MIT
"""A command whose input cannot be read leaves nothing: no folder, no file, no half of one."""

import pytest

TWO = """\
ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  ALA A   1       1.460   0.000   0.000  1.00  0.00           C
"""

#: What each command is given; every name is of a file that holds no molecule and no trajectory.
COMMANDS = [
    ("analyse", "bad.h5md"),
    ("analyse", "bad.h5md", "-o", "report"),
    ("analyse", "missing.h5md"),
    ("analyse", "empty.dcd", "--topology", "two.pdb"),
    ("lab", "bench", "step", "bad.pdb"),
    ("check", "bad.pdb"),
    ("check", "--trajectory", "bad.h5md"),
    ("compare", "bad.pdb"),
    ("contacts", "bad.pdb"),
    ("convert", "bad.h5md", "-o", "out.xtc"),
    ("ensemble", "bad.pdb", "-o", "many", "--walkers", "2"),
    ("lab", "experiment", "bad"),
    ("lab", "forcegen", "bad.pdb", "-o", "forces.txt"),
    ("info", "bad.pdb"),
    ("lab", "order", "bad.pdb", "-o", "order.txt"),
    ("path", "bad.pdb", "bad.pdb", "-o", "path.h5md"),
    ("convert", "bad.h5md", "-o", "whole.h5md", "--recover"),
    ("convert", "bad.h5md", "-k", "2", "-o", "shown.pdb"),
    ("rigidity", "bad.pdb", "-o", "rigid"),
    ("rigidity", "bad.pdb", "--page", "rigid.html"),
    ("run", "bad.pdb"),
    ("run", "bad.pdb", "--technique", "nothing"),
    ("sample", "bad.pdb"),
    ("sample", "bad.pdb", "--frames", "0"),
    ("lab", "structgen", "--class", "nothing", "-o", "graphs"),
]


@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_a_command_that_fails_leaves_nothing(pliant, tmp_path, arguments):
    (tmp_path / "bad.pdb").write_text("REMARK no atoms\n")
    (tmp_path / "bad.h5md").write_text("no HDF5\n")
    (tmp_path / "empty.dcd").touch()
    (tmp_path / "two.pdb").write_text(TWO)
    before = sorted(tmp_path.rglob("*"))
    ended = pliant(*arguments)
    assert ended.code in (1, 2)
    assert "Traceback" not in ended.err
    assert "error: " in ended.err
    assert sorted(tmp_path.rglob("*")) == before
