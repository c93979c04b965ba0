# SPDX-License-Identifier: MIT
"""What the name of a trajectory to write asks for."""

from __future__ import annotations

import os
from pathlib import Path

from pliant._core import OptionError


def start_beside(trajectory: str | os.PathLike[str]) -> Path:
    """The PDB file of names, bonds and the start that the commands write beside a trajectory.

    For x.h5md that is x.pdb; x-topology.pdb where x.pdb is what was sampled.
    """
    path = Path(trajectory)
    named = path.with_name(f"{path.stem}-topology.pdb")
    return named if named.is_file() else path.with_suffix(".pdb")


def is_pdb_name(output: str | os.PathLike[str]) -> bool:
    """Whether frames become the models of a PDB file."""
    return Path(output).suffix.lower() in (".pdb", ".ent")


def check_trajectory_name(output: str | os.PathLike[str], function: str = "") -> None:
    """Raises OptionError for names of formats into which trajectories are converted.

    `function`: that of Python which was called; the message then has its line, not the command's.
    """
    ending = Path(output).suffix.lower()
    if ending in (".cif", ".dcd", ".mmcif", ".trr", ".xtc", ".xyz"):
        other = os.fspath(Path(output).with_suffix(".h5md"))
        line = (
            f'pliant.{function}(..., output="{other}").save("{os.fspath(output)}")'
            if function
            else f"pliant convert {other} -o {os.fspath(output)} makes {ending[1:].upper()} of one"
        )
        raise OptionError(
            f"output {os.fspath(output)}: trajectories are written as H5MD or PDB: {line}"
        )
