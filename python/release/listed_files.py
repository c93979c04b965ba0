# SPDX-License-Identifier: MIT
"""What is in files as lines: datasets of H5MD files, keys of JSON, words of force files.

They are read from files that the installed command makes of a small molecule. What is below
`parameters` of an H5MD file, which --continue reads, is not listed: a later version reads it.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from project import Project

PEPTIDE = "data/molecules/peptide_20.pdb"
MOLECULE = "data/molecules/caffeine.sdf"
GROUPS = ("connectivity/", "observables/", "particles/")

#: commands whose file {out}, or whose JSON, is read
MADE = {
    ("sample", PEPTIDE, "--frames", "2", "-o", "{out}.h5md"): "{out}.h5md",
    ("run", PEPTIDE, "--steps", "4", "-o", "{out}.h5md"): "{out}.h5md",
    ("run", MOLECULE, "--steps", "4", "-o", "{out}.h5md", "--record-forces", "{out}"): "{out}",
    ("sample", PEPTIDE, "--frames", "2", "-o", "{out}.h5md", "--json"): "",
    ("run", PEPTIDE, "--steps", "4", "-o", "{out}.h5md", "--json"): "",
    **{(name, PEPTIDE, "--json"): "" for name in ("info", "rigidity", "contacts")},
}


def lines(project: Project) -> list[str]:
    """One line for each dataset with its type and rank, and for each key."""
    found: set[str] = set()
    with tempfile.TemporaryDirectory() as name:
        for number, (words, made) in enumerate(MADE.items()):
            out = f"{name}/{number}"
            said = _pliant(project, [word.format(out=out) for word in words])
            if not made:
                found |= {f"{words[0]} --json: {key}" for key in _keys(json.loads(said), "")}
            elif made.endswith(".h5md"):
                found |= {f"h5md: {line}" for line in _datasets(made.format(out=out))}
            else:
                text = Path(made.format(out=out)).read_text(encoding="utf-8")
                found |= {f"forces: {word}" for word in re.findall(r"^[a-z][\w-]*", text, re.M)}
    return sorted(found)


def _pliant(project: Project, words: list[str]) -> str:
    command = [str(Path(sys.executable).parent / "pliant"), *words]
    done = subprocess.run(command, cwd=project.root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"pliant {' '.join(words)}: {done.stderr.strip()}")
    return done.stdout


def _datasets(path: str) -> list[str]:
    import h5py

    found: list[str] = []

    def visit(name: str, thing: Any) -> None:
        if isinstance(thing, h5py.Dataset) and name.startswith(GROUPS):
            # how long a text is depends on the molecule
            kind = "text" if thing.dtype.kind in "SO" else str(thing.dtype)
            unit = thing.attrs.get("unit", b"")
            unit = unit.decode() if isinstance(unit, bytes) else unit
            found.append(f"{name} {kind} of rank {thing.ndim}{unit and f' in {unit}'}")

    with h5py.File(path) as file:
        file.visititems(visit)
    return found


def _keys(value: Any, before: str) -> Iterator[str]:
    """Those of an object, and below; not of counts, whose keys depend on the molecule."""
    if isinstance(value, list) and value:
        yield from _keys(value[0], before)
    elif isinstance(value, dict) and not (
        before and all(type(one) is int for one in value.values())
    ):
        for key, one in value.items():
            yield f"{before}{key}"
            yield from _keys(one, f"{before}{key}.")


def serves(new: str, old: str) -> bool:
    """What is in a file keeps its name, type and rank."""
    return new == old
