# SPDX-License-Identifier: MIT
"""What a script still holds when Python ends is nothing to complain of."""

import subprocess
import sys

HOLDS = """
import ctypes, pliant
held = pliant.Guide()
ctypes.pythonapi.Py_IncRef(ctypes.py_object(held))
"""


def test_python_ends_without_a_word():
    ended = subprocess.run(
        [sys.executable, "-c", HOLDS], text=True, capture_output=True, check=False
    )
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "", "")
