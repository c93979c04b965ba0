# SPDX-License-Identifier: MIT
"""What is said of ligands and of OpenMM's platform, the same for all commands that ask for it."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from pliant.base.checked import Wanted

CHARGES = ("am1-bcc", "gasteiger", "none")
#: that systems with parameters are written for: how they are called, what writes their files, and
#: the endings of a topology and of positions
PROGRAMS: dict[str, tuple[str, tuple[str, ...], tuple[str, str]]] = {
    "openmm": ("OpenMM", ("openmm",), (".xml", ".pdb")),
    "gromacs": ("GROMACS", ("openmm", "parmed"), (".top", ".gro")),
    "amber": ("AMBER", ("openmm", "parmed"), (".prmtop", ".inpcrd")),
}
ONE_OF_CHARGES = Wanted(f"one of {', '.join(CHARGES)}", lambda x: x in CHARGES)


@dataclass(frozen=True)
class ForceFieldOptions:
    """How ligands get parameters, and where OpenMM computes."""

    charges: str = "am1-bcc"  #: of CHARGES; "none": ligands are left out
    ligands: Mapping[str, str] = field(default_factory=dict)  #: SMILES by residue name
    platform: str = "auto"  #: of OpenMM; "auto": the fastest that works


USUAL = ForceFieldOptions()


def add_options(add: Callable[..., Any]) -> None:
    """Adds them by the `add_argument` of a parser or a group."""
    text = "of ligands, which get GAFF2 by AmberTools; none: leave ligands out (default am1-bcc)"
    add("--charges", choices=CHARGES, default="am1-bcc", help=text)
    text = (
        "bond orders, charges and hydrogens of a ligand; may be given again (default: those of "
        "the file, else guessed, which is said)"
    )
    add("--ligand", metavar="NAME=SMILES", type=_name_and_smiles, action="append", help=text)
    text = "of OpenMM: CUDA, HIP, OpenCL, CPU, Reference (default auto: the fastest that works)"
    add("--platform", metavar="NAME", default="auto", help=text)


def taken(arguments: argparse.Namespace) -> dict[str, Any]:
    """What `add_options` added, as arguments of functions."""
    return {
        "charges": arguments.charges,
        "ligands": dict(arguments.ligand or []),
        "platform": arguments.platform,
    }


def _name_and_smiles(text: str) -> tuple[str, str]:
    name, sign, smiles = text.partition("=")
    if not (name and sign and smiles):
        raise argparse.ArgumentTypeError(f"expected NAME=SMILES, found '{text}'")
    return name, smiles
