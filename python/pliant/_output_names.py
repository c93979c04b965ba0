# SPDX-License-Identifier: MIT
"""What the name of a trajectory to write asks for."""

from __future__ import annotations

import os
from pathlib import Path

from pliant._core import OptionError


def is_pdb_name(output: str | os.PathLike[str]) -> bool:
    """Whether frames become the models of a PDB file."""
    return Path(output).suffix.lower() in (".pdb", ".ent")


def check_trajectory_name(output: str | os.PathLike[str]) -> None:
    """Raises OptionError for names of formats into which trajectories are converted."""
    ending = Path(output).suffix.lower()
    if ending in (".cif", ".dcd", ".mmcif", ".trr", ".xtc", ".xyz"):
        raise OptionError(
            f"output {os.fspath(output)}: trajectories are written as H5MD or PDB; "
            f"pliant convert makes {ending[1:].upper()} of them"
        )
