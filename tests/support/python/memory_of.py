# SPDX-License-Identifier: MIT
"""How much memory a command takes."""

import subprocess
import sys

#: Runs a command; its last line is the largest memory of any process of it, in kB. A process takes
#: over the largest memory of the one that started it: this is a small one.
MEASURE = """
import resource, subprocess, sys
ended = subprocess.run(sys.argv[1:])
print("\\n", resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, file=sys.stderr)
sys.exit(ended.returncode)
"""


def measured(words, folder):
    """Exit code, what was said, and MB."""
    ended = subprocess.run(
        [sys.executable, "-c", MEASURE, *map(str, words)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=900,
    )
    *said, memory = ended.stderr.split("\n ")
    return ended.returncode, "".join(said).strip(), int(memory) / 1024
