# SPDX-License-Identifier: MIT
"""What is in files as lines: datasets of H5MD files, keys of JSON, columns of tables, force files.

They are read from files that the installed command makes of a small molecule.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from project import Project

PEPTIDE = "data/molecules/peptide_20.pdb"
MOLECULE = "data/molecules/caffeine.sdf"

#: a name, and the command whose output is read; {out} is a file that it writes
MADE = {
    "sample.h5md": ("sample", PEPTIDE, "--frames", "2", "-o", "{out}"),
    "run.h5md": ("run", PEPTIDE, "--steps", "4", "--every", "2", "-o", "{out}"),
    "run.forces": ("run", MOLECULE, "--steps", "4", "--record-forces", "{out}", "-o", "{more}"),
}
SAID = {
    "sample --json": ("sample", PEPTIDE, "--frames", "2", "-o", "{out}", "--json"),
    "run --json": ("run", PEPTIDE, "--steps", "4", "-o", "{out}", "--json"),
    "info --json": ("info", PEPTIDE, "--json"),
    "rigidity --json": ("rigidity", PEPTIDE, "--json"),
    "contacts --json": ("contacts", PEPTIDE, "--json"),
}


def lines(project: Project) -> list[str]:
    """One line for each dataset with its type and rank, and for each key."""
    found: list[str] = []
    with tempfile.TemporaryDirectory() as name:
        for number, (what, words) in enumerate({**MADE, **SAID}.items()):
            out = Path(name) / f"{number}{Path(what).suffix}"
            out = out if what in MADE else out.with_suffix(".h5md")
            more = Path(name) / f"{number}-more.h5md"
            said = _pliant(project, [word.format(out=out, more=more) for word in words])
            found += [f"{what}: {line}" for line in _read(what, out, said)]
    return sorted(set(found))


def _pliant(project: Project, words: list[str]) -> str:
    command = [str(Path(sys.executable).parent / "pliant"), *words]
    done = subprocess.run(command, cwd=project.root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"pliant {' '.join(words)}: {done.stderr.strip()}")
    return done.stdout


def _read(what: str, out: Path, said: str) -> Iterator[str]:
    if what in SAID:
        return _keys(json.loads(said), "")
    return _datasets(out) if out.suffix == ".h5md" else _heads(out)


def _datasets(path: Path) -> Iterator[str]:
    import h5py

    found: list[str] = []

    def visit(name: str, thing: Any) -> None:
        if isinstance(thing, h5py.Dataset):
            # how long a text is depends on the molecule
            kind = "text" if thing.dtype.kind in "SO" else str(thing.dtype)
            found.append(f"{name} {kind} of rank {thing.ndim}")
        found.extend(f"{name} @{attribute}" for attribute in thing.attrs)

    with h5py.File(path) as file:
        file.visititems(visit)
    return iter(found)


def _keys(value: Any, before: str) -> Iterator[str]:
    if isinstance(value, dict):
        for key, one in value.items():
            yield f"{before}{key}"
            yield from _keys(one, f"{before}{key}.")
    elif isinstance(value, list) and value:
        yield from _keys(value[0], before)


def _heads(path: Path) -> Iterator[str]:
    """The first words of the lines of a text file, each once."""
    for line in path.read_text(encoding="utf-8").splitlines():
        first = line.split(" ")[0] if line.strip() else ""
        if first and not first.lstrip("-").replace(".", "").isdigit():
            yield first


def serves(new: str, old: str) -> bool:
    """What is in a file keeps its name, type and rank."""
    return new == old
