# SPDX-License-Identifier: MIT
"""What is promised to be in files: datasets of H5MD files, keys of JSON, words of force files.

They are read from files that the installed command makes of a small molecule. What is below
`parameters` of an H5MD file, which --continue reads, is not listed: a later version reads it.
``python tests/python/trajectory/test_promised_files.py`` writes the list anew.
"""

import difflib
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

ROOT = Path(__file__).parents[3]
LIST = Path(__file__).with_name("promised_files.ref")
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


def lines():
    """One line for each dataset with its type and rank, and for each key."""
    found = set()
    with tempfile.TemporaryDirectory() as name:
        for number, (words, made) in enumerate(MADE.items()):
            out = f"{name}/{number}"
            said = pliant([word.format(out=out) for word in words])
            if not made:
                found |= {f"{words[0]} --json: {key}" for key in keys_of(json.loads(said), "")}
            elif made.endswith(".h5md"):
                found |= {f"h5md: {line}" for line in datasets_of(made.format(out=out))}
            else:
                text = Path(made.format(out=out)).read_text(encoding="utf-8")
                found |= {f"forces: {word}" for word in re.findall(r"^[a-z][\w-]*", text, re.M)}
    return sorted(found)


def pliant(words):
    command = [str(Path(sys.executable).parent / "pliant"), *words]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def datasets_of(path):
    found = []

    def visit(name, thing):
        if isinstance(thing, h5py.Dataset) and name.startswith(GROUPS):
            # how long a text is depends on the molecule
            kind = "text" if thing.dtype.kind in "SO" else str(thing.dtype)
            unit = thing.attrs.get("unit", b"")
            unit = unit.decode() if isinstance(unit, bytes) else unit
            found.append(f"{name} {kind} of rank {thing.ndim}{unit and f' in {unit}'}")

    with h5py.File(path) as file:
        file.visititems(visit)
    return found


def keys_of(value, before):
    """Those of an object, and below; not of counts, whose keys depend on the molecule."""
    if isinstance(value, list) and value:
        yield from keys_of(value[0], before)
    elif isinstance(value, dict) and not (
        before and all(type(one) is int for one in value.values())
    ):
        for key, one in value.items():
            yield f"{before}{key}"
            yield from keys_of(one, f"{before}{key}.")


def test_what_is_in_files_is_as_committed():
    listed = LIST.read_text().splitlines()
    difference = "\n".join(difflib.unified_diff(listed, lines(), "committed", "found", lineterm=""))
    assert not difference, difference


if __name__ == "__main__":
    LIST.write_text("".join(f"{line}\n" for line in lines()))
