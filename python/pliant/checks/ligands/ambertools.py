# SPDX-License-Identifier: MIT
"""GAFF2 parameters of one molecule by AmberTools: antechamber, sqm, parmchk2 and tleap.

J. Wang et al., J. Comput. Chem. 25 (2004) 1157 (GAFF); A. Jakalian, D. B. Jack, C. I. Bayly,
J. Comput. Chem. 23 (2002) 1623 (AM1-BCC).
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from pliant._core import InputError
from pliant.base.extras import late
from pliant.base.new_file import write_text

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")

PROGRAMS = ("antechamber", "parmchk2", "sqm", "tleap")
REMEDY = 'pip install "pliant[ligands]" (Linux), or conda install -c conda-forge ambertools'
#: ways to make charges, by how antechamber calls them
METHODS = {"am1-bcc": "bcc", "gasteiger": "gas"}
#: of sqm: gradients end at 0.02 kcal/(mol A), 40 times antechamber's: half the time, and charges
#: that differ by 0.001 e
SQM = "qm_theory='AM1',grms_tol=0.02,scfconv=1.d-10,maxcyc=500,ndiis_attempts=700,"
BESIDE = os.path.dirname(sys.executable)  #: where pip installs them
TIME_LIMIT = 1800.0  #: seconds of a program
SAID_EVERY = 15.0  #: seconds

_LEAP = """\
source leaprc.gaff2
loadamberparams ligand.frcmod
m = loadmol2 ligand.mol2
saveamberparm m ligand.prmtop ligand.inpcrd
quit
"""


def programs() -> dict[str, str]:
    """Paths by name, on the PATH or beside this Python. Raises InputError for what is missing."""
    found = {one: shutil.which(one) or shutil.which(one, path=BESIDE) for one in PROGRAMS}
    if missing := [one for one, path in found.items() if path is None]:
        raise InputError(f"AmberTools' {', '.join(missing)} not found: {REMEDY}")
    return {one: str(path) for one, path in found.items()}


@cache
def version(tleap: str) -> str:
    """Of GAFF2, as tleap reads it: "2.2.30, Oct 2025". Raises InputError where it cannot."""
    with tempfile.TemporaryDirectory(prefix="pliant-amber-") as folder:
        write_text(Path(folder, "in"), "source leaprc.gaff2\nquit\n")
        text = _run([tleap, "-f", "in"], Path(folder))
    found = re.search(r"Force Field for organic molecules \(Version ([^)]*)\)", text)
    if found is None:
        raise InputError(f"tleap: expected the version of GAFF2, found {_last_line(text)!r}")
    return found.group(1)


def parametrise(molecule: Mol, charges: str, say: Callable[[str], None]) -> str:
    """The prmtop of a molecule with hydrogens and a conformer, atoms in its order.

    `charges` is a key of METHODS; `say` hears, now and then, how long it takes. Raises InputError
    with the last words of the program that failed.
    """
    paths = programs()
    with tempfile.TemporaryDirectory(prefix="pliant-amber-") as name:
        folder = Path(name)
        Chem.MolToMolFile(molecule, str(folder / "ligand.mol"))
        write_text(folder / "leap.in", _LEAP)
        read = "-i ligand.mol -fi mdl -o ligand.mol2 -fo mol2 -at gaff2 -rn LIG -pf y -dr no"
        net = ["-c", METHODS[charges], "-nc", str(Chem.GetFormalCharge(molecule)), "-ek", SQM]
        wanted: dict[str, list[str]] = {
            "ligand.mol2": [paths["antechamber"], *read.split(), *net],
            "ligand.frcmod": [paths["parmchk2"], *_PARMCHK.split()],
            "ligand.prmtop": [paths["tleap"], "-f", "leap.in"],
        }
        for file, command in wanted.items():
            text = _run(command, folder, say)
            if not (folder / file).is_file() or not (folder / file).stat().st_size:
                raise InputError(f"{Path(command[0]).name}: {_reason(text)}")
        return (folder / "ligand.prmtop").read_text()


_PARMCHK = "-i ligand.mol2 -f mol2 -o ligand.frcmod -s gaff2"


def _run(command: Sequence[str], folder: Path, say: Callable[[str], None] | None = None) -> str:
    """What it prints. Raises InputError where it cannot be begun, fails or takes too long."""
    name = Path(command[0]).name
    place = os.path.dirname(command[0])  # where antechamber looks for sqm
    settings = {**os.environ, "OMP_NUM_THREADS": "1"}
    settings["PATH"] = os.pathsep.join([place, settings.get("PATH", "")])
    with tempfile.TemporaryFile() as output:
        try:
            child = subprocess.Popen(
                [*command], cwd=folder, env=settings, stdout=output, stderr=subprocess.STDOUT
            )
        except OSError as error:
            raise InputError(f"{command[0]}: {error.strerror}") from None
        try:
            _wait(child, name, say or (lambda _: None))
        finally:
            child.kill()
            child.wait()
        output.seek(0)
        text = output.read().decode("utf-8", "replace")
    if child.returncode:
        raise InputError(f"{name}: exit code {child.returncode}: {_reason(text)}")
    return text


def _wait(child: subprocess.Popen[bytes], name: str, say: Callable[[str], None]) -> None:
    began = time.monotonic()
    while True:
        try:
            child.wait(SAID_EVERY)
            return
        except subprocess.TimeoutExpired:
            passed = time.monotonic() - began
        if passed > TIME_LIMIT:
            raise InputError(f"{name}: took more than {TIME_LIMIT:g} s")
        say(f"{name}: {passed:.0f} s")


def _reason(text: str) -> str:
    """The line that says what is wrong: the first error of several, else the last one."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    wrong = [k for k, line in enumerate(lines) if re.search(r"error|cannot|fatal", line, re.I)]
    if not wrong:
        return _last_line(text)
    return " ".join(lines[wrong[0] : wrong[0] + 2])[:200]


def _last_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[-1].strip()[:200] if lines else "no output"
