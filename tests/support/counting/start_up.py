# SPDX-License-Identifier: MIT
"""Counts the instructions that it takes to start: by valgrind, so that no other work changes them.

    start_up.py      prints the table, with what is allowed

Instructions of the dynamic linker stand apart: those of `import pliant` look up symbols of thirty
libraries that Debian's HDF5 brings along (curl, Kerberos, GnuTLS), which a wheel does not have. The
command of a build has HDF5 inside (PliantStaticHdf5.cmake).
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from count_instructions import costs

COMMAND = Path(sys.executable).parent / "pliant"
PEPTIDE = Path(__file__).resolve().parents[3] / "data/molecules/peptide_20.pdb"
LINKER = "ld-linux"


class Counts(NamedTuple):
    """Millions of instructions."""

    linking: float  #: in the dynamic linker
    other: float

    def __sub__(self, less: Counts) -> Counts:
        return Counts(self.linking - less.linking, self.other - less.other)


class Start(NamedTuple):
    """One way to start, and the millions of instructions that it may take."""

    name: str
    most: Counts
    count: Callable[[], Counts]


def counted(*words: str | Path) -> Counts:
    """What a command takes from its first instruction to its last."""
    with tempfile.TemporaryDirectory() as name:
        environment = {
            "PATH": os.environ["PATH"],
            "PYTHONHASHSEED": "0",
            "OPENBLAS_NUM_THREADS": "1",  # others would wait in a loop
            "PYTHONPYCACHEPREFIX": str(Path(name) / "compiled"),
        }
        if words[0] == sys.executable:  # once without, to compile the modules
            subprocess.run(words, env=environment, check=True)
        out = Path(name) / "out"
        valgrind = ["valgrind", "--tool=callgrind", "-q", f"--callgrind-out-file={out}"]
        subprocess.run([*valgrind, *words], env=environment, check=True, stdout=subprocess.DEVNULL)
        return split(out.read_text().splitlines())


def split(lines: list[str]) -> Counts:
    """The dynamic linker's share of a dump by callgrind, and the rest."""
    linking = other = 0
    for library, cost in costs(lines):
        if Path(library).name.startswith(LINKER):
            linking += cost
        else:
            other += cost
    return Counts(linking / 1e6, other / 1e6)


def of_import() -> Counts:
    """`import pliant` after `import numpy`: what numpy takes is not ours."""
    script = "import numpy"
    both, numpy = (counted(sys.executable, "-c", script + more) for more in (", pliant", ""))
    return both - numpy


#: A tenth above what was counted with gcc 12, Debian 12 and Python 3.11.
STARTS = (
    Start("pliant --help", Counts(3.07, 0.125), lambda: counted(COMMAND, "--help")),
    Start("pliant info PEPTIDE", Counts(3.13, 6.45), lambda: counted(COMMAND, "info", PEPTIDE)),
    Start("import pliant", Counts(29.2, 78.8), of_import),
)


def findings(start: Start, found: Counts) -> list[str]:
    """Where more was counted than is allowed; and where so much less that the budget is none."""
    said = []
    for what, most, count in zip(Counts._fields, start.most, found, strict=True):
        if count > most:
            said.append(f"{start.name}: {what} takes {count:.3f} million instructions, may {most}")
        elif count < most / 1.2:
            said.append(f"{start.name}: {what} takes {count:.3f} million instructions: allow less")
    return said


def row(start: Start, found: Counts) -> str:
    """A line of the table."""
    cells = [f"{name} {count:.3f} of {most}" for name, count, most in
             zip(Counts._fields, found, start.most, strict=True)]  # fmt: skip
    return f"{start.name}: million instructions {', '.join(cells)}"


def main() -> int:
    """Prints all rows; 1 if one is over its budget."""
    said = []
    for start in STARTS:
        found = start.count()
        print(row(start, found))
        said += findings(start, found)
    print(*said, sep="\n")
    return int(bool(said))


if __name__ == "__main__":
    sys.exit(main())
