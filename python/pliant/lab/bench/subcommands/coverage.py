# SPDX-License-Identifier: MIT
"""``pliant lab bench coverage``."""

from __future__ import annotations

from pliant.lab.options import PAIRS, WORKERS, counts, names, whole
from pliant.lab.pairs.coverage import coverage as measure

__all__ = ["measure"]


DESCRIPTION = """\
Takes pairs of known structures of one protein. Frames are made from each of the two; does one of
them come near the other? A domain motion is covered by a frame within 3 Angstrom (r.m.s. over
the backbone), a pocket by one within 1.5 (mean distance of the backbone of the pocket, the
rest superposed). Each pair is a subfolder of --data with two files (PDB or mmCIF); pockets have a
local.json with alignment_resid_ranges and metric_resid_ranges. Ensembles: reach, turns and modes
of pliant sample, modes twice as wide, and straight displacements along the modes of ANM and of
our own network, 2.8 Angstrom r.m.s., without repair."""
EPILOG = """\
examples:
  pliant lab bench coverage --data pairs -o coverage.png
  pliant lab bench coverage --data pairs --only reach,ANM --frames 200 --csv coverage.csv"""
PICTURE = ("pliant.lab.pairs.picture", "nearest frames by distance")
OPTIONS = {
    "--data": PAIRS,
    "--only": names("ensembles (default: all)", dest="ensembles"),
    "--frames": counts("200,1000", "frames of each ensemble"),
    "--seed": whole(0, 0, "seed of the ensembles"),
    "--workers": WORKERS,
}
