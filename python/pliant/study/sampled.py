# SPDX-License-Identifier: MIT
"""The ensemble of a study: ``pliant sample`` with what it does by default."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import warnings
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant._core import H5mdReader, InputError, Structure, read
from pliant.console import command_path

#: left behind is the whole ensemble, but for frames that could not be made
DONE = (0, 3)
#: residue names of water in the Protein Data Bank and in MD packages
WATERS = frozenset(("HOH", "WAT", "DOD", "H2O", "SOL", "TIP", "TIP3", "SPC"))


@dataclass(frozen=True)
class Sampled:
    """What `pliant sample` did."""

    facts: dict[str, Any]  #: its JSON
    ensemble: Path
    left_out: dict[str, int]  #: residues of the file that the model lacks: how many of each name


def sampled(file: str | os.PathLike[str], folder: Path, options: Sequence[str]) -> Sampled:
    """Samples FILE into folder/ensemble.h5md, replacing what is there.

    In a process of its own, so that frames go to the file one by one, however large the molecule.
    Raises InputError with what `pliant sample` said where it fails.
    """
    ensemble = folder / "ensemble.h5md"
    words = ["sample", os.fspath(file), "-o", str(ensemble), "--overwrite", "--json", *options]
    shown = sys.stderr.isatty()  # its progress bar
    ended = subprocess.run(
        [command_path(), *words], stdout=subprocess.PIPE, stderr=None if shown else subprocess.PIPE
    )
    if ended.returncode not in DONE:
        raise InputError(_last_line(ended.stderr) or "pliant sample failed, as said above")
    facts = json.loads(ended.stdout)
    return Sampled(facts, ensemble, _left_out(file, ensemble))


def _last_line(errors: bytes | None) -> str:
    """What a command said when it failed, without the name of the command."""
    lines = (errors or b"").decode(errors="replace").strip().splitlines()
    return lines[-1].rpartition("error: ")[2] if lines else ""


def _left_out(file: str | os.PathLike[str], ensemble: Path) -> dict[str, int]:
    """Residues of the file that are not in the ensemble, waters under one name."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # `pliant sample` has said what there was to say
        had, has = read(file), H5mdReader(ensemble).structure()
    lacking = Counter(_residues(had)) - Counter(_residues(has))
    names = Counter[str]()
    for (_, _, name), count in lacking.items():
        names["water" if name in WATERS else name] += count
    return dict(names)


def _residues(structure: Structure) -> list[tuple[str, int, str]]:
    """Chain, number and name of each residue."""
    firsts: dict[int, int] = {}
    for atom, residue in enumerate(structure.residue_of):
        firsts.setdefault(int(residue), atom)
    chains, numbers, names = structure.chains, structure.residue_ids, structure.residue_names
    return [(str(chains[k]), int(numbers[k]), str(names[k])) for k in firsts.values()]
